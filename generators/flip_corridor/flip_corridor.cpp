#include "generators/flip_corridor/flip_corridor.h"

#include "generators/greedy_corridor/greedy_corridor.h"

namespace mwt {

GeneratorInfo flip_corridor_entry() {
  return {.name = "flip_corridor",
          .summary = "a corridor with far ends: flips from the sweep's triangulation stay a factor of order n away",
          .source = "made for this project",
          .stresses = "flips that start from a sweep; greedy solves it",
          .law = "alpha of flip with start=sweep grows like n (3.10 at n = 16, 194 at 1024); optimum by two_chains",
          .min_n = 6,
          .max_n = kMaxFlipCorridor,
          .seeded = false,
          .parameters = {},
          .growth_laws = {{.algorithm = "flip",
                           .algorithm_parameters = {{"start", "sweep"}},
                           .parameters = {},
                           .lowest = .95,
                           .highest = 1.05,
                           .min_n = 256,
                           .max_n = 4096}},
          .function = [](Index n, std::uint64_t, const Parameters&) { return flip_corridor_points(n); }};
}

std::vector<Point> flip_corridor_points(Index n) {
  const CorridorShape shape = standard_corridor();
  const Index k = n - 4;
  std::vector<Point> points = corridor_points(shape, k, 1);
  points.pop_back();
  for (const double x : {k - .99, k + 0.0}) points.push_back({1 + x, -shape.eta / x});
  for (Point& p : points) p.x = 0 - p.x;
  return points;
}

}  // namespace mwt
