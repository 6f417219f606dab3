#include "generators/near_collinear/near_collinear.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

std::vector<Point> near_collinear(Index n, std::uint64_t seed, const Parameters& parameters) {
  return near_collinear_points(n, seed, real_within("near_collinear", parameters, "height", 1e-300, 1e300));
}

}  // namespace

GeneratorInfo near_collinear_entry() {
  return {.name = "near_collinear",
          .summary = "points almost on a line, in order along it",
          .source = "classical near-degenerate input for predicates",
          .stresses = "exactness: orientations that plain doubles get wrong, triangles of hardly any area",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {{"height", ParameterType::real, "1e-12", "height of the strip of length 1, above 0"}},
          .function = near_collinear};
}

std::vector<Point> near_collinear_points(Index n, std::uint64_t seed, double height) {
  RandomEngine engine = make_engine("near_collinear", seed);
  return draw_distinct_points("near_collinear", n, [&](Index i) -> Point {
    const Point random = uniform_in_square(engine);
    return {(i + .5 * random.x) / n, height * random.y};
  });
}

}  // namespace mwt
