#include "generators/local_search_figure/local_search_figure.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "generators/testing.h"
#include "geometry/convex_hull.h"

namespace mwt {
namespace {

TEST(LocalSearchFigure, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("local_search_figure", 10, 1), "a011ee97487f67f0fbd141a6bb739c64");
}

// The source report's first state with the perimeters that it prints (section 5.3.1).
TEST(LocalSearchFigure, triangles_have_the_printed_perimeters) {
  struct Printed {
    std::array<std::size_t, 3> triangle;
    double perimeter;
  };
  const std::vector<Printed> printed = {{{9, 2, 4}, 1.1308}, {{5, 0, 7}, 1.2523}, {{0, 2, 9}, 1.5064},
                                        {{6, 1, 7}, 0.8367}, {{0, 6, 7}, 0.9324}, {{1, 6, 9}, 0.9369},
                                        {{6, 0, 9}, 0.9112}, {{0, 8, 2}, 1.3071}, {{2, 8, 4}, 0.4026},
                                        {{5, 8, 0}, 1.2126}, {{5, 8, 3}, 0.6462}};
  const std::vector<Point> points = local_search_figure_points();
  double total = 0;
  for (const auto& [triangle, perimeter] : printed) {
    double computed = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Point& p = points[triangle[i]];
      const Point& q = points[triangle[(i + 1) % 3]];
      computed += std::hypot(p.x - q.x, p.y - q.y);
    }
    EXPECT_NEAR(computed, perimeter, .00005);
    total += computed;
  }
  EXPECT_NEAR(total, 11.0751, .00005);
}

TEST(LocalSearchFigure, hull_is_the_reports) {
  EXPECT_EQ(convex_hull(local_search_figure_points()), (std::vector<Index>{7, 5, 3, 8, 4, 9, 1}));
}

}  // namespace
}  // namespace mwt
