// JSON values in messages, whatever JSON library has read them.
#pragma once

#include <string>

#include "harness/io/text/text_lines.h"

namespace mwt {

/// A number, a text or the like as it is written. Lists and objects, which may be nested beyond any stack, by their
/// kind only.
template <class Json>
[[nodiscard]] std::string shown_json(const Json& value) {
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  return value.is_object() ? "an object" : shown(value.dump());
}

}  // namespace mwt
