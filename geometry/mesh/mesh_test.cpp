#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "geometry/checker.h"
#include "geometry/mesh/delaunay_triangles.h"
#include "geometry/mesh/distance.h"
#include "geometry/mesh/edge_order.h"
#include "geometry/mesh/in_circle.h"
#include "geometry/mesh/planar_mesh.h"
#include "geometry/mesh/radix_sort.h"
#include "geometry/mesh/spatial_order.h"
#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {

namespace {

using test::make_shape;
using test::ShapeFamily;
using test::shapes;

TEST(SpatialOrder, IsAPermutationOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 700, 1);
    std::vector<Index> order = spatial_order(points);
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), points.size()) << shape.name;
    for (Index i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i) << shape.name;
  }
}

TEST(SpatialOrder, FollowsTheHilbertCurve) {
  std::vector<Point> grid;
  for (int i = 0; i < 64; ++i) grid.push_back({static_cast<double>(i % 8), static_cast<double>(i / 8)});
  std::shuffle(grid.begin(), grid.end(), std::mt19937_64(1));
  const std::vector<Index> order = spatial_order(grid);
  for (std::size_t i = 1; i < order.size(); ++i) {
    const Point &p = grid[order[i - 1]], &q = grid[order[i]];
    EXPECT_EQ(std::abs(p.x - q.x) + std::abs(p.y - q.y), 1) << i;  // every step goes to a neighbouring cell
  }
}

TEST(RadixSort, SortsByTheGivenBitsAndIsStable) {
  std::mt19937_64 random(1);
  KeptVector<std::uint64_t> keys, buffer;
  for (int i = 0; i < 5000; ++i) keys.push_back(random() & 0xffffffffffffULL);
  KeptVector<std::uint64_t> expected = keys;
  std::stable_sort(expected.begin(), expected.end(),
                   [](std::uint64_t a, std::uint64_t b) { return (a >> 20 & 0xffff) < (b >> 20 & 0xffff); });
  radix_sort(keys, 20, 36, buffer);
  EXPECT_EQ(keys, expected);
}

TEST(FastInCircle, AgreesWithTheExactPredicate) {
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 200, 2);
    std::mt19937_64 random(3);
    for (int i = 0; i < 500; ++i) {
      const auto any = [&] { return points[random() % points.size()]; };
      Point a = any(), b = any();
      const Point c = any(), d = any();
      if (orientation(a, b, c) == 0) continue;
      if (orientation(a, b, c) < 0) std::swap(a, b);
      ASSERT_EQ(fast_in_circle(a, b, c, d), in_circle(a, b, c, d)) << shape.name;
    }
  }
}

// A coordinate of any magnitude, often one that another point has.
double coordinate_of_any_magnitude(std::mt19937_64& random) {
  const auto exponent = static_cast<int>(random() % 2050) - 1060;
  return std::ldexp(static_cast<double>(random() % 4), exponent);
}

// Differences that scaling rounded to 0 were taken for exact zeros of the integer grid.
TEST(FastInCircle, AgreesWithTheExactPredicateWhereDifferencesSpanAllMagnitudes) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 20'000; ++i) {
    const double x = coordinate_of_any_magnitude(random), y = coordinate_of_any_magnitude(random);
    const auto any = [&] {
      return Point{x * static_cast<double>(random() % 4), y * static_cast<double>(random() % 4)};
    };
    Point a = any(), b = any();
    const Point c = any(), d = any();
    if (orientation(a, b, c) == 0) continue;
    if (orientation(a, b, c) < 0) std::swap(a, b);
    ASSERT_EQ(fast_in_circle(a, b, c, d), in_circle(a, b, c, d)) << x << ' ' << y;
  }
}

// The square of the base of these triangles is denormal, so that it may be far too small.
TEST(Distance, NoSegmentIsSurelyFartherThanItIs) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20'000; ++i) {
    const double distance = std::ldexp(1, static_cast<int>(random() % 600) - 200);
    const double half = std::ldexp(1 + static_cast<double>(random() % 1000), -(500 + static_cast<int>(random() % 60)));
    const double squared = distance * distance * (1 + 1e-9);
    EXPECT_FALSE(is_surely_farther({0, 0}, {distance, -half}, {distance, half}, squared)) << distance << ' ' << half;
    EXPECT_FALSE(is_surely_farther({0, 0}, {distance, half}, {distance, 3 * half}, squared)) << distance;
  }
  EXPECT_TRUE(is_surely_farther({0, 0}, {2, -1}, {2, 1}, 3.9));
}

