// How many threads to start.
#pragma once

#include <tbb/info.h>

#include <algorithm>

#include "algorithms/algorithm.h"

namespace mwt {

/// The context's number of threads, at least 1 and at most the number of cores: more would only compete for them.
[[nodiscard]] inline int usable_threads(const Context& context) {
  return std::clamp(context.threads, 1, tbb::info::default_concurrency());
}

}  // namespace mwt
