#include "verifier/reductions.h"

#include <gtest/gtest.h>

#include "verifier/diamond.h"
#include "verifier/refused.h"
#include "verifier/triangulation.h"

namespace mwt::verifier {
namespace {

// Reductions of a point set from its diamond candidates.
struct Start {
  explicit Start(std::vector<Point> input)
      : points(std::move(input)),
        tree(points),
        reductions(points, tree, diamond_candidates(points, tree), hull_of(points)) {}

  std::vector<Point> points;
  PointTree tree;
  Reductions reductions;
};

// A kite whose diagonals both pass the diamond test: 0 2 of length 4, 1 3 of length 3.6.
const std::vector<Point> kKite = {{0, 0}, {2, -1.8}, {4, 0}, {2, 1.8}};

// Of this one, only 1 3 passes; it belongs to the beta-skeleton.
const std::vector<Point> kFlatKite = {{0, 0}, {2, -1}, {4, 0}, {2, 1}};

TEST(Reductions, TheLongDiagonalOfAKiteLeaves) {
  Start start(kKite);
  ASSERT_TRUE(start.reductions.candidates().contains(0, 2));
  start.reductions.remove_not_minimal(0, 2);
  EXPECT_FALSE(start.reductions.candidates().contains(0, 2));
  start.reductions.mark_uncrossed(1, 3);
  EXPECT_TRUE(start.reductions.certain().contains(3, 1));
}

TEST(Reductions, TheShortDiagonalOfAKiteStays) {
  Start start(kKite);
  EXPECT_THROW(start.reductions.remove_not_minimal(1, 3), Refused);
  EXPECT_THROW(start.reductions.mark_uncrossed(1, 3), Refused) << "while the long one is there";
  EXPECT_THROW(start.reductions.mark_uncrossed(0, 2), Refused);
}

TEST(Reductions, DiagonalsOfTheSameLengthStay) {
  Start start({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  EXPECT_THROW(start.reductions.remove_not_minimal(0, 2), Refused);
  EXPECT_THROW(start.reductions.remove_not_minimal(1, 3), Refused);
}

// A flip would be shorter, but the quadrilateral is not strictly convex: 1 lies on the segment from 0 to 2.
TEST(Reductions, FlatQuadrilateralsKeepTheirDiagonal) {
  Start start({{0, 0}, {2, 0}, {4, 0}, {2, 3}});
  EXPECT_THROW(start.reductions.remove_not_minimal(1, 3), Refused);
  EXPECT_FALSE(start.reductions.candidates().contains(0, 2)) << "it passes through a point";
}

TEST(Reductions, EdgesOfTheHullAreCertainAndStay) {
  Start start(kKite);
  EXPECT_TRUE(start.reductions.certain().contains(0, 1));
  EXPECT_THROW(start.reductions.remove_not_minimal(0, 1), Refused);
}

TEST(Reductions, EdgesThroughPointsAreNeverCertain) {
  const std::vector<Point> points = {{0, 0}, {2, 0}, {4, 0}, {2, 3}, {2, -3}};
  const PointTree tree(points);
  EdgeSet candidates(points.size());
  candidates.insert(0, 2);  // as if the diamond test had overlooked point 1
  Reductions reductions(points, tree, candidates, hull_of(points));
  EXPECT_THROW(reductions.mark_uncrossed(0, 2), Refused);
}

// The triangle 0 1 4 holds point 5, so that only the other triangles count.
TEST(Reductions, TrianglesWithPointsInsideProveNothing) {
  const std::vector<Point> points = {{0, 0}, {10, 0}, {10, 1}, {0, 1}, {5, .6}, {5, .4}};
  Start start(points);
  EXPECT_FALSE(start.tree.is_empty(0, 1, 4));
  EXPECT_TRUE(start.tree.is_empty(0, 1, 5));
}

TEST(Reductions, OnlyWhatCrossesACertainEdgeLeavesForIt) {
  const PointTree tree(kFlatKite);
  EdgeSet candidates(kFlatKite.size());
  candidates.insert(0, 2);
  Reductions reductions(kFlatKite, tree, candidates, hull_of(kFlatKite));
  EXPECT_THROW(reductions.remove_crossing(0, 2, 1, 3), Refused) << "1 3 is not certain yet";
  reductions.mark_beta_skeleton(1, 3);
  EXPECT_THROW(reductions.remove_crossing(0, 1, 1, 3), Refused) << "on the hull, and does not cross";
  reductions.remove_crossing(0, 2, 1, 3);
  EXPECT_FALSE(reductions.candidates().contains(0, 2));
}

// Points on the edge's bisector see it at 2 atan(1 / height); arcsin(1 / 1.17682) is reached at height 1.7966.
TEST(Reductions, TheBetaSkeletonEndsAtItsAngle) {
  const auto is_in = [](double height) {
    Start start({{-1, 0}, {1, 0}, {0, height}, {0, -height}});
    try {
      start.reductions.mark_beta_skeleton(0, 1);
      return true;
    } catch (const Refused&) {
      return false;
    }
  };
  EXPECT_TRUE(is_in(1.80));
  EXPECT_FALSE(is_in(1.79));
  EXPECT_FALSE(is_in(0.1));
}

TEST(Reductions, APointOnAnEdgeSeesItAtTheLargestAngle) {
  Start start({{-1, 0}, {1, 0}, {0, 0}, {0, 9}});
  EXPECT_THROW(start.reductions.mark_beta_skeleton(0, 1), Refused);
}

TEST(Hull, HasAllPointsOnItsBoundaryInOrder) {
  const std::vector<Point> points = {{1, 1}, {0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 1}, {2, 1}, {1, 2}};
  EXPECT_EQ(hull_of(points), (std::vector<Index>{1, 3, 2, 7, 4, 8, 5, 6}));
  EXPECT_TRUE(hull_of(std::vector<Point>{{0, 0}, {1, 1}, {2, 2}}).empty());
  EXPECT_EQ(hull_of(std::vector<Point>{{0, 0}, {0, 1}, {0, 2}, {1, 1}}), (std::vector<Index>{0, 3, 2, 1}));
}

TEST(Triangulation, IsCheckedInEveryRespect) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}};
  const std::vector<Index> hull = hull_of(points);
  const std::vector<Corners> good = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  EXPECT_NO_THROW(check_triangulation(points, hull, good));
  EXPECT_DOUBLE_EQ(lower_double(weight_of(points, good, hull)), 16 + 2 * std::sqrt(5.0) + 2 * std::sqrt(13.0));
  const auto is_refused = [&](const std::vector<Corners>& triangles) {
    EXPECT_THROW(check_triangulation(points, hull, triangles), Refused);
  };
  is_refused({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}});
  is_refused({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 4}});
  is_refused({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {2, 3, 4}});
  is_refused({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 5}});
  is_refused({{0, 1, 2}, {0, 2, 3}, {0, 1, 4}, {3, 0, 4}});
  is_refused({{0, 1, 2}, {0, 2, 3}});
}

}  // namespace
}  // namespace mwt::verifier
