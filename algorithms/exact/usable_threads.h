// How many threads to start.
#pragma once

#include <tbb/info.h>

#include <algorithm>

#include "algorithms/algorithm.h"

namespace mwt {

/// What the context asks for, but no more than there are cores: more would only wait for each other.
[[nodiscard]] inline int usable_threads(const Context& context) {
  return std::clamp(context.threads, 1, tbb::info::default_concurrency());
}

}  // namespace mwt
