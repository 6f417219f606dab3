#include "algorithms/exact/faces/cut_region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

std::vector<Point> convex_points_and_one(std::size_t n, std::uint64_t seed) {
  std::vector<Point> points = generate("circle", static_cast<Index>(n), seed);
  double x = 0, y = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& p = points[(seed + i * points.size() / 3) % points.size()];
    x += p.x / 3;
    y += p.y / 3;
  }
  points.push_back({x, y});
  return points;
}

Interval length_of(Points points, const std::vector<Edge>& edges) {
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

TEST(CutRegion, TheBestOfTheUnavoidableCutsIsTheOptimum) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    const std::vector<Point> points = convex_points_and_one(6 + seed % 5, seed);
    const FaceRegion region = naive::region_of_hull(points);
    if (region.components != 2) continue;  // the point fell on the boundary
    CutRegion cutter(points, region);
    double least = std::numeric_limits<double>::infinity();
    for (const Edge& cut : cutter.unavoidable_cuts()) {
      FaceTriangles found;
      if (cutter.solve(std::span(&cut, 1), {}, found) != PolygonFaceOutcome::solved) continue;
      EXPECT_EQ(found.triangles.size(), region.triangle_count());
      least = std::min(least, found.diagonals.enclosure().upper);
    }
    const Interval boundary = length_of(points, region.boundary);
    const Solution optimum = solve_to_optimality("brute_force", points);
    EXPECT_GE(least + boundary.upper, optimum.optimum->lower);
    EXPECT_NEAR(least + boundary.upper, optimum.optimum->upper, 1e-12 * optimum.optimum->upper);
  }
}

TEST(CutRegion, EveryTriangulationContainsAnUnavoidableCut) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const std::vector<Point> points = convex_points_and_one(7, seed);
    const FaceRegion region = naive::region_of_hull(points);
    if (region.components != 2) continue;
    const std::vector<Edge> cuts = CutRegion(points, region).unavoidable_cuts();
    for (const char* algorithm : {"delaunay", "sweep", "greedy"}) {
      const std::vector<Edge> edges = edges_of(solve_and_check(algorithm, points).triangulation);
      EXPECT_TRUE(std::any_of(cuts.begin(), cuts.end(), [&](const Edge& cut) {
        return std::find(edges.begin(), edges.end(), make_edge(cut.a, cut.b)) != edges.end();
      }));
    }
  }
}

TEST(CutRegion, SaysWhenNoTriangulationContainsTheCut) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 3}};
  FaceRegion region = naive::region_of_hull(points);
  region.candidates = {{0, 4}, {1, 4}, {2, 4}};
  FaceTriangles found;
  CutRegion cutter(points, region);
  const std::vector<Edge> cut{{0, 4}};
  EXPECT_EQ(cutter.solve(cut, {}, found), PolygonFaceOutcome::no_triangulation);
  region.candidates.push_back({3, 4});
  EXPECT_EQ(CutRegion(points, region).solve(cut, {}, found), PolygonFaceOutcome::solved);
  EXPECT_EQ(found.triangles.size(), 4);
}

}  // namespace
}  // namespace mwt
