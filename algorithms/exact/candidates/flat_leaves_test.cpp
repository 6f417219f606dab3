#include "algorithms/exact/candidates/flat_leaves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

// Whether points lie in both triangles, by the definition in long double, or on the edge.
bool is_excluded(Points points, Index p, Index q) {
  const long double tangent = std::tan(std::numbers::pi_v<long double> / 4.6L);
  const auto difference = [](double a, double b) { return static_cast<long double>(a) - b; };
  const long double ex = difference(points[q].x, points[p].x), ey = difference(points[q].y, points[p].y);
  bool left = false, right = false;
  for (const Point& r : points) {
    if (in_segment_interior(r, points[p], points[q])) return true;
    const long double x = difference(r.x, points[p].x), y = difference(r.y, points[p].y);
    const long double along = ex * x + ey * y, beyond = ex * ex + ey * ey - along;
    if (std::abs(ex * y - ey * x) >= tangent * std::min(along, beyond)) continue;
    const int side = orientation(points[p], points[q], r);
    left |= side > 0;
    right |= side < 0;
  }
  return left && right;
}

struct Counts {
  std::size_t pairs = 0;
  std::size_t excluded = 0;
};

// All pairs of a leaf and a node; of those excluded, every edge.
Counts expect_definition(const KdOrder& order) {
  FlatLeafTest test(order);
  Counts counts;
  for (std::uint32_t leaf = order.leaf_count; leaf < 2 * order.leaf_count; leaf += 3) {
    test.start(leaf, std::numeric_limits<float>::infinity());
    const Index first = order.first_of(leaf), size = order.last_of(leaf) - first;
    for (std::uint32_t node = 1; node < 2 * order.leaf_count; ++node) {
      const std::uint32_t open = test.with_edges_into(node, (1U << size) - 1);
      EXPECT_EQ(open, test.with_edges_into(node, (1U << size) - 1));
      for (Index i = 0; i < size; ++i) {
        ++counts.pairs;
        if ((open >> i & 1U) != 0) continue;
        ++counts.excluded;
        for (Index q = order.first_of(node); q < order.last_of(node); q += 5)
          EXPECT_TRUE(is_excluded(order.points, first + i, q)) << first + i << ' ' << q;
      }
    }
  }
  return counts;
}

TEST(FlatLeaves, ExcludeOnlyWhatTheDiamondTestDoes) {
  for (const char* height : {"1e-14", "1e-9", "1e-6", "1e-3"}) {
    for (const double turn : {0.0, .3, 2.5}) {
      SCOPED_TRACE(height);
      std::vector<Point> points = generate("near_collinear", 700, 1, {{"height", height}});
      for (Point& p : points)
        p = {p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)};
      const Counts counts = expect_definition(make_kd_order(points));
      if (turn == 0 && std::string(height) != "1e-3") {
        EXPECT_GT(counts.excluded, counts.pairs / 8);
      }
    }
  }
}

TEST(FlatLeaves, HoldOnAllFamilies) {
  for (const auto& [name, points] : stage_testing::instances_of_all_families({300})) {
    SCOPED_TRACE(name);
    (void)expect_definition(make_kd_order(points));
  }
}

// Points on a line have none to their left or right.
TEST(FlatLeaves, KeepRowsOfPoints) {
  std::vector<Point> points;
  for (int i = 0; i < 1000; ++i) points.push_back({static_cast<double>(i), i == 500 ? 1.0 : 0.0});
  const Counts counts = expect_definition(make_kd_order(points));
  EXPECT_LT(counts.excluded, counts.pairs / 100);
}

}  // namespace
}  // namespace mwt
