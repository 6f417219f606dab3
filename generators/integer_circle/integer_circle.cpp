#include "generators/integer_circle/integer_circle.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "generators/random.h"

namespace mwt {

namespace {

struct Circle {
  std::int64_t squared_radius;
  Index points;  // with integer coordinates
};

// 5, 5 13, 5 13 17, 5^3 13 17, then one more prime each: 29, 37, 41, 53, 61, 13 again. None is a square or twice one.
constexpr Circle kCircles[] = {{5, 8},
                               {65, 16},
                               {1105, 32},
                               {27625, 64},
                               {801125, 128},
                               {29641625, 256},
                               {1215306625, 512},
                               {64411251125, 1024},
                               {3929086318625, 2048},
                               {51078122142125, kMaxIntegerCircle}};

// All integer points on a circle. One octant is walked with a falling y; neither axes nor diagonals hold a point.
std::vector<Point> points_on(const Circle& circle) {
  std::vector<Point> points;
  std::int64_t y = static_cast<std::int64_t>(std::sqrt(static_cast<double>(circle.squared_radius))) + 1;
  for (std::int64_t x = 1; x < y; ++x) {
    while (x * x + y * y > circle.squared_radius) --y;
    if (x * x + y * y < circle.squared_radius) continue;
    const auto a = static_cast<double>(x), b = static_cast<double>(y);
    points.insert(points.end(), {{a, b}, {b, a}, {-a, b}, {-b, a}, {a, -b}, {b, -a}, {-a, -b}, {-b, -a}});
  }
  return points;
}

}  // namespace

GeneratorInfo integer_circle_entry() {
  return {.name = "integer_circle",
          .summary = "random integer points on one circle x^2 + y^2 = R: exactly cocircular",
          .source = "sums of two squares (Jacobi 1829)",
          .stresses = "exact cocircular ties: every triangulation is Delaunay; convex position",
          .law = "optimum by the polygon program; C(n - 2) triangulations; Delaunay's alpha is up to its tie-breaking",
          .max_n = kMaxIntegerCircle,
          .parameters = {},
          .function = [](Index n, std::uint64_t seed, const Parameters&) { return integer_circle_points(n, seed); }};
}

std::vector<Point> integer_circle_points(Index n, std::uint64_t seed) {
  RandomEngine engine = make_engine("integer_circle", seed);
  const Circle* circle = std::find_if(std::begin(kCircles), std::end(kCircles) - 1,
                                      [&](const Circle& candidate) { return candidate.points >= n; });
  std::vector<Point> points = points_on(*circle);
  shuffle(points, engine);
  points.resize(n);
  return points;
}

}  // namespace mwt
