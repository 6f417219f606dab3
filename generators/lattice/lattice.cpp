#include "generators/lattice/lattice.h"

#include <cmath>

#include "generators/arguments.h"
#include "generators/random.h"
#include "geometry/convex_hull.h"

namespace mwt {

namespace {

// Selection sampling: Knuth, The Art of Computer Programming 2, section 3.4.2, algorithm S.
std::vector<Point> sample_lattice(Index n, std::uint64_t side, RandomEngine& engine) {
  std::vector<Point> points;
  points.reserve(n);
  for (std::uint64_t cell = 0; points.size() < n; ++cell) {
    if (uniform_below(engine, side * side - cell) >= n - points.size()) continue;
    points.push_back({static_cast<double>(cell % side), static_cast<double>(cell / side)});
  }
  return points;
}

std::vector<Point> lattice(Index n, std::uint64_t seed, const Parameters& parameters) {
  return lattice_points(n, seed, real_within("lattice", parameters, "holes", 0, .99));
}

}  // namespace

GeneratorInfo lattice_entry() {
  return {.name = "lattice",
          .summary = "square integer lattice with a share of its points left out at random",
          .source = "drill-hole boards and sampled rasters; the degenerate sets on which LMT tests fail",
          .stresses = "exact ties together with empty regions: strictness of convexity, flips and diamond tests",
          .law = "none known; the grid's optimum when holes=0 and n is a square",
          .max_n = kMaxPoints,
          .parameters = {{"holes", ParameterType::real, "0.1", "share of the lattice that is left out, 0 to .99"}},
          .function = lattice};
}

std::vector<Point> lattice_points(Index n, std::uint64_t seed, double holes) {
  RandomEngine engine = make_engine("lattice", seed);
  const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(n / (1 - holes))));
  for (;;) {
    std::vector<Point> points = sample_lattice(n, side, engine);
    if (!all_collinear(points)) return points;
  }
}

}  // namespace mwt
