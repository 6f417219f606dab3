#include "generators/uniform/uniform.h"

#include "generators/arguments.h"
#include "generators/distinct_points.h"
#include "generators/random.h"

namespace mwt {

namespace {

GrowthLaw law(const std::string& algorithm, GrowthLaw::Kind kind, double lowest, double highest) {
  return {.algorithm = algorithm,
          .algorithm_parameters = {},
          .parameters = {},
          .kind = kind,
          .lowest = lowest,
          .highest = highest,
          .min_n = 256,
          .max_n = 65536};
}

}  // namespace

GeneratorInfo uniform_entry() {
  return {
      .name = "uniform",
      .summary = "independent points, uniform in the unit square",
      .source = "the standard random model; Steele, Annals of Probability 10 (1982), for its optimum",
      .stresses = "the source report's claims C4, C6 and C10 on ordinary input",
      .law =
          "w(T*) grows like sqrt n; alpha of greedy stays below 1.03, of insertion grows like n^0.22, of the sweep "
          "like "
          "sqrt n",
      .max_n = kMaxPoints,
      .parameters = {},
      .growth_laws = {law("greedy", GrowthLaw::Kind::range, 1, 1.03), law("delaunay", GrowthLaw::Kind::range, 1, 1.05),
                      law("hull_insertion", GrowthLaw::Kind::power, .2, .26),
                      law("sweep", GrowthLaw::Kind::power, .45, .55)},
      .function = [](Index n, std::uint64_t seed, const Parameters&) { return uniform_points(n, seed); }};
}

std::vector<Point> uniform_points(Index n, std::uint64_t seed) {
  RandomEngine engine = make_engine("uniform", seed);
  return draw_distinct_points("uniform", n, [&](Index) { return uniform_in_square(engine); });
}

}  // namespace mwt
