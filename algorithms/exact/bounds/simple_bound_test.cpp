#include "algorithms/exact/bounds/simple_bound.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

TEST(SimpleBound, IsNeverAboveTheOptimum) {
  for (const auto& [name, points] : stage_testing::instances_of_all_families({3, 5, 8, 12}, 3)) {
    SCOPED_TRACE(name);
    const double bound = simple_lower_bound(points);
    EXPECT_GT(bound, 0);
    EXPECT_LE(bound, solve_to_optimality("subset_dp", points).optimum->upper);
  }
}

// An inner point has three edges at least, a hull point two, none shorter than to its nearest neighbour; half of each
// edge counts at either end.
TEST(SimpleBound, IsHalfTheNearestDistancesPerEnd) {
  const std::vector<Point> points = generate("grid", 100, 1);
  EXPECT_NEAR(simple_lower_bound(points), 64 * 1.5 + 36, 1e-9);
}

}  // namespace
}  // namespace mwt
