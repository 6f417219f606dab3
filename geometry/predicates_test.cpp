#include "geometry/predicates.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

using Integer = boost::multiprecision::cpp_int;

// x * 2^1074, an integer for every finite double. Signs of homogeneous polynomials do not change by it.
Integer scaled_integer(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<long long>(std::scalbn(std::frexp(x, &exponent), 53));
  const int shift = exponent - 53 + 1074;
  return shift >= 0 ? Integer(mantissa) << shift : Integer(mantissa) / (Integer(1) << -shift);
}

struct ExactPoint {
  Integer x;
  Integer y;
};

ExactPoint exact(const Point& p) { return {scaled_integer(p.x), scaled_integer(p.y)}; }

int exact_orientation(const Point& a, const Point& b, const Point& c) {
  const ExactPoint p = exact(a), q = exact(b), r = exact(c);
  return Integer((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x)).sign();
}

Integer exact_squared_length(const Point& a, const Point& b) {
  const ExactPoint p = exact(a), q = exact(b);
  return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
}

int exact_compare_length(const Point& a, const Point& b, const Point& c, const Point& d) {
  return Integer(exact_squared_length(a, b) - exact_squared_length(c, d)).sign();
}

int exact_dot_sign(const Point& a, const Point& apex, const Point& b) {
  const ExactPoint p = exact(a), q = exact(apex), r = exact(b);
  return Integer((p.x - q.x) * (r.x - q.x) + (p.y - q.y) * (r.y - q.y)).sign();
}

// The lifted determinant relative to d.
int exact_in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  const ExactPoint origin = exact(d);
  Integer x[3], y[3], square[3];
  int i = 0;
  for (const Point& point : {a, b, c}) {
    const ExactPoint p = exact(point);
    x[i] = p.x - origin.x;
    y[i] = p.y - origin.y;
    square[i] = x[i] * x[i] + y[i] * y[i];
    ++i;
  }
  return Integer(square[0] * (x[1] * y[2] - x[2] * y[1]) - square[1] * (x[0] * y[2] - x[2] * y[0]) +
                 square[2] * (x[0] * y[1] - x[1] * y[0]))
      .sign();
}

// Hostile coordinates: small integers, values a few steps from them, random magnitudes over the whole range, extremes.
double hostile_coordinate(std::mt19937_64& random, int lowest_exponent, int highest_exponent) {
  const auto span = static_cast<std::uint64_t>(highest_exponent - lowest_exponent + 1);
  const double sign = random() % 2 == 0 ? 1 : -1;
  switch (random() % 5) {
    case 0: return sign * static_cast<double>(random() % 4);
    case 1: {
      double x = sign * static_cast<double>(random() % 4);
      for (auto steps = random() % 3; steps > 0; --steps) x = std::nextafter(x, 10.0);
      return x;
    }
    case 2: return sign * std::scalbn(1.0, lowest_exponent + static_cast<int>(random() % span));
    case 3:
      return sign * std::scalbn(1.0 + test::random_unit(random), lowest_exponent + static_cast<int>(random() % span));
    default: return 0;
  }
}

struct Range {
  int lowest_exponent;
  int highest_exponent;
};

constexpr Range kRanges[] = {{-3, 3}, {-1074, -1000}, {-560, -520}, {490, 540}, {-1074, 1023}, {980, 1023}};

// Four points, some of them dependent on others so that ties and near-ties occur at every magnitude.
std::vector<Point> hostile_points(std::mt19937_64& random, const Range& range) {
  std::vector<Point> points;
  for (int i = 0; i < 4; ++i) {
    points.push_back({hostile_coordinate(random, range.lowest_exponent, range.highest_exponent),
                      hostile_coordinate(random, range.lowest_exponent, range.highest_exponent)});
  }
  switch (random() % 6) {
    case 0: points[2] = {std::midpoint(points[0].x, points[1].x), std::midpoint(points[0].y, points[1].y)}; break;
    case 1: points[2] = {-points[0].y, points[0].x}; break;
    case 2: points[3] = points[random() % 3]; break;
    case 3:
      points[2] = {points[1].x, points[0].y};
      points[3] = {points[0].x, points[1].y};
      break;
    default: break;
  }
  return points;
}

