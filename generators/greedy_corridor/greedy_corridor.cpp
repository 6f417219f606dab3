#include "generators/greedy_corridor/greedy_corridor.h"

#include <cmath>

#include "generators/arguments.h"

namespace mwt {

namespace {

std::vector<Point> greedy_corridor(Index n, std::uint64_t, const Parameters& parameters) {
  const bool sharp = parameters.text("shape") == "sharp";
  require_size("greedy_corridor", n, 5, sharp ? kMaxSharpCorridor : kMaxStandardCorridor);
  const CorridorShape shape = sharp ? sharp_corridor() : standard_corridor();
  const Index m = corridor_length(shape, n);
  return corridor_points(shape, n - 2 - m, m);
}

}  // namespace

namespace {

GrowthLaw root_growth(const std::string& algorithm, const std::string& start, const std::string& shape) {
  const bool has_start = !start.empty();
  return {.algorithm = algorithm,
          .algorithm_parameters =
              has_start ? std::map<std::string, std::string>{{"start", start}} : std::map<std::string, std::string>{},
          .parameters = {{"shape", shape}},
          .lowest = .5,
          .highest = .56,
          .min_n = 256,
          .max_n = 4096};
}

}  // namespace

GeneratorInfo greedy_corridor_entry() {
  return {.name = "greedy_corridor",
          .summary = "two facing reflex chains on which greedy's alpha is of order sqrt n",
          .source = "Levcopoulos, IPL 25 (1987), for the lower bound; the set was made for this project",
          .stresses = "greedy and greedy followed by flips (claims C4 and C5)",
          .law = "alpha of greedy grows like sqrt n (1.85 at n = 16, 37.1 at 4096); optimum by a two-chain program",
          .min_n = 5,
          .max_n = kMaxStandardCorridor,
          .seeded = false,
          .parameters = {{"shape",
                          ParameterType::choice,
                          "standard",
                          "standard; sharp: larger alpha from n = 1000 on, n at most 150000",
                          {"standard", "sharp"}}},
          .growth_laws = {root_growth("greedy", "", "standard"), root_growth("flip", "greedy", "standard"),
                          root_growth("greedy", "", "sharp")},
          .function = greedy_corridor};
}

CorridorShape standard_corridor() {
  return {.beta = .25,
          .epsilon = .01,
          .height = .2,
          .eta = .002,
          .slope_start = .175,
          .slope_end = .19,
          .sigma = 0x1p-10,
          .density = .4};
}

CorridorShape sharp_corridor() {
  CorridorShape shape = {.beta = .05, .epsilon = .005, .height = .05, .sigma = 0x1p-10, .density = .5};
  shape.eta = .01 * shape.height * shape.beta * shape.beta;
  // Steeper than p_0 w_0, so that p_0 sees w_0; less steep than p_0 v, so that the chain bends towards v.
  const double lowest = (shape.height + shape.eta / shape.beta) / (1 + shape.beta);
  shape.slope_start = lowest + .3 * (shape.height - lowest);
  shape.slope_end = lowest + .8 * (shape.height - lowest);
  return shape;
}

std::vector<Point> corridor_points(const CorridorShape& shape, Index k, Index m) {
  const double bend = (shape.slope_end - shape.slope_start) / (2 * shape.sigma);
  std::vector<Point> points;
  points.reserve(std::size_t{k} + m + 2);
  for (Index i = 0; i < k; ++i) {
    const double u = shape.sigma * i / (k - 1);
    points.push_back({u - shape.sigma, shape.height - shape.slope_start * u - bend * u * u});
  }
  points.push_back({1, 0});
  for (Index j = 0; j <= m; ++j) {
    const double x = shape.beta + j * (1 - shape.epsilon);
    points.push_back({1 + x, -shape.eta / x});
  }
  return points;
}

Index corridor_length(const CorridorShape& shape, Index n) {
  const double root = std::sqrt(1 + 4 * shape.density * (n - 2.0));
  return static_cast<Index>((root - 1) / (2 * shape.density));
}

}  // namespace mwt
