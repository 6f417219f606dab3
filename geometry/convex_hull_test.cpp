#include "geometry/convex_hull.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

// CGAL's hull has corners only; they start anywhere, so they are rotated to the lexicographically smallest.
std::vector<Point> cgal_corners(const std::vector<Point>& points) {
  std::vector<CgalPoint> input, hull;
  for (const Point& p : points) input.emplace_back(p.x, p.y);
  CGAL::convex_hull_2(input.begin(), input.end(), std::back_inserter(hull));
  std::vector<Point> corners;
  for (const CgalPoint& p : hull) corners.push_back({p.x(), p.y()});
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), lexicographically_less), corners.end());
  return corners;
}

std::vector<Point> corners_of(const std::vector<Point>& points, const std::vector<Index>& hull) {
  std::vector<Point> corners;
  const std::size_t h = hull.size();
  for (std::size_t i = 0; i < h; ++i) {
    const Point& p = points[hull[i]];
    if (orientation(points[hull[(i + h - 1) % h]], p, points[hull[(i + 1) % h]]) != 0) corners.push_back(p);
  }
  return corners;
}

// Every point that is no corner lies on a hull edge exactly if the hull lists it.
void expect_all_boundary_points(const std::vector<Point>& points, const std::vector<Index>& hull,
                                const std::vector<Point>& corners) {
  for (Index i = 0; i < points.size(); ++i) {
    bool on_boundary = std::ranges::count(corners, points[i]) == 1;
    for (std::size_t c = 0; c < corners.size() && !on_boundary; ++c) {
      on_boundary = in_segment_interior(points[i], corners[c], corners[(c + 1) % corners.size()]);
    }
    ASSERT_EQ(std::ranges::count(hull, i), on_boundary ? 1 : 0) << i;
  }
}

void expect_hulls_agree(const std::vector<Point>& points) {
  const std::vector<Index> hull = monotone_chain(points);
  ASSERT_EQ(graham_scan(points), hull);
  ASSERT_EQ(convex_hull(points), hull);
  ASSERT_EQ(hull.front(), lexicographic_order(points).front());
  const std::vector<Point> corners = cgal_corners(points);
  ASSERT_EQ(corners_of(points, hull), corners);
  expect_all_boundary_points(points, hull, corners);
}

TEST(ConvexHull, BothAgreeWithEachOtherAndWithCgalOnEveryShape) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    ASSERT_FALSE(all_collinear(shape.points));
    expect_hulls_agree(shape.points);
  }
}

// Few places for many points: all kinds of collinear boundaries.
TEST(ConvexHull, BothAgreeWithEachOtherAndWithCgalOnSmallLattices) {
  std::mt19937_64 random(11);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto side = static_cast<int>(2 + random() % 4);
    std::vector<Point> points = test::shuffled(test::full_lattice(side, side), random());
    points.resize(std::min<std::size_t>(points.size(), 3 + random() % 10));
    if (all_collinear(points)) continue;
    SCOPED_TRACE("trial " + std::to_string(trial));
    expect_hulls_agree(points);
  }
}

TEST(ConvexHull, KnownHulls) {
  const std::vector<Point> square{{1, 1}, {0, 0}, {2, 2}, {2, 0}, {0, 2}, {1, 0}, {0, 1}, {2, 1}, {1, 2}};
  EXPECT_EQ(convex_hull(square), (std::vector<Index>{1, 5, 3, 7, 2, 8, 4, 6}));
  EXPECT_EQ(convex_hull(test::circle_points(50)).size(), 50U);
  EXPECT_EQ(convex_hull(test::parallel_rows(2, 20)).size(), 40U);
  EXPECT_EQ(convex_hull(test::triangle_with_points_on_sides(9)).size(), 30U);
  EXPECT_EQ(convex_hull(test::full_lattice(30, 7)).size(), 70U);
}

TEST(ConvexHull, CollinearPointsComeInOrder) {
  const std::vector<Point> points{{2, 2}, {0, 0}, {3, 3}, {1, 1}};
  const std::vector<Index> order{1, 3, 0, 2};
  EXPECT_EQ(monotone_chain(points), order);
  EXPECT_EQ(graham_scan(points), order);
  EXPECT_EQ(monotone_chain(std::vector<Point>{{1, 0}, {0, 0}}), (std::vector<Index>{1, 0}));
  EXPECT_EQ(graham_scan(std::vector<Point>{{1, 0}}), (std::vector<Index>{0}));
  EXPECT_TRUE(monotone_chain({}).empty());
  EXPECT_TRUE(graham_scan({}).empty());
}

TEST(ConvexHull, AllCollinear) {
  EXPECT_TRUE(all_collinear({}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{0, 0}, {1, 5}}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{1, 1}, {1, 1}, {1, 1}}));
  EXPECT_TRUE(all_collinear(std::vector<Point>{{1, 1}, {1, 1}, {2, 2}, {-7, -7}}));
  EXPECT_FALSE(all_collinear(std::vector<Point>{{1, 1}, {1, 1}, {2, 2}, {-7, std::nextafter(-7, 0)}}));
  EXPECT_FALSE(all_collinear(std::vector<Point>{{0, 0}, {5e-324, 0}, {0, 5e-324}}));
}

}  // namespace
}  // namespace mwt
