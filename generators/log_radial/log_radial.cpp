#include "generators/log_radial/log_radial.h"

#include <cmath>

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

GeneratorInfo log_radial_entry() {
  return {.name = "log_radial",
          .summary = "points in random directions, their distances spread over many powers of two",
          .source = "a standard model of extreme density gradients",
          .stresses = "quadtree (depth grows with the spread, not with n) and exact predicates at all scales",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {{"octaves", ParameterType::integer, "20", "powers of two that distances span, 1 to 1000"}},
          .function = [](Index n, std::uint64_t seed, const Parameters& parameters) {
            const auto octaves = integer_within("log_radial", parameters, "octaves", 1, 1000);
            return log_radial_points(n, seed, static_cast<Index>(octaves));
          }};
}

std::vector<Point> log_radial_points(Index n, std::uint64_t seed, Index octaves) {
  RandomEngine engine = make_engine("log_radial", seed);
  return draw_distinct_points("log_radial", n, [&](Index) -> Point {
    const Point direction = random_direction(engine);
    const auto octave = static_cast<int>(uniform_below(engine, octaves)) + 1;
    const double distance = std::scalbn(1 + uniform_unit(engine), -octave);
    return {distance * direction.x, distance * direction.y};
  });
}

}  // namespace mwt
