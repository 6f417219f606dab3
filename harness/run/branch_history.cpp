#include "harness/run/branch_history.h"

#include <algorithm>

namespace mwt {

namespace {

// Measured with the Delaunay triangulation of 100 and 1,000 points: 4,000 numbers leave part of what was recorded,
// 16,000 do no more than 8,000.
constexpr std::size_t kNumbers = 8000;

}  // namespace

void BranchHistory::overwrite() {
  numbers_.resize(kNumbers);
  std::generate(numbers_.begin(), numbers_.end(), [this] { return static_cast<std::uint32_t>(random_()); });
  std::sort(numbers_.begin(), numbers_.end());
}

}  // namespace mwt
