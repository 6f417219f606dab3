#include "generators/uniform_disc/uniform_disc.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

Point uniform_in_disc(RandomEngine& engine) {
  for (;;) {
    const Point corner = uniform_in_square(engine);
    const Point p = {2 * corner.x - 1, 2 * corner.y - 1};
    if (p.x * p.x + p.y * p.y <= 1) return p;
  }
}

}  // namespace

GeneratorInfo uniform_disc_entry() {
  return {.name = "uniform_disc",
          .summary = "independent points, uniform in the unit disc",
          .source = "the standard random model; Renyi and Sulanke (1963) for its hull",
          .stresses = "the hull: about 3.4 n^(1/3) of the points lie on it, against 2.7 ln n in a square",
          .law = "w(T*) grows like sqrt n; alpha as for uniform",
          .max_n = kMaxPoints,
          .parameters = {},
          .function = [](Index n, std::uint64_t seed, const Parameters&) { return uniform_disc_points(n, seed); }};
}

std::vector<Point> uniform_disc_points(Index n, std::uint64_t seed) {
  RandomEngine engine = make_engine("uniform_disc", seed);
  return draw_distinct_points("uniform_disc", n, [&](Index) { return uniform_in_disc(engine); });
}

}  // namespace mwt
