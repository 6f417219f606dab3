#include "algorithms/greedy/ears/certain_ears.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/testing/greedy_testing.h"
#include "generators/registry.h"
#include "geometry/checker.h"
#include "geometry/mesh/edge_order.h"

namespace mwt {

namespace {

struct Taken {
  std::vector<Edge> fixed;
  std::size_t inserted;
  bool finished;
};

Taken take(Points points, const std::vector<Edge>& constraints, const Context& context, const std::string& what) {
  PlanarMesh mesh = test::constrained_mesh(points, constraints);
  const EdgeOrder order(mesh.points(), mesh.labels());
  FixedStars stars(mesh);
  EarInsertion insertion(mesh, stars);
  CertainEars ears({mesh, order, stars, insertion, context});
  const bool finished = ears.take(test::inner_edges(mesh));
  test::expect_constrained_delaunay(mesh, what);
  EXPECT_FALSE(find_violation(points, mesh.triangulation())) << what;
  return {test::fixed_edges(mesh), ears.inserted(), finished};
}

// Returns how many edges were fixed.
std::size_t expect_taken_ears_greedy(Points points, const std::string& what) {
  const std::vector<Edge> greedy = test::greedy_edges(points);
  std::size_t found = 0;
  for (const std::uint64_t one_in : {1000, 3}) {
    const std::vector<Edge> constraints = test::some_of(greedy, one_in, points.size());
    const Taken taken = take(points, constraints, Context{}, what);
    EXPECT_TRUE(std::includes(greedy.begin(), greedy.end(), taken.fixed.begin(), taken.fixed.end())) << what;
    EXPECT_TRUE(taken.finished);
    found += taken.fixed.size() - constraints.size();
  }
  return found;
}

TEST(CertainEars, AreGreedy) { EXPECT_GT(test::sum_over_instances(6, 60, expect_taken_ears_greedy), 1000U); }

// In convex position every edge is an ear of what the shorter ones leave.
TEST(CertainEars, AreNearlyAllEdgesInConvexPosition) {
  const std::vector<Point> points = generate("convex_position", 3000, 1, {});
  EXPECT_GT(take(points, {}, Context{}, "convex position").fixed.size(), std::size_t{2 * 3000 - 3} * 9 / 10);
}

TEST(CertainEars, StopAtTheDeadline) {
  const std::vector<Point> points = generate("ellipse", 20'000, 1, {});
  Context context;
  context.deadline = Context::Clock::now();
  EXPECT_FALSE(take(points, {}, context, "ellipse").finished);
}

}  // namespace

}  // namespace mwt
