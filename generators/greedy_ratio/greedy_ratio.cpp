#include "generators/greedy_ratio/greedy_ratio.h"

#include <algorithm>

#include "generators/arguments.h"

namespace mwt {

namespace {

// Within one percent of the parameter from n = 2000 on.
GrowthLaw tends_to(double alpha, const std::string& text) {
  return {.algorithm = "greedy",
          .algorithm_parameters = {},
          .parameters = {{"alpha", text}},
          .kind = GrowthLaw::Kind::range,
          .lowest = .99 * alpha,
          .highest = 1.01 * alpha,
          .min_n = 2000,
          .max_n = 2000};
}

}  // namespace

GeneratorInfo greedy_ratio_entry() {
  return {.name = "greedy_ratio",
          .summary = "the corridor of greedy_corridor with one step: greedy's alpha tends to the parameter alpha",
          .source = "made for this project, after Levcopoulos, IPL 25 (1987)",
          .stresses = "greedy (claim C4: every alpha in 1.1-1.5 occurs, on inputs built for it)",
          .law = "alpha of greedy tends to the parameter alpha from below; optimum by two_chains",
          .min_n = 5,
          .max_n = kMaxGreedyRatio,
          .seeded = false,
          .parameters = {{"alpha", ParameterType::real, "1.3", "what greedy's alpha tends to, 1.001 to 1.5"}},
          .growth_laws = {tends_to(1.1, "1.1"), tends_to(1.2, "1.2"), tends_to(1.3, "1.3"), tends_to(1.4, "1.4"),
                          tends_to(1.5, "1.5")},
          .function = [](Index n, std::uint64_t, const Parameters& parameters) {
            return greedy_ratio_points(n, real_within("greedy_ratio", parameters, "alpha", 1.001, 1.5));
          }};
}

CorridorShape ratio_corridor(double alpha) {
  CorridorShape shape = {.epsilon = .01, .height = .2, .sigma = 0x1p-10};
  shape.beta = (1 - shape.epsilon) / (alpha - 1) - 1;
  shape.eta = .01 * shape.height * std::min(1.0, shape.beta * shape.beta);
  // Steeper than p_0 w_0, so that p_0 sees w_0, and less steep than p_0 v. For these alpha, beta >= .98 and so p_0 w_0
  // descends by at most .6 height per unit.
  shape.slope_start = .9 * shape.height;
  shape.slope_end = .95 * shape.height;
  return shape;
}

std::vector<Point> greedy_ratio_points(Index n, double alpha) {
  return corridor_points(ratio_corridor(alpha), n - 3, 1);
}

}  // namespace mwt
