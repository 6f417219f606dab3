#include "algorithms/delaunay/delaunay.h"

#include "algorithms/common/testing/instances.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(Delaunay, IsValidOnAllShapes) { test::expect_valid_on_all_shapes(delaunay_entry(), 1000); }

TEST(Delaunay, CirclesAreEmpty) {
  const std::vector<Point> points = test::lattice_points(60, 5);
  const Solution solution = test::solve_checked(delaunay_entry(), points);
  for (const auto& [a, b, c] : solution.triangulation.triangles) {
    for (const Point& p : points) EXPECT_LE(in_circle(points[a], points[b], points[c], p), 0);
  }
}

}  // namespace
}  // namespace mwt
