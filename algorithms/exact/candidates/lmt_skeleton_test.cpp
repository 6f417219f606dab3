#include "algorithms/exact/candidates/lmt_skeleton.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algorithms/common/testing/extreme_points.h"
#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/numbers/scaling.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

using stage_testing::diamond_candidates;
using stage_testing::edges_in;
using stage_testing::hull_of;
using stage_testing::instances_of_all_families;
using stage_testing::lmt_skeleton;
using stage_testing::reordered_edges;

void expect_optimum_survives(Points points, const std::string& solver) {
  const KdOrder order = make_kd_order(points);
  const std::set<Edge> survivors = edges_in(lmt_skeleton(order).stars);
  const Triangulation optimum = solve_to_optimality(solver, points).triangulation;
  for (const Edge& edge : reordered_edges(order, optimum)) EXPECT_TRUE(survivors.contains(edge));
}

// Ties do no harm: the edges of every optimum survive.
TEST(LmtSkeleton, ContainsTheOptimum) {
  for (const auto& [name, points] : instances_of_all_families({4, 5, 7, 9, 11, 13}, 4)) {
    SCOPED_TRACE(name);
    expect_optimum_survives(points, "subset_dp");
  }
  for (const auto& [name, points] : instances_of_all_families({30}, 2)) {
    SCOPED_TRACE(name);
    expect_optimum_survives(points, "triangle_lp");
  }
}

// Whether the diamond test excludes pq, in long double, which holds all products here. Where magnitudes differ by more
// than weights can show, several triangulations seem optimal, also some with such edges.
bool is_excluded_by_diamond(Points points, Index p, Index q) {
  const long double tangent = std::tan(std::numbers::pi_v<long double> / 4.6L);
  const auto difference = [](double a, double b) { return static_cast<long double>(a) - b; };
  const long double ex = difference(points[q].x, points[p].x), ey = difference(points[q].y, points[p].y);
  bool left = false, right = false;
  for (const Point& r : points) {
    const long double x = difference(r.x, points[p].x), y = difference(r.y, points[p].y);
    const long double along = ex * x + ey * y;
    const long double rest = ex * difference(points[q].x, r.x) + ey * difference(points[q].y, r.y);
    if (std::abs(ex * y - ey * x) >= tangent * std::min(along, rest)) continue;
    const int side = orientation(points[p], points[q], r);
    left |= side >= 0;
    right |= side <= 0;
  }
  return left && right;
}

// What floats cannot hold decides nothing: optimal edges were deleted where their products underflowed.
TEST(LmtSkeleton, ContainsTheOptimumAtTheLimitsOfFloats) {
  for (std::uint64_t seed = 0; seed < 1600; ++seed) {
    SCOPED_TRACE(seed);
    const auto kind = static_cast<test::ExtremePoints::Kind>(seed % test::ExtremePoints::kKinds);
    const std::vector<Point> points = test::ExtremePoints(seed).draw(kind, 5 + seed % 5);
    if (points.empty()) continue;
    const std::vector<Point> scaled = exactly_scaled(points);
    const KdOrder order = make_kd_order(scaled);
    const std::set<Edge> survivors = edges_in(lmt_skeleton(order).stars);
    const Triangulation optimum = solve_to_optimality("subset_dp", scaled).triangulation;
    for (const Edge& edge : reordered_edges(order, optimum))
      EXPECT_TRUE(survivors.contains(edge) || is_excluded_by_diamond(order.points, edge.a, edge.b));
  }
}

TEST(LmtSkeletonSlow, ContainsTheOptimum) {
  for (const auto& [name, points] : instances_of_all_families({60}, 4)) {
    SCOPED_TRACE(name);
    expect_optimum_survives(points, "triangle_lp");
  }
}

