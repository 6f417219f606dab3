// What the tests of the families share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generators/registry.h"
#include "geometry/error.h"
#include "geometry/point_set.h"

namespace mwt {

/// Content hash of an instance, duplicates removed. Tests compare it with a recorded one: a difference means that the
/// family gives other points than it used to, so that results are no longer comparable with older ones.
inline std::string golden_hash(const std::string& family, Index n, std::uint64_t seed,
                               const std::map<std::string, std::string>& parameters = {}) {
  return instance_id(make_point_set(generate(family, n, seed, parameters), family).points);
}

/// The message with which a family refuses, empty if it does not.
inline std::string refusal(const std::string& family, Index n,
                           const std::map<std::string, std::string>& parameters = {}) {
  try {
    (void)generate(family, n, 1, parameters);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

}  // namespace mwt
