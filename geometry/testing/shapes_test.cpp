#include "geometry/testing/shapes.h"

#include <gtest/gtest.h>

#include <set>

#include "geometry/convex_hull.h"

namespace mwt::test {

TEST(ShapesForTests, FamiliesKeepTheirSize) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 20, 100}) {
      const std::vector<Point> points = make_shape(shape, n, 1);
      EXPECT_GE(points.size(), 3U) << shape.name;
      EXPECT_LE(points.size(), n) << shape.name;
      EXPECT_FALSE(all_collinear(points)) << shape.name;
    }
  }
}

TEST(ShapesForTests, AllAreDistinctPointsThatSpanThePlane) {
  std::set<std::string> names;
  for (const Shape& shape : all_shapes()) {
    EXPECT_TRUE(names.insert(shape.name).second) << shape.name;
    EXPECT_FALSE(all_collinear(shape.points)) << shape.name;
    std::set<std::pair<double, double>> seen;
    for (const Point& p : shape.points) EXPECT_TRUE(seen.insert({p.x, p.y}).second) << shape.name;
  }
  EXPECT_GT(names.size(), shapes().size());
}

}  // namespace mwt::test