// By definition: of the candidates, those that are locally minimal in a quadrilateral of survivors, with
// exact tests of all points for being inside a triangle. The stage may keep more (its floats are uncertain), never
// fewer.
TEST(LmtSkeleton, KeepsAllLocallyMinimalEdges) {
  for (const auto& [name, points] : instances_of_all_families({10, 20})) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    const std::set<Edge> candidates = edges_in(diamond_candidates(order));
    const std::set<Edge> survivors = edges_in(lmt_skeleton(order).stars);
    EXPECT_TRUE(std::includes(candidates.begin(), candidates.end(), survivors.begin(), survivors.end()));
    if (candidates.size() < naive::possible_edges(order.points).size()) continue;  // the definition has no diamond test
    for (const Edge& edge : naive::LocallyMinimalEdges(order.points).edges()) EXPECT_TRUE(survivors.contains(edge));
  }
}

TEST(LmtSkeleton, DeletesMostOfUniformCandidates) {
  const KdOrder order = make_kd_order(generate("uniform", 20'000, 1));
  const LmtSkeleton skeleton = lmt_skeleton(order);
  const std::size_t candidates = edges_in(diamond_candidates(order)).size();
  const std::size_t survivors = edges_in(skeleton.stars).size();
  EXPECT_EQ(candidates - survivors, skeleton.counters.deleted);
  EXPECT_GE(skeleton.counters.checks, candidates - order.points.size());
  EXPECT_LT(survivors, 4.2 * 20'000);
  EXPECT_GT(survivors, 3 * 20'000 - 1000) << "a triangulation must be among them";
}

// Every edge in both ends' stars, with the vector to the other end; certificates name apexes on either side.
TEST(LmtSkeleton, LeavesConsistentStars) {
  for (const char* family : {"uniform", "clustered", "lattice"}) {
    SCOPED_TRACE(family);
    const KdOrder order = make_kd_order(generate(family, 3000, 1));
    const HullEdges hull = hull_of(order.points);
    const LmtSkeleton skeleton = lmt_skeleton(order);
    const std::vector<Star>& stars = skeleton.stars.stars;
    for (Index v = 0; v < stars.size(); ++v) {
      const Star& star = stars[v];
      const std::set<Index> targets(star.target(), star.target() + star.count);
      ASSERT_EQ(targets.size(), star.count);
      for (std::uint32_t i = 0; i < star.count; ++i) {
        const Index w = star.target()[i];
        const Star& other = stars[w];
        ASSERT_NE(std::find(other.target(), other.target() + other.count, v), other.target() + other.count);
        const double x = order.points[w].x - order.points[v].x, y = order.points[w].y - order.points[v].y;
        ASSERT_EQ(x > 0, star.x()[i] > 0);
        ASSERT_EQ(y > 0, star.y()[i] > 0);
        if (hull.contains(v, w)) continue;
        ASSERT_NE(star.certificate()[i], Star::kNoCertificate);
        const Index left = star.target()[star.certificate()[i] & 0xFFFF];
        const Index right = star.target()[star.certificate()[i] >> 16];
        ASSERT_LT(orientation(order.points[v], order.points[w], order.points[left]) *
                      orientation(order.points[v], order.points[w], order.points[right]),
                  0);
      }
    }
  }
}

TEST(LmtSkeleton, DoesNotDependOnThreads) {
  const KdOrder order = make_kd_order(generate("clustered", 20'000, 3));
  const LmtSkeleton one = lmt_skeleton(order);
  tbb::task_arena arena(3);
  const LmtSkeleton three = arena.execute([&] { return lmt_skeleton(order); });
  EXPECT_EQ(edges_in(one.stars), edges_in(three.stars));
  EXPECT_EQ(one.counters.checks, three.counters.checks);
  EXPECT_EQ(one.counters.deleted, three.counters.deleted);
}

TEST(LmtSkeleton, StopsAtTheDeadline) {
  const KdOrder order = make_kd_order(generate("uniform", 1000, 1));
  Context context;
  context.deadline = Context::Clock::now() - std::chrono::seconds(1);
  DiamondTest test(order);
  EXPECT_THROW((void)find_lmt_skeleton(order, hull_of(order.points), test, context), SearchStopped);
}

}  // namespace
}  // namespace mwt