TEST(DelaunayTriangles, HaveEmptyCirclesAndConsistentTwinsOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 5, 10, 100, 2000}) {
      const std::vector<Point> points = make_shape(shape, n, n);
      KeptVector<Point> with_room(points.begin(), points.end());
      const auto triangles = delaunay_triangles(with_room);
      ASSERT_TRUE(std::ranges::equal(with_room, points)) << shape.name;
      for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          const Side beyond = triangles[t].twins[i];
          ASSERT_EQ(triangles[beyond >> 2].twins[beyond & 3], 4 * t + i) << shape.name;
          ASSERT_EQ(triangles[beyond >> 2].corners[beyond & 3], triangles[t].corners[(i + 1) % 3]) << shape.name;
        }
      }
      const PlanarMesh mesh = PlanarMesh::delaunay(points);
      const auto violation = find_violation(points, mesh.triangulation());
      ASSERT_FALSE(violation) << shape.name << " n=" << n << ": " << violation->message;
      for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {  // locally Delaunay everywhere, hence Delaunay
        if (mesh.is_hull(e)) continue;
        const Halfedge h = 2 * e;
        ASSERT_LE(in_circle(mesh.point(mesh.origin(h)), mesh.point(mesh.target(h)), mesh.point(mesh.apex(h)),
                            mesh.point(mesh.apex(h + 1))),
                  0)
            << shape.name;
      }
    }
  }
}

TEST(PlanarMesh, KeepsItsLinksUnderFlips) {
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 120, 4);
    PlanarMesh mesh = PlanarMesh::delaunay(points);
    std::mt19937_64 random(5);
    for (int i = 0; i < 2000; ++i) {
      const auto e = static_cast<MeshEdge>(random() % mesh.edge_count());
      if (!mesh.is_hull(e) && mesh.is_flippable(e)) mesh.flip(e);
    }
    for (Halfedge h = 0; h < 2 * mesh.edge_count(); ++h) {
      ASSERT_EQ(mesh.previous(mesh.next(h)), h) << shape.name;
      ASSERT_EQ(mesh.origin(mesh.next(h)), mesh.target(h)) << shape.name;
      ASSERT_EQ(mesh.rotate_right(mesh.rotate_left(h)), h) << shape.name;
    }
    const auto violation = find_violation(points, mesh.triangulation());
    EXPECT_FALSE(violation) << shape.name << ": " << violation->message;
  }
}

TEST(PlanarMesh, ReadsWhatItWrites) {
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 60, 6);
    const Triangulation triangulation = PlanarMesh::delaunay(points).triangulation();
    EXPECT_EQ(canonical_triangles(PlanarMesh(points, triangulation).triangulation()),
              canonical_triangles(triangulation))
        << shape.name;
  }
}

TEST(PlanarMesh, IsTheSameForCoordinatesOfExtremeSize) {
  for (const ShapeFamily& shape : shapes()) {
    if (shape.max_n < 300) continue;  // of extreme size already
    const std::vector<Point> points = make_shape(shape, 300, 9);
    const auto triangles = PlanarMesh::delaunay(points).triangulation().triangles;
    for (const double unit : {0x1p900, 0x1p-900}) {
      std::vector<Point> scaled = points;
      for (Point& p : scaled) p = {p.x * unit, p.y * unit};
      const PlanarMesh mesh = PlanarMesh::delaunay(scaled);
      EXPECT_EQ(mesh.triangulation().triangles, triangles) << shape.name << ' ' << unit;
      const Point p = mesh.point(0), original = scaled[mesh.label(0)];
      EXPECT_EQ(p.x * mesh.unit(), original.x) << shape.name;
    }
  }
}

TEST(EdgeOrder, IsTheExactOrderOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 40, 7);
    std::mt19937_64 random(8);
    for (int i = 0; i < 2000; ++i) {
      const auto any = [&] { return static_cast<Index>(random() % points.size()); };
      const Index a = any(), b = any(), c = any(), d = any();
      if (a == b || c == d) continue;
      const Edge one = make_edge(a, b), two = make_edge(c, d);
      const int lengths = compare_length(points[a], points[b], points[c], points[d]);
      const bool expected = lengths < 0 || (lengths == 0 && one < two);
      const EdgeOrder order(points);
      EXPECT_EQ(order.precedes(order.key(a, b), order.key(d, c)), expected) << shape.name;
    }
  }
}

TEST(EdgeOrder, SortsManyEdgesOfOneLengthByLabels) {
  std::vector<Point> points;
  std::vector<Index> labels;
  for (Index i = 0; i < 400; ++i) {
    points.push_back({static_cast<double>(i % 20), static_cast<double>(i / 20)});
    labels.push_back((i * 237) % 400);  // a permutation: 237 and 400 have no common divisor
  }
  const EdgeOrder order(points, labels);
  std::vector<EdgeKey> keys;
  for (Index i = 0; i + 20 < 400; ++i) keys.push_back(order.key(i + 20, i, i));
  order.sort(keys);
  for (std::size_t i = 1; i < keys.size(); ++i) {
    const EdgeKey &before = keys[i - 1], &here = keys[i];
    EXPECT_LT(make_edge(labels[before.a], labels[before.b]), make_edge(labels[here.a], labels[here.b])) << i;
    EXPECT_EQ(here.tag, here.b) << i;
  }
}

}  // namespace

}  // namespace mwt
