// What an interrupted execution throws.
#pragma once

#include <stdexcept>

#include "algorithms/deadline.h"

namespace mwt {

/// The caller's interrupt ended the work; there is no result.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

inline void throw_if_interrupted(const Deadline& deadline) {
  if (is_interrupted(deadline)) throw Interrupted();
}

}  // namespace mwt
