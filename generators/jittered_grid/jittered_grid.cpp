#include "generators/jittered_grid/jittered_grid.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/grid/grid.h"
#include "generators/random.h"

namespace mwt {

namespace {

std::vector<Point> jittered_grid(Index n, std::uint64_t seed, const Parameters& parameters) {
  return jittered_grid_points(n, seed, real_within("jittered_grid", parameters, "jitter", 0, 1000));
}

}  // namespace

GeneratorInfo jittered_grid_entry() {
  return {.name = "jittered_grid",
          .summary = "integer grid, every point moved at random within its cell",
          .source = "the usual model of scattered but even samples (jittered sampling, Cook 1986)",
          .stresses = "near-ties: quadruples that are nearly cocircular, hull points that are nearly collinear",
          .law = "w(T*) tends to that of the grid as jitter tends to 0",
          .max_n = kMaxPoints,
          .parameters = {{"jitter", ParameterType::real, "0.5",
                          "side of the square that a point is moved in, in cells, 0 to 1000"}},
          .function = jittered_grid};
}

std::vector<Point> jittered_grid_points(Index n, std::uint64_t seed, double jitter) {
  RandomEngine engine = make_engine("jittered_grid", seed);
  const std::vector<Point> grid = grid_points(n);
  return draw_distinct_points("jittered_grid", n, [&](Index i) -> Point {
    const Point move = uniform_in_square(engine);
    return {grid[i].x + jitter * (move.x - .5), grid[i].y + jitter * (move.y - .5)};
  });
}

}  // namespace mwt
