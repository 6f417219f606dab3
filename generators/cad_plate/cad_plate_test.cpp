#include "generators/cad_plate/cad_plate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(CadPlate, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("cad_plate", 100, 1), "7ee75a6e04c83ae639b20e89529e1b6d");
  EXPECT_EQ(golden_hash("cad_plate", 200, 2, {{"holes", "7"}, {"outline", "star"}}),
            "dbc393c5c1d1d3190d358eec83c0f49a");
  EXPECT_EQ(golden_hash("cad_plate", 200, 2, {{"holes", "1"}, {"outline", "circle"}}),
            "a14f4511459003cba3c6587430015cf4");
}

TEST(CadPlate, every_point_lies_on_an_outline) {
  const std::vector<Point> points = cad_plate_points(1000, 3, PlateOutline::rectangle, 5);  // 3 columns, 2 rows
  for (const Point& p : points) {
    const bool is_on_rectangle = p.x == 0 || p.x == 6 || p.y == 0 || p.y == 4;
    const double x = std::fmod(p.x, 2) - 1, y = std::fmod(p.y, 2) - 1;
    const double radius = std::hypot(x, y);
    EXPECT_TRUE(is_on_rectangle || (radius > .3 - 1e-12 && radius < .8 + 1e-12)) << p.x << ' ' << p.y;
  }
  for (const Point& corner : {Point{0, 0}, Point{6, 0}, Point{6, 4}, Point{0, 4}}) {
    EXPECT_NE(std::find(points.begin(), points.end(), corner), points.end());
  }
}

TEST(CadPlate, every_outline_has_as_many_points_as_asked_for) {
  for (const PlateOutline outline : {PlateOutline::rectangle, PlateOutline::circle, PlateOutline::star}) {
    for (const Index holes : {0U, 1U, 2U, 5U}) {
      for (const Index n : {39U, 40U, 1000U}) {
        const std::vector<Point> points = cad_plate_points(n, 1, outline, holes);
        EXPECT_EQ(points.size(), n);
        EXPECT_EQ(make_point_set(points, "plate").points.size(), n) << "distinct";
      }
    }
  }
}

TEST(CadPlate, refuses_fewer_points_than_its_outlines_have_corners) {
  EXPECT_NE(refusal("cad_plate", 12, {{"holes", "3"}}), "");
  EXPECT_EQ(refusal("cad_plate", 13, {{"holes", "3"}}), "");
  EXPECT_NE(refusal("cad_plate", 23, {{"holes", "0"}, {"outline", "star"}}), "");
}

TEST(CadPlate, few_points_leave_three_for_every_hole) {
  const std::vector<Point> points = cad_plate_points(4 + 3 * 6, 1, PlateOutline::rectangle, 6);
  for (std::size_t hole = 0; hole < 6; ++hole) {
    const Point centre{2.0 * static_cast<double>(hole % 3) + 1, 2.0 * static_cast<double>(hole / 3) + 1};
    EXPECT_EQ(std::count_if(points.begin(), points.end(),
                            [&](const Point& p) { return std::hypot(p.x - centre.x, p.y - centre.y) < .9; }),
              3);
  }
}

}  // namespace
}  // namespace mwt
