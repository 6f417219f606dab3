#include "geometry/weight.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

// Its own rounding, 2^-330, is nothing beside the enclosures' slack of at least 2^-100.
using Real = boost::multiprecision::cpp_bin_float_100;

Real real_length(const Point& p, const Point& q) {
  const Real dx = Real(p.x) - Real(q.x), dy = Real(p.y) - Real(q.y);
  return sqrt(Real(dx * dx + dy * dy));
}

void expect_enclosed(const Interval& interval, const Real& value) {
  EXPECT_LE(Real(interval.lower), value);
  EXPECT_GE(Real(interval.upper), value);
}

// columns x rows lattice points, every unit square cut by a diagonal.
Triangulation lattice_triangulation(Index columns, Index rows) {
  Triangulation result{columns * rows, {}};
  result.triangles.reserve(2 * (columns - std::size_t{1}) * (rows - std::size_t{1}));
  for (Index x = 0; x + 1 < columns; ++x) {
    for (Index y = 0; y + 1 < rows; ++y) {
      const Index corner = x * rows + y;
      result.triangles.push_back({corner, corner + rows, corner + rows + 1});
      result.triangles.push_back({corner, corner + rows + 1, corner + 1});
    }
  }
  return result;
}

TEST(Weight, OfThreeMillionEdgesIsNarrowAndHoldsTheTrueValue) {
  constexpr Index kSide = 1001;
  const Triangulation triangulation = lattice_triangulation(kSide, kSide);
  const std::vector<Point> points = test::full_lattice(kSide, kSide);
  const Interval sum = weight(points, triangulation);
  expect_enclosed(sum, Real(2 * 1000 * 1001) + Real(1000000) * sqrt(Real(2)));
  EXPECT_LE(sum.relative_width(), 1e-13);
  expect_enclosed(perimeter_sum(points, triangulation), Real(4 * 1000 * 1000) + Real(2000000) * sqrt(Real(2)));
}

TEST(Weight, OfThreeMillionTermsOfAllSizesIsNarrow) {
  std::mt19937_64 random(1);
  LengthSum sum;
  for (int i = 0; i < 3000000; ++i) {
    const double size = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-9 : 1e9;
    sum.add({size * test::random_unit(random), 0.1}, {-size, size * test::random_unit(random)});
  }
  EXPECT_LE(sum.enclosure().relative_width(), 1e-13);
  EXPECT_GT(sum.enclosure().lower, 0);
}

TEST(LengthSum, EnclosesTheTrueSumAtEveryMagnitude) {
  std::mt19937_64 random(2);
  for (const int exponent : {0, -20, 300, 996, -300, -500, -1000, -1020, -1030, -1060, -1074}) {
    SCOPED_TRACE("exponent " + std::to_string(exponent));
    LengthSum sum;
    Real expected = 0;
    for (int i = 0; i < 400; ++i) {
      const auto coordinate = [&] {
        return std::scalbn(static_cast<double>(random() % 16) + test::random_unit(random), exponent);
      };
      const Point p{coordinate(), coordinate()}, q{coordinate(), coordinate()};
      sum.add(p, q);
      expected += real_length(p, q);
      expect_enclosed(sum.enclosure(), expected);
    }
    if (exponent >= -900) {
      EXPECT_LE(sum.enclosure().relative_width(), 1e-15);
    }
  }
}

// Each length is sqrt(2) denormal steps and rounds to one: the errors add up to far more than one step.
TEST(LengthSum, RoundingOfDenormalLengthsAddsUp) {
  LengthSum sum;
  for (int i = 0; i < 1000; ++i) sum.add({0, 0}, {5e-324, 5e-324});
  expect_enclosed(sum.enclosure(), Real(1000) * sqrt(Real(2)) * Real(5e-324));
}

TEST(LengthSum, MixedMagnitudes) {
  std::mt19937_64 random(3);
  LengthSum sum;
  Real expected = 0;
  for (int i = 0; i < 300; ++i) {
    const double size = std::scalbn(1.0, static_cast<int>(random() % 2060) - 1070);
    const Point p{size * test::random_unit(random), -size}, q{size, size * test::random_unit(random)};
    sum.add(p, q);
    expected += real_length(p, q);
    expect_enclosed(sum.enclosure(), expected);
  }
}

TEST(Weight, EnclosesTheTrueValueOnEveryShape) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Triangulation triangulation = delaunay_triangulation(shape.points);
    Real expected = 0;
    for (const Edge& edge : edges_of(triangulation))
      expected += real_length(shape.points[edge.a], shape.points[edge.b]);
    const std::vector<Index> hull = convex_hull(shape.points);
    Real boundary = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      boundary += real_length(shape.points[hull[i]], shape.points[hull[(i + 1) % hull.size()]]);
    }
    expect_enclosed(weight(shape.points, triangulation), expected);
    expect_enclosed(cycle_length(shape.points, hull), boundary);
    expect_enclosed(perimeter_sum(shape.points, triangulation), 2 * expected - boundary);
  }
}

TEST(LengthSum, PartsJoinToTheWhole) {
  const std::vector<Point> points = test::uniform_points(1000, 6);
  LengthSum whole, even, odd;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    whole.add(points[i], points[i + 1]);
    (i % 2 == 0 ? even : odd).add(points[i], points[i + 1]);
  }
  even.add(odd);
  EXPECT_TRUE(overlap(even.enclosure(), whole.enclosure()));
  EXPECT_LE(even.enclosure().relative_width(), 1e-15);
}

TEST(Weight, ExactOnIntegerLengths) {
  const std::vector<Point> points{{0, 0}, {3, 0}, {0, 4}};
  const Triangulation triangle{3, {{0, 1, 2}}};
  EXPECT_TRUE(weight(points, triangle).contains(12));
  EXPECT_LE(weight(points, triangle).relative_width(), 1e-15);
  EXPECT_TRUE(perimeter_sum(points, triangle).contains(12));
  EXPECT_EQ(LengthSum().enclosure(), (Interval{0, 0}));
  EXPECT_TRUE(cycle_length(points, std::vector<Index>{0, 1}).contains(6));
}

}  // namespace
}  // namespace mwt
