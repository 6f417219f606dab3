#include "generators/report_example/report_example.h"

#include <gtest/gtest.h>

#include "generators/testing.h"
#include "geometry/convex_hull.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

TEST(ReportExample, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("report_example", 10, 1), "776bafdf08c7801371a1435089262b99");
}

TEST(ReportExample, three_triples_are_collinear_and_six_points_are_on_the_hull) {
  const std::vector<Point> points = report_example_points();
  const auto at = [&](char name) { return points.at(static_cast<std::size_t>(name - 'A')); };
  EXPECT_EQ(orientation(at('B'), at('H'), at('J')), 0);
  EXPECT_EQ(orientation(at('E'), at('H'), at('I')), 0);
  EXPECT_EQ(orientation(at('F'), at('G'), at('H')), 0);
  EXPECT_EQ(convex_hull(points).size(), 6U);
}

}  // namespace
}  // namespace mwt
