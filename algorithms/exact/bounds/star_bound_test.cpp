#include "algorithms/exact/bounds/star_bound.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/candidates/lmt_skeleton.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

TEST(StarBound, IsBelowTheOptimumAndClose) {
  for (const auto& [name, points] : instances_of_all_families({6, 9, 12, 60}, 2)) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    const LmtSkeleton skeleton = stage_testing::lmt_skeleton(order);
    const double bound = bound_by_stars(order.points, stage_testing::hull_of(order.points), skeleton.stars, {});
    const Interval optimum = *solve_to_optimality("exact", points).optimum;
    EXPECT_LE(bound, optimum.upper);
    EXPECT_GE(bound, 0.5 * optimum.lower);
  }
}

}  // namespace
}  // namespace mwt
