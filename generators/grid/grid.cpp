#include "generators/grid/grid.h"

#include <cmath>
#include <utility>

#include "generators/arguments.h"
#include "generators/unit_circle.h"

namespace mwt {

namespace {

std::vector<Point> grid(Index n, std::uint64_t, const Parameters& parameters) {
  std::vector<Point> points = grid_points(n);
  const std::string& tilt = parameters.text("tilt");
  if (tilt == "exact") return tilted(std::move(points), {4, 3});
  if (tilt == "rounded") return tilted(std::move(points), unit_circle_point(1, 7));
  return points;
}

}  // namespace

GeneratorInfo grid_entry() {
  return {.name = "grid",
          .summary = "integer grid with ceil(sqrt n) columns, the last row cut short unless n is a square",
          .source = "classical degenerate input",
          .stresses = "ties, cocircular quadruples and collinear triples, all exact, on the hull and inside",
          .law =
              "optimum 2 g (g - 1) + sqrt(2) (g - 1)^2 for n = g * g (5 times that with tilt=exact); greedy and "
              "Delaunay reach it",
          .max_n = kMaxPoints,
          .seeded = false,
          .parameters = {{"tilt",
                          ParameterType::choice,
                          "none",
                          "exact: turned and scaled by 4 + 3i, all ties stay; rounded: turned by 1/7, near-ties",
                          {"none", "exact", "rounded"}}},
          .function = grid};
}

Index ceiling_square_root(Index n) { return static_cast<Index>(std::ceil(std::sqrt(static_cast<double>(n)))); }

std::vector<Point> grid_points(Index n) {
  const Index columns = ceiling_square_root(n);
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i < n; ++i) {
    points.push_back({static_cast<double>(i % columns), static_cast<double>(i / columns)});
  }
  return points;
}

std::vector<Point> tilted(std::vector<Point> points, const Point& direction) {
  for (Point& p : points) p = {p.x * direction.x - p.y * direction.y, p.x * direction.y + p.y * direction.x};
  return points;
}

}  // namespace mwt
