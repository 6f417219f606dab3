#include "algorithms/exact/faces/length_sum_comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "geometry/weight.h"

namespace mwt {
namespace {

// Segments from the origin to (x, y), one for each pair.
struct Segments {
  std::vector<Point> points{{0, 0}};

  std::vector<Edge> add(const std::vector<Point>& ends) {
    std::vector<Edge> edges;
    for (const Point& end : ends) {
      points.push_back(end);
      edges.push_back({0, static_cast<Index>(points.size() - 1)});
    }
    return edges;
  }
};

std::optional<int> compare(const std::vector<Point>& a, const std::vector<Point>& b, const Point& shift = {0, 0},
                           int exponent = 0) {
  Segments segments;
  std::vector<Edge> in_a = segments.add(a);
  std::vector<Edge> in_b = segments.add(b);
  for (Point& p : segments.points) p = {std::scalbn(p.x + shift.x, exponent), std::scalbn(p.y + shift.y, exponent)};
  return compare_length_sums(segments.points, in_a, in_b);
}

void expect_sign(int sign, const std::vector<Point>& a, const std::vector<Point>& b) {
  for (const int exponent : {0, -20, 300, -1000}) {
    SCOPED_TRACE(exponent);
    EXPECT_EQ(compare(a, b, {0, 0}, exponent), sign);
    EXPECT_EQ(compare(b, a, {0, 0}, exponent), -sign);
    EXPECT_EQ(compare(a, b, {1e6, -3e5}, exponent), sign);
  }
}

TEST(LengthSumComparison, EqualLengthsCancel) {
  expect_sign(0, {}, {});
  expect_sign(0, {{3, 4}, {1, 2}}, {{2, 1}, {0, 5}});
  expect_sign(1, {{3, 4}, {1, 2}}, {{2, 1}});
  expect_sign(-1, {{3, 4}, {1, 2}, {1, 1}}, {{-2, 1}, {0, 5}, {2, 0}});
}

TEST(LengthSumComparison, RationalMultiplesOfTheSameRootCancel) {
  expect_sign(0, {{1, 0}, {3, 0}}, {{2, 0}, {0, 2}});
  expect_sign(0, {{1, 1}, {3, 3}}, {{2, 2}, {2, -2}});
  expect_sign(0, {{1, 1}, {3, 3}, {1, 2}, {4, 8}, {10, 0}}, {{2, 2}, {2, -2}, {2, 4}, {3, 6}, {7, 0}, {3, 0}});
}

TEST(LengthSumComparison, DoesNotTakeDifferentRootsForEqual) {
  expect_sign(-1, {{1, 1}, {3, 0}}, {{2, 1}, {1, 2}});
  expect_sign(1, {{1, 1}, {3, 3}, {1, 2}}, {{2, 2}, {2, -2}, {2, 0}});
}

// 1 + 25 + 25 = 49 + 1 + 1: the sums agree up to terms of third order, about 5e-35 of themselves; the root is concave.
TEST(LengthSumComparison, TellsNearTiesApart) {
  const double k = 0x1p30;
  expect_sign(1, {{k, 1}, {k, 5}, {k, 5}}, {{k, 7}, {k, 1}, {k, -1}});
  const double far = 0x1p50;
  expect_sign(1, {{far, 1}, {far, 5}, {far, 5}}, {{far, 7}, {far, 1}, {far, -1}});
}

TEST(LengthSumComparison, HandlesDifferencesThatAreNoDoubles) {
  const std::vector<Point> points{{0x1p60, 0.1}, {0.3, 0x1p-60}, {-0x1p60, -0.1}, {-0.3, -0x1p-60}};
  std::vector<Edge> a{{0, 1}}, b{{2, 3}};
  EXPECT_EQ(compare_length_sums(points, a, b), 0) << "point reflection";
  a = {{0, 1}, {0, 3}};
  b = {{2, 3}, {1, 2}};
  EXPECT_EQ(compare_length_sums(points, a, b), 0);
  a = {{0, 1}};
  b = {{0, 3}};
  EXPECT_EQ(compare_length_sums(points, a, b), -1);
}

TEST(LengthSumComparison, AgreesWithDoubleDoublesWhereTheyDecide) {
  std::mt19937_64 random(5);
  int ties = 0;
  for (int i = 0; i < 2000; ++i) {
    std::vector<Point> ends;
    for (int k = 0; k < 6; ++k)
      ends.push_back({static_cast<double>(random() % 4), 1 + static_cast<double>(random() % 3)});
    const std::vector<Point> a(ends.begin(), ends.begin() + 3), b(ends.begin() + 3, ends.end());
    LengthSum in_a, in_b;
    for (const Point& end : a) in_a.add({0, 0}, end);
    for (const Point& end : b) in_b.add({0, 0}, end);
    const auto sign = compare(a, b);
    ASSERT_TRUE(sign);
    if (in_a.enclosure().upper < in_b.enclosure().lower) {
      EXPECT_EQ(*sign, -1);
    } else if (in_b.enclosure().upper < in_a.enclosure().lower) {
      EXPECT_EQ(*sign, 1);
    } else {
      EXPECT_EQ(*sign, 0) << "sums of three such roots that agree in 53 bits are equal";
      ++ties;
    }
  }
  EXPECT_GT(ties, 0);
}

}  // namespace
}  // namespace mwt
