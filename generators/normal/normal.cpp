#include "generators/normal/normal.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

GeneratorInfo normal_entry() {
  return {.name = "normal",
          .summary = "independent points, both coordinates standard normal",
          .source = "the standard random model",
          .stresses = "uneven density: long edges outside, short ones inside; few points on the hull",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {},
          .function = [](Index n, std::uint64_t seed, const Parameters&) { return normal_points(n, seed); }};
}

std::vector<Point> normal_points(Index n, std::uint64_t seed) {
  RandomEngine engine = make_engine("normal", seed);
  return draw_distinct_points("normal", n, [&](Index) { return standard_normal_point(engine); });
}

}  // namespace mwt
