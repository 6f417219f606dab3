#include "geometry/point_set.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "base/testing/test_folder.h"

namespace mwt {
namespace {

using test::message_of;

std::string error(const std::vector<Point>& input) {
  return message_of<InputError>([&] { static_cast<void>(make_point_set(input, "points.txt")); });
}

TEST(PointSet, KeepsTheFirstOfEqualPoints) {
  const PointSet set = make_point_set({{1, 1}, {0, 0}, {1, 1}, {2, 0}, {0, 0}, {1, 1}, {0, 3}}, "input");
  EXPECT_EQ(set.points, (std::vector<Point>{{1, 1}, {0, 0}, {2, 0}, {0, 3}}));
  EXPECT_EQ(set.input_indices, (std::vector<Index>{0, 1, 3, 6}));
  EXPECT_EQ(set.input_count, 7U);
  EXPECT_EQ(set.duplicates(), 3U);
}

TEST(PointSet, MinusZeroIsZero) {
  const PointSet set = make_point_set({{-0.0, 0}, {0, -0.0}, {1, -0.0}, {0, 1}}, "input");
  EXPECT_EQ(set.duplicates(), 1U);
  EXPECT_FALSE(std::signbit(set.points[0].x));
  EXPECT_FALSE(std::signbit(set.points[1].y));
  EXPECT_EQ(instance_id(set.points), instance_id(make_point_set({{0, 0}, {1, 0}, {0, 1}}, "input").points));
}

TEST(PointSet, RejectsWhatCannotBeTriangulated) {
  EXPECT_EQ(error({}), "points.txt: 0 distinct points; a triangulation needs at least 3");
  EXPECT_EQ(error({{0, 0}, {1, 1}}), "points.txt: 2 distinct points; a triangulation needs at least 3");
  EXPECT_EQ(error({{1, 2}, {1, 2}, {1, 2}, {1, 2}}), "points.txt: 1 distinct points; a triangulation needs at least 3");
  EXPECT_EQ(error({{0, 0}, {1, 1}, {0, 0}, {1, 1}}), "points.txt: 2 distinct points; a triangulation needs at least 3");
  const std::string on_a_line = "points.txt: all points lie on one line; a triangulation needs a point off it";
  EXPECT_EQ(error({{0, 0}, {1, 1}, {2, 2}}), on_a_line);
  EXPECT_EQ(error({{0, 5}, {0, 1}, {0, 5}, {0, 7}}), on_a_line);
  EXPECT_EQ(error({{-1e300, -1e300}, {0, 0}, {1e300, 1e300}, {5e-324, 5e-324}}), on_a_line);
}

TEST(PointSet, OneDenormalStepOffTheLineIsEnough) {
  EXPECT_EQ(error({{0, 0}, {1, 0}, {2, 5e-324}}), "");
  EXPECT_EQ(error({{-1e300, -1e300}, {0, 5e-324}, {1e300, 1e300}}), "");
}

TEST(PointSet, RejectsCoordinatesThatAreNoNumbersOrTooLarge) {
  EXPECT_EQ(error({{0, 0}, {NAN, 0}, {1, 1}}), "points.txt: point 1 has a coordinate that is not finite");
  EXPECT_EQ(error({{0, 0}, {1, 0}, {1, -HUGE_VAL}}), "points.txt: point 2 has a coordinate that is not finite");
  EXPECT_EQ(error({{0, NAN}, {1, 0}, {1, 1}}), "points.txt: point 0 has a coordinate that is not finite");
  EXPECT_EQ(error({{0, -1.1e300}, {1, 0}, {1, 1}}),
            "points.txt: point 0 has a coordinate beyond 1e300, where sums of lengths overflow; scale the points down");
  EXPECT_EQ(error({{0, 0}, {1e300, 0}, {0, -1e300}}), "");
}

// Expected value: sha256sum of the 80 bytes, computed with coreutils.
TEST(InstanceId, IsTheShaOfLittleEndianCoordinates) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0.1, 0.2}, {-1e300, 5e-324}, {3, 4}};
  EXPECT_EQ(instance_id(points), "0612ddcdec2ad06a883080fdbc8961d2");
}

TEST(InstanceId, DependsOnOrderAndEveryBit) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_NE(instance_id(points), instance_id(std::vector<Point>{{1, 0}, {0, 0}, {0, 1}}));
  EXPECT_NE(instance_id(points), instance_id(std::vector<Point>{{0, 0}, {1, 0}, {5e-324, 1}}));
}

TEST(PointSet, TrianglesTranslateToInputIndicesAndBack) {
  const std::vector<Point> input{{5, 5}, {0, 0}, {5, 5}, {9, 0}, {-0.0, 0}, {0, 9}};
  const PointSet set = make_point_set(input, "input");
  const std::vector<Triangle> triangles{{1, 2, 0}, {2, 3, 0}};
  EXPECT_EQ(to_input_indices(set, triangles), (std::vector<Triangle>{{1, 3, 0}, {3, 5, 0}}));
  const Triangulation back = from_input_indices(set, input, to_input_indices(set, triangles));
  EXPECT_EQ(back.point_count, 4U);
  EXPECT_EQ(back.triangles, triangles);
  // Corners at duplicates mean the kept point; corners beyond the input mean none.
  EXPECT_EQ(from_input_indices(set, input, {{4, 3, 2}}).triangles, (std::vector<Triangle>{{1, 2, 0}}));
  EXPECT_EQ(from_input_indices(set, input, {{6, 3, kNoIndex}}).triangles,
            (std::vector<Triangle>{{kNoIndex, 2, kNoIndex}}));
}

TEST(Point, LexicographicOrder) {
  const std::vector<Point> points{{1, 2}, {0, 9}, {1, -2}, {0, 9}, {-0.0, 3}};
  EXPECT_EQ(lexicographic_order(points), (std::vector<Index>{4, 1, 3, 2, 0}));
  EXPECT_TRUE(lexicographic_order({}).empty());
}

}  // namespace
}  // namespace mwt
