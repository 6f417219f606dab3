#include "algorithms/exact/division/certain_division.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/division/beta_skeleton.h"
#include "algorithms/exact/faces/composite_vertices.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

using stage_testing::edges_in;
using stage_testing::instances_of_all_families;
using stage_testing::reordered_edges;

TEST(BetaSkeleton, BelongsToEveryOptimum) {
  for (const auto& [name, points] : instances_of_all_families({5, 8, 11, 13, 30}, 3)) {
    SCOPED_TRACE(name);
    const std::vector<Edge> skeleton = beta_skeleton(points);
    const auto optimum =
        edges_of(solve_to_optimality(points.size() > 13 ? "triangle_lp" : "subset_dp", points).triangulation);
    EXPECT_TRUE(std::includes(optimum.begin(), optimum.end(), skeleton.begin(), skeleton.end()));
  }
}

TEST(BetaSkeleton, IsTheEdgesThatNoPointSeesAtAWideAngle) {
  // An edge between two points that see it at 53 degrees, and one that they see at 90.
  const std::vector<Point> narrow{{0, -1}, {0, 1}, {2, 0}, {-2, 0}}, wide{{0, -1}, {0, 1}, {1, 0}, {-2, 0}};
  EXPECT_EQ(beta_skeleton(narrow), (std::vector<Edge>{{0, 1}}));
  EXPECT_TRUE(beta_skeleton(wide).empty());
}

// Points that are no vertices of the edges may see them too.
TEST(BetaSkeleton, BetweenSomeVerticesIsThatOfAllPoints) {
  for (const auto& [name, points] : instances_of_all_families({5, 8, 30, 200}, 2)) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    std::vector<Index> some;
    for (Index v = 0; v < points.size(); ++v) {
      if (v % 3 != 1) some.push_back(v);
    }
    const std::vector<Edge> all = beta_skeleton(order.points);
    std::vector<Point> own;
    for (const Index v : some) own.push_back(order.points[v]);
    if (all_collinear(own)) continue;
    const std::vector<Index> hull = convex_hull(own);
    const auto is_on_hull = [&](Index v) {
      return std::any_of(hull.begin(), hull.end(), [&](Index h) { return some[h] == v; });
    };
    const std::vector<Edge> between = beta_skeleton_between(order, some);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), between.begin(), between.end()));
    for (const Edge& edge : all) {
      const bool joins_some = edge.a % 3 != 1 && edge.b % 3 != 1;
      if (!joins_some || (is_on_hull(edge.a) && is_on_hull(edge.b))) continue;
      EXPECT_TRUE(std::binary_search(between.begin(), between.end(), edge)) << edge.a << " " << edge.b;
    }
  }
}

// Whatever is deleted, every optimum survives, and the skeleton's edges are certain then.
TEST(CertainDivision, KeepsEveryOptimum) {
  for (const auto& [name, points] : instances_of_all_families({6, 9, 12, 30}, 2)) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    LmtSkeleton skeleton = stage_testing::lmt_skeleton(order);
    const CandidateGraph graph = mark_certain_edges(order.points, skeleton.stars, Context{});
    std::vector<Index> all(points.size());
    std::iota(all.begin(), all.end(), Index{0});
    delete_what_crosses_beta_skeleton(order, all, graph, stage_testing::hull_of(order.points), skeleton.stars,
                                      Context{});
    const std::set<Edge> survivors = edges_in(skeleton.stars);
    const char* solver = points.size() > 13 ? "triangle_lp" : "subset_dp";
    for (const Edge& edge : reordered_edges(order, solve_to_optimality(solver, points).triangulation))
      EXPECT_TRUE(survivors.contains(edge));
    const CandidateGraph divided = mark_certain_edges(order.points, skeleton.stars, Context{});
    for (const Edge& edge : beta_skeleton(order.points)) {
      const auto star = divided.star(edge.a);
      const auto place = std::find(star.begin(), star.end(), edge.b) - star.begin();
      ASSERT_LT(place, std::ssize(star));
      EXPECT_EQ(divided.certain[divided.first[edge.a] + static_cast<std::size_t>(place)], 1);
    }
  }
}

TEST(CertainDivision, DividesAnAnnulus) {
  const KdOrder order = make_kd_order(generate("annulus", 6000, 1));
  LmtSkeleton skeleton = stage_testing::lmt_skeleton(order);
  const CandidateGraph graph = mark_certain_edges(order.points, skeleton.stars, Context{});
  const std::vector<Index> composite = composite_vertices(graph);
  const HullEdges hull = stage_testing::hull_of(order.points);
  EXPECT_GT(delete_what_crosses_beta_skeleton(order, composite, graph, hull, skeleton.stars, Context{}), 0U);
  const CandidateGraph divided = mark_certain_edges(order.points, skeleton.stars, Context{});
  EXPECT_GT(std::count(divided.certain.begin(), divided.certain.end(), 1),
            std::count(graph.certain.begin(), graph.certain.end(), 1));
}

}  // namespace
}  // namespace mwt
