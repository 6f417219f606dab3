#include "generators/grid/grid.h"

#include <cmath>

#include "generators/arguments.h"

namespace mwt {

GeneratorInfo grid_entry() {
  return {.name = "grid",
          .summary = "integer grid with ceil(sqrt n) columns, the last row cut short unless n is a square",
          .source = "classical degenerate input",
          .stresses = "ties, cocircular quadruples and collinear triples, all exact, on the hull and inside",
          .law = "optimum 2 g (g - 1) + sqrt(2) (g - 1)^2 for n = g * g; greedy and Delaunay reach it",
          .largest_n = kMostPoints,
          .seeded = false,
          .parameters = {},
          .function = [](Index n, std::uint64_t, const Parameters&) { return grid_points(n); }};
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

}  // namespace mwt
