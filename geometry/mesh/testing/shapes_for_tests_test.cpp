#include "geometry/mesh/testing/shapes_for_tests.h"

#include <gtest/gtest.h>

#include "geometry/convex_hull.h"

namespace mwt::test {

TEST(ShapesForTests, AreWhatTheyPromise) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 20, 100}) {
      const std::vector<Point> points = make_shape(shape, n, 1);
      EXPECT_GE(points.size(), 3U) << shape.name;
      EXPECT_LE(points.size(), n) << shape.name;
      EXPECT_FALSE(all_collinear(points)) << shape.name;
    }
  }
}

}  // namespace mwt::test
