#include "generators/spiral/spiral.h"

#include "generators/arguments.h"
#include "generators/unit_circle.h"

namespace mwt {

namespace {

std::vector<Point> spiral(Index n, std::uint64_t, const Parameters& parameters) {
  const auto turns = static_cast<Index>(integer_within("spiral", parameters, "turns", 1, 1'000'000));
  require_size("spiral", n, 2 * turns + 1, kMaxPoints);
  return spiral_points(n, turns);
}

}  // namespace

GeneratorInfo spiral_entry() {
  return {
      .name = "spiral",
      .summary = "points along an Archimedean spiral, dense along it and sparse across",
      .source = "a classical test for curve-like data",
      .stresses = "sliver-shaped regions: sweep, quadtree's merging, LMT faces that wind around each other",
      .law = "none known",
      .min_n = 11,
      .max_n = kMaxPoints,
      .seeded = false,
      .parameters = {{"turns", ParameterType::integer, "5", "number of turns, at least 1; n is at least 2 turns + 1"}},
      .function = spiral};
}

std::vector<Point> spiral_points(Index n, Index turns) {
  std::vector<Point> points;
  points.reserve(n);
  for (std::uint64_t i = 0; i < n; ++i) {
    const Point direction = unit_circle_point(i * turns % n, n);
    const double radius = (static_cast<double>(i) + 1) / n;
    points.push_back({radius * direction.x, radius * direction.y});
  }
  return points;
}

}  // namespace mwt
