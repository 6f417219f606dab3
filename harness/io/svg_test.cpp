#include "harness/io/svg.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "base/number_text.h"
#include "base/testing/test_folder.h"
#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

using test::TestFolder;

std::string drawn(const SvgPicture& picture) {
  const TestFolder folder;
  write_svg(folder.path("p.svg"), picture);
  return TestFolder::content(folder.path("p.svg"));
}

// The number between `before` and the next quotation mark; moves `at` there.
double number_after(const std::string& svg, const std::string& before, std::size_t& at) {
  const std::size_t start = svg.find(before, at) + before.size();
  at = svg.find('"', start);
  return parse_number(svg.substr(start, at - start)).value_or(-1);
}

std::vector<Point> dots_in(const std::string& svg) {
  std::vector<Point> dots;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos; at = svg.find("<circle", at)) {
    const double x = number_after(svg, "cx=\"", at);
    dots.push_back({x, number_after(svg, "cy=\"", at)});
  }
  return dots;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

TEST(Svg, DrawsTheWholeTriangulation) {
  const std::vector<Point> points = test::uniform_points(30, 1);
  const Triangulation triangulation = delaunay_triangulation(points);
  const TestFolder folder;
  write_svg(folder.path("p.svg"), points, triangulation);
  const std::string svg = TestFolder::content(folder.path("p.svg"));
  EXPECT_EQ(count(svg, "<circle"), points.size());
  EXPECT_EQ(count(svg, "<text"), points.size());
  const std::size_t hull_size = convex_hull(points).size();
  EXPECT_EQ(count(svg, "L"), edges_of(triangulation).size() + hull_size - 1);
  EXPECT_TRUE(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
  EXPECT_EQ(count(svg, "<script"), 0U);
}

TEST(Svg, TheYAxisPointsUpAndScalesAreEqual) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {0, 1}};
  const std::vector<Point> dots = dots_in(drawn({.points = points, .width_px = 448}));
  ASSERT_EQ(dots.size(), 3U);
  EXPECT_EQ(dots[0], (Point{24, 224}));
  EXPECT_EQ(dots[1], (Point{424, 224}));
  EXPECT_EQ(dots[2], (Point{24, 24}));
}

TEST(Svg, EveryShapeFitsIntoThePicture) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const std::string svg = drawn({.points = shape.points});
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0U);
    const std::vector<Point> dots = dots_in(svg);
    ASSERT_EQ(dots.size(), shape.points.size());
    double left = 800, right = 0;
    for (const Point& dot : dots) {
      ASSERT_TRUE(24 <= dot.x && dot.x <= 776 && 24 <= dot.y && dot.y <= 1600) << dot.x << ' ' << dot.y;
      left = std::min(left, dot.x);
      right = std::max(right, dot.x);
    }
    EXPECT_NEAR(left + right, 800, 0.02);
  }
}

TEST(Svg, ExtremeRangesAreNormalised) {
  const std::vector<Point> wide{{-1.7e308, 0}, {1.7e308, 0}, {0, 1.7e308}};
  EXPECT_EQ(dots_in(drawn({.points = wide}))[1], (Point{776, 400}));
  const std::vector<Point> tiny{{0, 0}, {5e-324, 0}, {0, 5e-324}};
  EXPECT_EQ(dots_in(drawn({.points = tiny}))[1], (Point{776, 776}));
  const std::vector<Point> tall{{1, 0}, {1, 5e-324}};
  EXPECT_EQ(dots_in(drawn({.points = tall}))[0].x, 400);
  const std::vector<Point> single{{7, 7}};
  EXPECT_EQ(dots_in(drawn({.points = single}))[0], (Point{400, 36}));
}

TEST(Svg, LayersComeFromBackToFront) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::vector<Edge> edges{{0, 1}}, underlay{{1, 3}}, highlight{{0, 2}};
  const std::vector<Index> hull{0, 1, 2, 3};
  const std::string svg =
      drawn({.points = points, .edges = edges, .underlay = underlay, .highlight = highlight, .hull = hull});
  const std::size_t places[] = {svg.find("\"line underlay\""), svg.find("\"line edges\""), svg.find("\"line hull\""),
                                svg.find("\"line highlight\""), svg.find("<circle")};
  EXPECT_TRUE(std::is_sorted(std::begin(places), std::end(places)));
  EXPECT_NE(places[4], std::string::npos);
}

TEST(Svg, TitlesAreEscaped) {
  const std::vector<Point> points{{0, 0}};
  EXPECT_EQ(count(drawn({.points = points, .title = "a < b & c\n> d"}), "<title>a &lt; b &amp; c &gt; d</title>"), 1U);
}

TEST(Svg, RejectsWhatCannotBeDrawn) {
  const std::vector<Point> infinite{{0, HUGE_VAL}};
  const std::vector<Point> fine{{0, 0}};
  EXPECT_THROW(write_svg("/dev/null", SvgPicture{.points = {}}), InputError);
  EXPECT_THROW(write_svg("/dev/null", SvgPicture{.points = infinite}), InputError);
  EXPECT_THROW(write_svg("/dev/null", SvgPicture{.points = fine, .width_px = 50}), InputError);
  EXPECT_THROW(write_svg("/dev/full", SvgPicture{.points = fine}), InputError);
}

}  // namespace
}  // namespace mwt
