#include "generators/greedy_corridor/greedy_corridor.h"

#include <gtest/gtest.h>

#include "generators/testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(GreedyCorridor, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("greedy_corridor", 100, 1), "1f4133fff992340136cb5282c0b23267");
  EXPECT_EQ(golden_hash("greedy_corridor", 100, 1, {{"shape", "sharp"}}), "7d7903b4340274b9fe0c04b24226848d");
}

struct Corridor {
  std::vector<Point> left;   // p_0 .. p_{k-1}, v
  std::vector<Point> right;  // w_0 .. w_m
};

Corridor corridor_with(const CorridorShape& shape, Index n) {
  const Index m = corridor_length(shape, n);
  const std::vector<Point> points = corridor_points(shape, n - 2 - m, m);
  EXPECT_EQ(points.size(), n);
  const auto end_of_left = points.end() - m - 1;
  return {{points.begin(), end_of_left}, {end_of_left, points.end()}};
}

// Whether the chain turns right at every inner point.
bool is_strictly_concave(const std::vector<Point>& chain) {
  for (std::size_t i = 2; i < chain.size(); ++i) {
    if (orientation(chain[i - 2], chain[i - 1], chain[i]) >= 0) return false;
  }
  return true;
}

TEST(GreedyCorridor, chains_are_strictly_convex_and_face_each_other) {
  for (const CorridorShape& shape : {standard_corridor(), sharp_corridor()}) {
    for (const Index n : {5U, 6U, 7U, 8U, 16U, 100U, 1000U, 4096U}) {
      const Corridor corridor = corridor_with(shape, n);
      ASSERT_GE(corridor.left.size(), 3U);
      ASSERT_GE(corridor.right.size(), 2U);
      EXPECT_TRUE(is_strictly_concave(corridor.left)) << n;
      EXPECT_TRUE(is_strictly_concave(corridor.right)) << n;
    }
  }
}

TEST(GreedyCorridor, chains_are_strictly_convex_at_the_largest_n) {
  EXPECT_TRUE(is_strictly_concave(corridor_with(standard_corridor(), kMaxStandardCorridor).left));
  EXPECT_TRUE(is_strictly_concave(corridor_with(standard_corridor(), kMaxStandardCorridor).right));
  EXPECT_TRUE(is_strictly_concave(corridor_with(sharp_corridor(), kMaxSharpCorridor).left));
  EXPECT_TRUE(is_strictly_concave(corridor_with(sharp_corridor(), kMaxSharpCorridor).right));
}

// The trap: greedy prefers v's edges to all that would stop them.
TEST(GreedyCorridor, edges_at_v_are_shorter_than_those_that_cross_them) {
  for (const CorridorShape& shape : {standard_corridor(), sharp_corridor()}) {
    const auto [left, right] = corridor_with(shape, 300);
    const Point& v = left.back();
    for (std::size_t j = 0; j + 1 < right.size(); ++j) {
      for (std::size_t i = 0; i + 1 < left.size(); ++i) {
        EXPECT_LT(compare_length(v, right[j + 1], left[i], right[j]), 0);
        EXPECT_TRUE(segments_cross(v, right[j + 1], left[i], right[j]));
      }
    }
  }
}

// The way out: p_0 sees every w_j and w_0 sees every p_i.
TEST(GreedyCorridor, the_short_edges_of_the_optimum_cross_no_chain) {
  for (const CorridorShape& shape : {standard_corridor(), sharp_corridor()}) {
    const auto [left, right] = corridor_with(shape, 100);
    for (std::size_t i = 0; i + 1 < left.size(); ++i) {
      for (const Point& p : left) {
        for (const Point& w : right) {
          const bool is_path_edge = p == left.front() || w == right.front();
          EXPECT_FALSE(is_path_edge && segments_cross(p, w, left[i], left[i + 1]));
        }
      }
    }
  }
}

TEST(GreedyCorridor, lengths_are_as_derived) {
  EXPECT_EQ(corridor_length(standard_corridor(), 5), 1U);
  EXPECT_EQ(corridor_length(standard_corridor(), 1024), 49U);
  EXPECT_NE(refusal("greedy_corridor", 150'001, {{"shape", "sharp"}}).find("nearest legal n is 150000"),
            std::string::npos);
}

}  // namespace
}  // namespace mwt
