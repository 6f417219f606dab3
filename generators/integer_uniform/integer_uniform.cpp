#include "generators/integer_uniform/integer_uniform.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/grid/grid.h"
#include "generators/random.h"

namespace mwt {

namespace {

constexpr std::int64_t kMaxRange = 1'000'000'000;

std::vector<Point> integer_uniform(Index n, std::uint64_t seed, const Parameters& parameters) {
  const bool automatic = parameters.integer("range") == 0;
  const std::int64_t range = automatic ? 2 * std::int64_t{ceiling_square_root(n)}
                                       : integer_within("integer_uniform", parameters, "range", 2, kMaxRange);
  const auto side = static_cast<std::uint64_t>(range);
  require_size("integer_uniform", n, 3, side * side);
  return integer_uniform_points(n, seed, side);
}

}  // namespace

GeneratorInfo integer_uniform_entry() {
  return {.name = "integer_uniform",
          .summary = "distinct points with small random integer coordinates",
          .source = "classical degenerate input",
          .stresses = "many collinear triples, equal lengths and cocircular quadruples without the grid's regularity",
          .law = "none known",
          .max_n = kMaxPoints,
          .parameters = {{"range", ParameterType::integer, "0",
                          "coordinates are 0 .. range - 1, range at least 2; 0: twice ceil(sqrt n)"}},
          .function = integer_uniform};
}

std::vector<Point> integer_uniform_points(Index n, std::uint64_t seed, std::uint64_t range) {
  RandomEngine engine = make_engine("integer_uniform", seed);
  return draw_distinct_points("integer_uniform", n, [&](Index) -> Point {
    const auto x = static_cast<double>(uniform_below(engine, range));
    const auto y = static_cast<double>(uniform_below(engine, range));
    return {x, y};
  });
}

}  // namespace mwt
