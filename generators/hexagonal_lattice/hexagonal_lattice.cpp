#include "generators/hexagonal_lattice/hexagonal_lattice.h"

#include <cmath>

#include "generators/arguments.h"
#include "generators/grid/grid.h"

namespace mwt {

GeneratorInfo hexagonal_lattice_entry() {
  return {
      .name = "hexagonal_lattice",
      .summary = "lattice of equilateral triangles, rounded, the last row cut short",
      .source = "classical: the densest packing's centres",
      .stresses = "near-ties everywhere: all short edges are equal up to their last bits, all rows collinear",
      .law = "every edge of length 1 but for the hull's left and right sides: greedy and Delaunay are optimal inside",
      .max_n = kMaxPoints,
      .seeded = false,
      .parameters = {},
      .function = [](Index n, std::uint64_t, const Parameters&) { return hexagonal_lattice_points(n); }};
}

std::vector<Point> hexagonal_lattice_points(Index n) {
  const Index columns = ceiling_square_root(n);
  const double row_height = std::sqrt(3.0) / 2;
  std::vector<Point> points;
  points.reserve(n);
  for (Index i = 0; i < n; ++i) {
    const Index row = i / columns;
    points.push_back({(i % columns) + .5 * (row % 2), row_height * row});
  }
  return points;
}

}  // namespace mwt