TEST(Predicates, AgreeWithExactArithmeticOnHostileInput) {
  std::mt19937_64 random(17);
  for (int trial = 0; trial < 12000; ++trial) {
    const Range& range = kRanges[static_cast<std::size_t>(trial) % std::size(kRanges)];
    const std::vector<Point> p = hostile_points(random, range);
    SCOPED_TRACE("trial " + std::to_string(trial));
    ASSERT_EQ(orientation(p[0], p[1], p[2]), exact_orientation(p[0], p[1], p[2]));
    ASSERT_EQ(compare_length(p[0], p[1], p[2], p[3]), exact_compare_length(p[0], p[1], p[2], p[3]));
    ASSERT_EQ(compare_length(p[0], p[1], p[0], p[2]), exact_compare_length(p[0], p[1], p[0], p[2]));
    ASSERT_EQ(dot_sign(p[0], p[1], p[2]), exact_dot_sign(p[0], p[1], p[2]));
    ASSERT_EQ(in_circle(p[0], p[1], p[2], p[3]), exact_in_circle(p[0], p[1], p[2], p[3]));
  }
}

double a_few_steps_from(double x, std::mt19937_64& random) {
  const double towards = random() % 2 == 0 ? -HUGE_VAL : HUGE_VAL;
  for (auto steps = random() % 4; steps > 0; --steps) x = std::nextafter(x, towards);
  return x;
}

// Three points within a few doubles of a tie, with differences that are not exact, at the exponent where it hurts.
struct NearTie {
  Point a;
  Point b;
  Point c;  // on the line ab, or as far from a as b is, or at a right angle, but for rounding and a few steps
};

enum class Tie { collinear, equal_lengths, right_angle };

NearTie near_tie(Tie tie, int exponent, std::mt19937_64& random) {
  const auto coordinate = [&] {
    return std::scalbn(static_cast<double>(random() % 64) + test::random_unit(random), -3);
  };
  const Point a{coordinate(), coordinate()}, b{coordinate(), coordinate()};
  const double t = test::random_unit(random);
  const double dx = b.x - a.x, dy = b.y - a.y;
  Point c;
  switch (tie) {
    case Tie::collinear: c = {a.x + t * dx, a.y + t * dy}; break;
    case Tie::equal_lengths: c = {a.x + 0.6 * dx - 0.8 * dy, a.y + 0.8 * dx + 0.6 * dy}; break;
    case Tie::right_angle: c = {a.x - t * dy, a.y + t * dx}; break;
  }
  const auto placed = [&](const Point& p) {
    return Point{a_few_steps_from(std::scalbn(p.x, exponent), random),
                 a_few_steps_from(std::scalbn(p.y, exponent), random)};
  };
  return {placed(a), placed(b), placed(c)};
}

// Exponents: ordinary; where squares become denormal (2^-537 squared is the smallest double); denormal; huge; where
// products leave the range that filters trust (trusted_range.h).
constexpr int kExponents[] = {0,   -20,  -537, -538, -540, -530, -1030, -1072, 500, 509,
                              990, 1018, -464, -465, -466, -468, -470,  494,   496, 498};

TEST(Predicates, AgreeWithExactArithmeticOnNearTies) {
  std::mt19937_64 random(20);
  for (int trial = 0; trial < 20000; ++trial) {
    const int exponent = kExponents[static_cast<std::size_t>(trial) % std::size(kExponents)];
    SCOPED_TRACE("trial " + std::to_string(trial));
    const NearTie line = near_tie(Tie::collinear, exponent, random);
    ASSERT_EQ(orientation(line.a, line.b, line.c), exact_orientation(line.a, line.b, line.c));
    ASSERT_EQ(orientation(line.c, line.a, line.b), exact_orientation(line.c, line.a, line.b));
    const NearTie lengths = near_tie(Tie::equal_lengths, exponent, random);
    ASSERT_EQ(compare_length(lengths.a, lengths.b, lengths.a, lengths.c),
              exact_compare_length(lengths.a, lengths.b, lengths.a, lengths.c));
    const NearTie corner = near_tie(Tie::right_angle, exponent, random);
    ASSERT_EQ(dot_sign(corner.b, corner.a, corner.c), exact_dot_sign(corner.b, corner.a, corner.c));
  }
}

// The inline filters answer most of the time; here the exact routines behind them are called directly.
TEST(Predicates, ExactFallbacksAgreeWithExactArithmetic) {
  std::mt19937_64 random(18);
  for (int trial = 0; trial < 6000; ++trial) {
    const Range& range = kRanges[static_cast<std::size_t>(trial) % std::size(kRanges)];
    const std::vector<Point> p = hostile_points(random, range);
    SCOPED_TRACE("trial " + std::to_string(trial));
    ASSERT_EQ(detail::orientation_exact(p[0], p[1], p[2]), exact_orientation(p[0], p[1], p[2]));
    ASSERT_EQ(detail::compare_length_exact(p[0], p[1], p[2], p[3]), exact_compare_length(p[0], p[1], p[2], p[3]));
    ASSERT_EQ(detail::dot_sign_exact(p[0], p[1], p[2]), exact_dot_sign(p[0], p[1], p[2]));
  }
}

