#include "algorithms/polygon_dp/convex_bounds.h"

#include <gtest/gtest.h>

#include "algorithms/polygon_dp/convex_program.h"
#include "algorithms/polygon_dp/testing/convex_polygons.h"
#include "geometry/checker.h"

namespace mwt {
namespace {

using convex_testing::cycle_of;
using convex_testing::polygons;
using convex_testing::weight_of;

struct Comparison {
  double lower_ratio = 0;  // bound over optimum
  double upper_ratio = 0;  // weight of the triangulation over optimum; 0 without one
};

Comparison compare(const std::vector<Point>& vertices, std::size_t reach) {
  const double hull = cycle_length(vertices, cycle_of(vertices)).lower;
  const ConvexChords chords(vertices, static_cast<double>(vertices.size()) * hull);
  ConvexProgram program(chords);
  EXPECT_TRUE(program.run({}));
  const double optimum = weight_of(vertices, program.triangles()).upper;
  const std::optional<ConvexBounds> bounds = bound_convex_polygon(chords, reach, {});
  if (!bounds) {
    ADD_FAILURE();
    return {};
  }
  Comparison result;
  result.lower_ratio = (hull + bounds->diagonals_at_least) / optimum;
  if (!bounds->triangles.empty()) {
    EXPECT_FALSE(find_violation(vertices, {static_cast<Index>(vertices.size()), bounds->triangles}));
    result.upper_ratio = weight_of(vertices, bounds->triangles).lower / optimum;
  }
  return result;
}

TEST(ConvexBounds, EncloseTheOptimum) {
  for (const Index n : {600U, 1025U}) {
    for (const auto& [name, vertices] : polygons(n)) {
      SCOPED_TRACE(name);
      const Comparison found = compare(vertices, 1);
      EXPECT_LE(found.lower_ratio, 1 + 1e-14);
      EXPECT_GT(found.lower_ratio, 0);
      if (found.upper_ratio > 0) {
        EXPECT_GE(found.upper_ratio, 1 - 1e-13);
      }
    }
  }
}

TEST(ConvexBounds, AreNearTheOptimumOfCircles) {
  for (const char* family : {"circle", "convex_position", "integer_circle"}) {
    SCOPED_TRACE(family);
    const std::vector<Point> vertices = convex_testing::hull_cycle(generate(family, 2000, 1));
    const Comparison near = compare(vertices, 1), nearer = compare(vertices, 3);
    EXPECT_GT(near.lower_ratio, 0.95);
    EXPECT_GT(nearer.lower_ratio, 0.99);
    EXPECT_LT(near.upper_ratio, 1.003);
    EXPECT_LT(nearer.upper_ratio, 1.001);
  }
}

TEST(ConvexBounds, StopAtTheDeadline) {
  const std::vector<Point> vertices = convex_testing::hull_cycle(generate("circle", 2000, 1));
  const ConvexChords chords(vertices, 1e4);
  EXPECT_FALSE(bound_convex_polygon(chords, 1, std::chrono::steady_clock::now()));
}

TEST(ConvexBoundsSlow, EncloseTheOptimaOfManyPolygons) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Index n = static_cast<Index>(520 + seed * 37 % 1500);
    for (const char* family : {"convex_position", "integer_circle"}) {
      SCOPED_TRACE(std::string(family) + ' ' + std::to_string(seed));
      std::vector<Point> points = generate(family, n, seed);
      for (Point& p : points) p.y *= seed % 3 == 0 ? 0.01 : 1;
      const Comparison found = compare(convex_testing::hull_cycle(points), 1);
      EXPECT_LE(found.lower_ratio, 1 + 1e-14);
      EXPECT_GE(found.upper_ratio, 1 - 1e-13);
    }
  }
}

}  // namespace
}  // namespace mwt
