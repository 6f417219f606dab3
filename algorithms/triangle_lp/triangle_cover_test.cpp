#include "algorithms/triangle_lp/triangle_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "algorithms/triangle_lp/cover_model.h"
#include "algorithms/triangle_lp/empty_triangles.h"
#include "generators/registry.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

struct Region {
  std::vector<Point> points;
  std::vector<Triangle> triangles;
  std::vector<Edge> boundary;
  std::size_t triangle_count = 0;

  [[nodiscard]] TriangleCoverProblem problem() const { return {points, triangles, boundary, triangle_count, {}, {}}; }
};

Region whole_hull(std::vector<Point> points) {
  Region region{std::move(points), {}, {}, 0};
  region.triangles = empty_triangles(region.points);
  const std::vector<Index> hull = convex_hull(region.points);
  for (std::size_t i = 0; i < hull.size(); ++i) region.boundary.push_back({hull[i], hull[(i + 1) % hull.size()]});
  region.triangle_count = 2 * region.points.size() - 2 - hull.size();
  return region;
}

// A square with its centre inside.
Region square_with_centre() { return whole_hull({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}}); }

std::vector<Point> regular_wheel(Index spokes) { return generate("wheel", spokes + 1, 1, {{"jitter", "0"}}); }

TEST(TriangleCover, CoversAnIsolatedPoint) {
  const Region region = square_with_centre();
  const TriangleCover cover = lightest_triangle_cover(region.problem());
  EXPECT_TRUE(cover.proved);
  EXPECT_EQ(cover.triangles.size(), 4U);
  EXPECT_NEAR(cover.optimum.middle(), 8 + 4 * std::sqrt(2.0), 1e-12);
}

// The slit from a corner to the centre is in the boundary in both directions and still costs once.
TEST(TriangleCover, CountsASlitOnce) {
  Region region = square_with_centre();
  region.boundary.push_back({0, 4});
  region.boundary.push_back({4, 0});
  const TriangleCover cover = lightest_triangle_cover(region.problem());
  EXPECT_TRUE(cover.proved);
  EXPECT_NEAR(cover.optimum.middle(), 8 + 4 * std::sqrt(2.0), 1e-12);
}

TEST(TriangleCover, IsForcedByASlit) {
  Region region = whole_hull({{0, 0}, {4, 0}, {4, 1}, {0, 2}});
  const double longer = std::sqrt(20.0), rest = 4 + 1 + std::sqrt(17.0) + 2;
  EXPECT_NEAR(lightest_triangle_cover(region.problem()).optimum.middle(), rest + std::sqrt(17.0), 1e-12);
  region.boundary.push_back({1, 3});
  region.boundary.push_back({3, 1});
  EXPECT_NEAR(lightest_triangle_cover(region.problem()).optimum.middle(), rest + longer, 1e-12);
}

// The region between a square and a smaller one inside.
TEST(TriangleCover, CoversARing) {
  Region region = whole_hull({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {2, 2}, {4, 2}, {4, 4}, {2, 4}});
  const std::vector<Edge> hole = {{4, 7}, {7, 6}, {6, 5}, {5, 4}};  // clockwise: the region is on the left
  region.boundary.insert(region.boundary.end(), hole.begin(), hole.end());
  region.triangle_count = 8;
  const TriangleCover cover = lightest_triangle_cover(region.problem());
  EXPECT_TRUE(cover.proved);
  EXPECT_EQ(cover.triangles.size(), 8U);
  EXPECT_NEAR(cover.optimum.middle(), 24 + 8 + 4 * std::sqrt(8.0) + 4 * std::sqrt(20.0), 1e-11);
}

TEST(TriangleCover, SaysWhenThereIsNone) {
  Region region = square_with_centre();
  std::erase(region.triangles, Triangle{0, 1, 4});
  const TriangleCover cover = lightest_triangle_cover(region.problem());
  EXPECT_TRUE(cover.triangles.empty());
  EXPECT_FALSE(cover.proved);
  EXPECT_TRUE(std::isinf(cover.optimum.upper));
  region.triangles.clear();
  EXPECT_TRUE(lightest_triangle_cover(region.problem()).triangles.empty());
}

TEST(TriangleCover, BranchesOnFractionalWheels) {
  std::uint64_t branchings = 0;
  for (Index spokes = 13; spokes <= 25; spokes += 2) {
    const Region region = whole_hull(regular_wheel(spokes));
    const TriangleCover cover = lightest_triangle_cover(region.problem());
    EXPECT_TRUE(cover.proved) << spokes;
    EXPECT_EQ(cover.triangles.size(), region.triangle_count) << spokes;
    branchings += cover.branchings;
  }
  EXPECT_GT(branchings, 0U);
}

TEST(TriangleCover, BoundsTheOptimumWhenItIsLate) {
  const Region region = whole_hull(generate("uniform", 40, 1));
  const Interval optimum = lightest_triangle_cover(region.problem()).optimum;
  TriangleCoverProblem late = region.problem();
  late.deadline = std::chrono::steady_clock::now();
  const TriangleCover cover = lightest_triangle_cover(late);
  EXPECT_EQ(cover.stop_reason, StopReason::deadline);
  EXPECT_FALSE(cover.proved);
  EXPECT_GT(cover.optimum.lower, 0);
  EXPECT_TRUE(overlap(cover.optimum, optimum));
}

TEST(TriangleCover, IsTheSameOnEveryThread) {
  const Region region = whole_hull(generate("uniform", 30, 2));
  const TriangleCover expected = lightest_triangle_cover(region.problem());
  std::vector<TriangleCover> covers(3);
  std::vector<std::thread> threads;
  for (TriangleCover& cover : covers) {
    threads.emplace_back([&] { cover = lightest_triangle_cover(region.problem()); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const TriangleCover& cover : covers) {
    EXPECT_EQ(cover.triangles, expected.triangles);
    EXPECT_EQ(cover.optimum, expected.optimum);
  }
}

// Whatever the dual values, the bound holds.
TEST(CoverModel, BoundsCoversByArbitraryDualValues) {
  const Region region = whole_hull(generate("uniform", 20, 3));
  const double optimum = lightest_triangle_cover(region.problem()).optimum.upper;
  const CoverModel model(region.problem());
  const double unit = std::ldexp(1.0, model.exponent);
  for (int k = 0; k < 50; ++k) {
    CoverDuals duals{std::vector<double>(model.side_cost.size()),
                     std::vector<EdgeDecision>(model.edges.size(), EdgeDecision::open)};
    for (std::uint32_t edge = 0; edge < model.edges.size(); ++edge) {
      const double dual = 0.01 * k * std::sin(edge + k);
      duals.of_side[forward_side(edge)] = model.is_inner(edge) ? dual : std::abs(dual);
      duals.of_side[backward_side(edge)] = model.is_inner(edge) ? -dual : std::abs(dual);
    }
    const CoverPricing pricing = price(model, duals);
    EXPECT_LE(pricing.lower * unit, optimum);
    for (const CoverModel::Column& column : model.columns) {
      EXPECT_GE(reduced_cost(model, duals, column), pricing.worst);
    }
  }
}

}  // namespace
}  // namespace mwt