// Every pair of neighbouring doubles around a point on the line y = x, as in Kettner et al., "Classroom examples of
// robustness problems in geometric computations" (2008).
TEST(Predicates, OrientationOnAGridOfNeighbouringDoubles) {
  const Point a{12, 12}, b{24, 24};
  double x = 0.5;
  for (int i = 0; i < 64; ++i, x = std::nextafter(x, 1.0)) {
    double y = 0.5;
    for (int j = 0; j < 64; ++j, y = std::nextafter(y, 1.0)) {
      ASSERT_EQ(orientation({x, y}, a, b), i == j ? 0 : (i > j ? -1 : 1)) << i << ' ' << j;
    }
  }
}

TEST(Predicates, OrientationIsAntisymmetric) {
  std::mt19937_64 random(19);
  for (int trial = 0; trial < 3000; ++trial) {
    const std::vector<Point> p = hostile_points(random, kRanges[static_cast<std::size_t>(trial) % std::size(kRanges)]);
    const int turn = orientation(p[0], p[1], p[2]);
    ASSERT_EQ(turn, orientation(p[1], p[2], p[0]));
    ASSERT_EQ(turn, orientation(p[2], p[0], p[1]));
    ASSERT_EQ(turn, -orientation(p[1], p[0], p[2]));
  }
}

TEST(Predicates, ProductsThatUnderflowAreStillCompared) {
  const double tiny = 1e-300;
  EXPECT_EQ(orientation({0, 0}, {tiny, 0}, {0, tiny}), 1);
  EXPECT_EQ(orientation({0, 0}, {5e-324, 0}, {5e-324, 5e-324}), 1);
  EXPECT_EQ(orientation({0, 0}, {5e-324, 5e-324}, {1e-323, 1e-323}), 0);
  EXPECT_EQ(compare_length({0, 0}, {tiny, 0}, {0, 0}, {0, 2 * tiny}), -1);
  EXPECT_EQ(compare_length({0, 0}, {5e-324, 0}, {7, 7}, {7, 7}), 1);
  EXPECT_EQ(compare_length({0, 0}, {3 * tiny, 4 * tiny}, {0, 0}, {4 * tiny, 3 * tiny}), 0);
  EXPECT_EQ(dot_sign({tiny, 0}, {0, 0}, {tiny, tiny}), 1);
  EXPECT_EQ(dot_sign({tiny, 0}, {0, 0}, {0, tiny}), 0);
  EXPECT_EQ(dot_sign({tiny, 0}, {0, 0}, {-5e-324, tiny}), -1);
}

TEST(Predicates, ProductsThatOverflowAreStillCompared) {
  const double huge = 1e300;
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {0, 0}), 0);
  EXPECT_EQ(orientation({-huge, -huge}, {huge, huge}, {0, 5e-324}), 1);
  EXPECT_EQ(orientation({-largest, -largest}, {largest, -largest}, {largest, largest}), 1);
  EXPECT_EQ(compare_length({-largest, 0}, {largest, 0}, {0, -largest}, {0, largest}), 0);
  EXPECT_EQ(compare_length({-huge, 0}, {huge, 0}, {0, -huge}, {0, std::nextafter(huge, 0.0)}), 1);
  EXPECT_EQ(dot_sign({huge, 0}, {-huge, 0}, {-huge, huge}), 0);
  EXPECT_EQ(dot_sign({largest, largest}, {-largest, -largest}, {largest, -largest}), 1);
}

// Right angles are exact only in exact arithmetic: (1, e) against (-e, 1) and its neighbours.
TEST(Predicates, DotSignTellsRightAnglesFromTheirNeighbours) {
  const Point apex{0.1, 0.7};
  const Point a{apex.x + 3 * 0x1p-20, apex.y + 4 * 0x1p-20};
  const Point b{apex.x - 4 * 0x1p-20, apex.y + 3 * 0x1p-20};
  for (int i = -2; i <= 2; ++i) {
    Point c = b;
    for (int step = 0; step < std::abs(i); ++step) c.x = std::nextafter(c.x, i > 0 ? 1.0 : -1.0);
    EXPECT_EQ(dot_sign(a, apex, c), exact_dot_sign(a, apex, c)) << i;
  }
}

TEST(Predicates, InCircleOnCocircularLatticePoints) {
  const Point a{5, 0}, b{3, 4}, c{-4, 3};
  EXPECT_EQ(in_circle(a, b, c, {0, -5}), 0);
  EXPECT_EQ(in_circle(a, b, c, {-3, -4}), 0);
  EXPECT_EQ(in_circle(a, b, c, {0, 0}), 1);
  EXPECT_EQ(in_circle(a, b, c, {0, std::nextafter(-5, 0)}), 1);
  EXPECT_EQ(in_circle(a, b, c, {0, std::nextafter(-5, -6)}), -1);
}

