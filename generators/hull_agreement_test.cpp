// On every family, the hull's corners are those that CGAL finds. (The two methods of geometry/convex_hull.h are
// compared with each other, collinear boundary points included, in registry_test.cpp.)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "generators/testing.h"
#include "geometry/convex_hull.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;

std::vector<Point> sorted(std::vector<Point> points) {
  std::sort(points.begin(), points.end(), lexicographically_less);
  return points;
}

std::vector<Point> corners(const std::vector<Point>& points) {
  const std::vector<Index> hull = convex_hull(points);
  const std::size_t h = hull.size();
  std::vector<Point> result;
  for (std::size_t i = 0; i < h; ++i) {
    const Point& p = points[hull[i]];
    if (orientation(points[hull[(i + h - 1) % h]], p, points[hull[(i + 1) % h]]) > 0) result.push_back(p);
  }
  return sorted(result);
}

std::vector<Point> corners_by_cgal(const std::vector<Point>& points) {
  std::vector<CgalPoint> input, hull;
  for (const Point& p : points) input.emplace_back(p.x, p.y);
  CGAL::convex_hull_2(input.begin(), input.end(), std::back_inserter(hull));
  std::vector<Point> result;
  for (const CgalPoint& p : hull) result.push_back({p.x(), p.y()});
  return sorted(result);
}

TEST(HullAgreement, corners_are_those_of_cgal_on_every_family) {
  for (const GeneratorInfo& family : generators()) {
    for (const Index n : {3U, 4U, 5U, 10U, 12U, 13U, 100U, 1000U}) {
      if (n < family.min_n || n > family.max_n) continue;
      if (family.name == "hunted" && n == 13) continue;  // kept at some sizes only
      const std::vector<Point> points = make_point_set(generate(family.name, n, 1), family.name).points;
      EXPECT_EQ(corners(points), corners_by_cgal(points)) << family.name << " n=" << n;
    }
  }
}

}  // namespace
}  // namespace mwt
