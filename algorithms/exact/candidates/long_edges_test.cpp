#include "algorithms/exact/candidates/long_edges.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

using stage_testing::edges_in;
using stage_testing::instances_of_all_families;

// Which triangles hold a point, in long double; `surely` with a smaller angle, by far more than it and doubles err.
struct Definition {
  bool excluded = false;
  bool surely_excluded = false;
};

Definition by_definition(Points points, Index p, Index q) {
  const long double tangent = std::tan(std::numbers::pi_v<long double> / 4.6L);
  const auto difference = [](double a, double b) { return static_cast<long double>(a) - b; };
  const long double ex = difference(points[q].x, points[p].x), ey = difference(points[q].y, points[p].y);
  Definition result;
  bool left = false, right = false, surely_left = false, surely_right = false;
  for (const Point& r : points) {
    if (in_segment_interior(r, points[p], points[q])) return {true, true};
    const int side = orientation(points[p], points[q], r);
    const long double x = difference(r.x, points[p].x), y = difference(r.y, points[p].y);
    const long double along = ex * x + ey * y;
    const long double rest = -(ex * difference(r.x, points[q].x) + ey * difference(r.y, points[q].y));
    const long double height = std::abs(ex * y - ey * x);
    const bool is_inside = height < tangent * std::min(along, rest);
    const bool is_surely_inside = height < 0.8135L * std::min(along, rest);
    left |= side > 0 && is_inside;
    right |= side < 0 && is_inside;
    surely_left |= side > 0 && is_surely_inside;
    surely_right |= side < 0 && is_surely_inside;
  }
  return {left && right, surely_left && surely_right};
}

// The leaf of each point.
std::vector<std::uint32_t> leaves_of(const KdOrder& order) {
  std::vector<std::uint32_t> leaf_of(order.points.size());
  for (std::uint32_t leaf = order.leaf_count; leaf < 2 * order.leaf_count; ++leaf) {
    for (Index i = order.first_of(leaf); i < order.last_of(leaf); ++i) leaf_of[i] = leaf;
  }
  return leaf_of;
}

void expect_definition(Points points) {
  const KdOrder order = make_kd_order(points);
  const std::vector<std::uint32_t> leaf_of = leaves_of(order);
  LongEdgeTest test(order);
  std::mt19937_64 random(7);
  for (int i = 0; i < 400; ++i) {
    const auto p = static_cast<Index>(random() % points.size()), q = static_cast<Index>(random() % points.size());
    if (p == q) continue;
    test.start(leaf_of[p], leaf_of[q]);
    const bool is_excluded = test.is_excluded(p, q);
    const Definition definition = by_definition(order.points, p, q);
    ASSERT_EQ(is_excluded, test.is_excluded_by_any(p, q)) << p << ' ' << q;
    if (is_excluded) {
      ASSERT_TRUE(definition.excluded) << p << ' ' << q;
    } else {
      ASSERT_FALSE(definition.surely_excluded) << p << ' ' << q;
    }
  }
}

TEST(LongEdges, AreExcludedByDefinition) {
  for (const auto& [name, points] : instances_of_all_families({5, 20, 100, 700})) {
    SCOPED_TRACE(name);
    expect_definition(points);
    if (HasFatalFailure()) return;
  }
}

TEST(LongEdges, AreExcludedAtAllScales) {
  for (const double scale : {0x1p-990, 0x1p-400, 0x1p400, 0x1p990}) {
    std::vector<Point> points = generate("spiral", 500, 1);
    for (Point& p : points) p = {p.x * scale, p.y * scale};
    expect_definition(points);
  }
}

// Two nearly equal points are seen from far away: only relative to each other can it be told which side they are on.
TEST(LongEdges, SeeTheSidesOfPointsVeryCloseToAnEnd) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0x1p-60, 0x1p-61}, {0x1p-60, -0x1p-61}, {0.5, 2}, {0.5, -2}};
  const KdOrder order = make_kd_order(points);
  const auto place = [&](Index original) {
    return static_cast<Index>(std::find(order.original.begin(), order.original.end(), original) -
                              order.original.begin());
  };
  EXPECT_TRUE(LongEdgeTest(order).is_excluded_by_any(place(0), place(1)));
  EXPECT_TRUE(LongEdgeTest(order).is_excluded_by_any(place(1), place(0)));
  EXPECT_FALSE(LongEdgeTest(order).is_excluded_by_any(place(2), place(1)));
}

// Edges that leave a curve almost along it cross its short edges. Such strays made one face with hundreds of holes of
// these curves, which no program could solve.
TEST(LongEdges, LeaveACurveInOnePiece) {
  const Solution solution = solve_to_optimality("exact", generate("spiral", 1500, 1));
  EXPECT_EQ(solution.counters.at("faces_with_holes"), 0);
  EXPECT_EQ(solution.counters.at("linear_programs"), 0);
}

// The hull's corners are a million times as far from the tiny polygon as its points are from each other. Edges from
// there along its rim would tie it to the ring around it.
TEST(LongEdges, LeaveATinyPolygonApartFromItsSurroundings) {
  const Solution solution = solve_to_optimality("exact", generate("insertion_trap", 64, 1));
  EXPECT_EQ(solution.counters.at("faces_with_holes"), 0);
}

// The nearest neighbours are too near for floats: they decide nothing, the others do.
TEST(LongEdges, OptimaOverMoreScalesThanFloatsHaveStayTheSame) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Point> points = generate("log_radial", 13, seed, {{"octaves", seed % 2 == 0 ? "160" : "300"}});
    EXPECT_TRUE(
        overlap(*solve_to_optimality("exact", points).optimum, *solve_to_optimality("subset_dp", points).optimum));
  }
}

// Deleting too much would show as a heavier optimum.
TEST(LongEdges, OptimaOverManyScalesStayTheSame) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    for (const auto& points :
         {generate("log_radial", 25, seed, {{"octaves", "40"}}), generate("cluster_in_triangle", 25, seed),
          generate("clustered", 25, seed, {{"sigma", "0.00001"}})}) {
      const Solution solution = solve_to_optimality("exact", points);
      EXPECT_TRUE(overlap(*solution.optimum, *solve_to_optimality("triangle_lp", points).optimum));
    }
  }
}

}  // namespace
}  // namespace mwt