TEST(Predicates, SegmentInteriorExcludesEnds) {
  const Point a{0, 0}, b{3, 6};
  EXPECT_TRUE(in_segment_interior({1, 2}, a, b));
  EXPECT_TRUE(in_segment_interior({1, 2}, b, a));
  EXPECT_FALSE(in_segment_interior(a, a, b));
  EXPECT_FALSE(in_segment_interior(b, a, b));
  EXPECT_FALSE(in_segment_interior({4, 8}, a, b));
  EXPECT_FALSE(in_segment_interior({-1, -2}, a, b));
  EXPECT_FALSE(in_segment_interior({1, std::nextafter(2.0, 3.0)}, a, b));
  EXPECT_TRUE(in_segment_interior({0, 1}, {0, 0}, {0, 2}));
  EXPECT_FALSE(in_segment_interior({0, 3}, {0, 0}, {0, 2}));
}

// Whether segments ab and cd cross, from the definition alone, on lattice points: they share a point that is not a
// common end, or they overlap. Parameters along ab and cd are compared as fractions.
bool cross_by_definition(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto cross = [](const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; };
  const auto minus = [](const Point& u, const Point& v) { return Point{u.x - v.x, u.y - v.y}; };
  const Point ab = minus(b, a), cd = minus(d, c), ac = minus(c, a);
  const double determinant = cross(ab, cd);
  if (determinant != 0) {
    const double sign = determinant > 0 ? 1 : -1;
    const double s = sign * cross(ac, cd), t = sign * cross(ac, ab), one = sign * determinant;
    const bool meet = 0 <= s && s <= one && 0 <= t && t <= one;
    const bool at_ends_of_both = (s == 0 || s == one) && (t == 0 || t == one);
    return meet && !at_ends_of_both;
  }
  if (cross(ab, ac) != 0) return false;
  const auto along = [&](const Point& p) { return (p.x - a.x) * ab.x + (p.y - a.y) * ab.y; };
  const double low = std::max(0.0, std::min(along(c), along(d)));
  const double high = std::min(along(b), std::max(along(c), along(d)));
  return low < high;
}

TEST(Predicates, SegmentsCrossOnAllSmallLatticeSegments) {
  const std::vector<Point> lattice = test::full_lattice(3, 4);
  for (const Point& a : lattice) {
    for (const Point& b : lattice) {
      if (a == b) continue;
      for (const Point& c : lattice) {
        for (const Point& d : lattice) {
          if (c == d) continue;
          ASSERT_EQ(segments_cross(a, b, c, d), cross_by_definition(a, b, c, d))
              << '(' << a.x << ',' << a.y << ")(" << b.x << ',' << b.y << ")(" << c.x << ',' << c.y << ")(" << d.x
              << ',' << d.y << ')';
        }
      }
    }
  }
}

TEST(Predicates, ConvexityIsStrict) {
  EXPECT_TRUE(is_strictly_convex({0, 0}, {1, 0}, {1, 1}, {0, 1}));
  EXPECT_FALSE(is_strictly_convex({0, 1}, {1, 1}, {1, 0}, {0, 0}));      // clockwise
  EXPECT_FALSE(is_strictly_convex({0, 0}, {1, 0}, {2, 0}, {0, 1}));      // straight angle
  EXPECT_FALSE(is_strictly_convex({0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}));  // reflex
  EXPECT_FALSE(is_strictly_convex({0, 0}, {1, 1}, {1, 0}, {0, 1}));      // self-crossing
  EXPECT_TRUE(is_strictly_convex({0, 0}, {1, 0}, {2, 5e-324}, {0, 1}));  // by one denormal step
}

TEST(Predicates, ClosedTriangleIncludesItsBoundary) {
  const Point a{0, 0}, b{4, 0}, c{0, 4};
  EXPECT_TRUE(in_closed_triangle({1, 1}, a, b, c));
  EXPECT_TRUE(in_closed_triangle({2, 2}, a, b, c));
  EXPECT_TRUE(in_closed_triangle({0, 1}, a, b, c));
  EXPECT_TRUE(in_closed_triangle(a, a, b, c));
  EXPECT_FALSE(in_closed_triangle({2, std::nextafter(2.0, 3.0)}, a, b, c));
  EXPECT_FALSE(in_closed_triangle({-5e-324, 1}, a, b, c));
}

}  // namespace
}  // namespace mwt
