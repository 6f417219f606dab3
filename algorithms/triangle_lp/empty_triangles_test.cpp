#include "algorithms/triangle_lp/empty_triangles.h"

#include <gtest/gtest.h>

#include "generators/registry.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

std::vector<Triangle> naive_empty_triangles(Points points) {
  std::vector<Triangle> result;
  const Index n = static_cast<Index>(points.size());
  const auto is_empty = [&](const Triangle& t) {
    for (Index p = 0; p < n; ++p) {
      const bool is_corner = p == t[0] || p == t[1] || p == t[2];
      if (!is_corner && in_closed_triangle(points[p], points[t[0]], points[t[1]], points[t[2]])) return false;
    }
    return true;
  };
  for (Index a = 0; a < n; ++a) {
    for (Index b = a + 1; b < n; ++b) {
      for (Index c = a + 1; c < n; ++c) {
        if (orientation(points[a], points[b], points[c]) > 0 && is_empty({a, b, c})) result.push_back({a, b, c});
      }
    }
  }
  return result;
}

TEST(EmptyTriangles, AreThoseOfTheDefinition) {
  for (const char* family : {"uniform", "integer_uniform", "lattice", "wheel", "near_collinear", "collinear_rows"}) {
    for (const Index n : {4U, 12U, 30U, 70U}) {
      const std::vector<Point> points = generate(family, n, n);
      EXPECT_EQ(empty_triangles(points), naive_empty_triangles(points)) << family << ' ' << n;
    }
  }
}

TEST(EmptyTriangles, AreAllTriplesInConvexPosition) {
  std::vector<Point> points;
  for (int i = 0; i < 70; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i * i)});
  EXPECT_EQ(empty_triangles(points).size(), 70U * 69 * 68 / 6);
}

TEST(EmptyTriangles, HaveNoPointOnASide) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {2, 0}, {1, 2}};
  EXPECT_EQ(empty_triangles(points), (std::vector<Triangle>{{0, 1, 3}, {1, 2, 3}}));
}

}  // namespace
}  // namespace mwt
