#include "generators/delaunay_arc/delaunay_arc.h"

#include "generators/arguments.h"
#include "generators/unit_circle.h"

namespace mwt {

namespace {

std::vector<Point> delaunay_arc(Index n, std::uint64_t, const Parameters& parameters) {
  const bool is_integer = parameters.text("coordinates") == "integer";
  require_size("delaunay_arc", n, 4, is_integer ? kMaxIntegerArc : kMaxArc);
  return is_integer ? integer_delaunay_arc_points(n) : delaunay_arc_points(n);
}

GrowthLaw linear_growth(const std::string& coordinates) {
  return {.algorithm = "delaunay",
          .algorithm_parameters = {},
          .parameters = {{"coordinates", coordinates}},
          .lowest = .95,
          .highest = 1.05,
          .min_n = 256,
          .max_n = 4096};
}

}  // namespace

GeneratorInfo delaunay_arc_entry() {
  return {.name = "delaunay_arc",
          .summary = "points on a short arc and one near its centre: Delaunay is the fan of all radii",
          .source = "Kirkpatrick, IPL 10 (1980), for the lower bound; the set was made for this project",
          .stresses = "delaunay, in convex position",
          .law = "alpha of delaunay grows like n (7.15 at n = 16, 459 at 1024); optimum by polygon_dp",
          .min_n = 4,
          .max_n = kMaxArc,
          .seeded = false,
          .parameters = {{"coordinates",
                          ParameterType::choice,
                          "circle",
                          "circle: on the unit circle, rounded; integer: on a parabola, exact, n at most 262146",
                          {"circle", "integer"}}},
          .growth_laws = {linear_growth("circle"), linear_growth("integer")},
          .function = delaunay_arc};
}

std::vector<Point> delaunay_arc_points(Index n) {
  constexpr std::uint64_t kArcsPerCircle = 400;  // of half the arc
  const std::uint64_t steps = n - 2;
  const std::uint64_t half_turn = kArcsPerCircle * steps / 2;  // in steps of half an arc's n - 2 parts
  std::vector<Point> points;
  points.reserve(n);
  for (std::uint64_t i = 0; i <= steps; ++i)
    points.push_back(unit_circle_point(half_turn + steps - 2 * i, 2 * half_turn));
  points.push_back({.5, 0});
  return points;
}

std::vector<Point> integer_delaunay_arc_points(Index n) {
  const auto largest = static_cast<std::int64_t>((n - 1) / 2);
  const auto smallest = largest - static_cast<std::int64_t>(n) + 2;
  const double m = 1024.0 * static_cast<double>(largest);
  std::vector<Point> points;
  points.reserve(n);
  for (std::int64_t i = smallest; i <= largest; ++i) {
    const auto offset = static_cast<double>(i);
    points.push_back({offset * offset, m * offset});
  }
  points.push_back({m * m / 2, 0});
  return points;
}

}  // namespace mwt
