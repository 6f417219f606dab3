#include "generators/annulus/annulus.h"

#include <cmath>

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

GeneratorInfo annulus_entry() {
  return {.name = "annulus",
          .summary = "independent points, uniform in a ring",
          .source = "a standard random model",
          .stresses = "a large empty face inside: long edges that no point shortens, for exact solvers and patch",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {{"inner", ParameterType::real, "0.9", "inner radius, the outer being 1; 0 to .999999"}},
          .function = [](Index n, std::uint64_t seed, const Parameters& parameters) {
            return annulus_points(n, seed, real_within("annulus", parameters, "inner", 0, .999999));
          }};
}

std::vector<Point> annulus_points(Index n, std::uint64_t seed, double inner) {
  RandomEngine engine = make_engine("annulus", seed);
  return draw_distinct_points("annulus", n, [&](Index) -> Point {
    const Point direction = random_direction(engine);
    const double radius = std::sqrt(inner * inner + (1 - inner * inner) * uniform_unit(engine));
    return {radius * direction.x, radius * direction.y};
  });
}

}  // namespace mwt
