#include "generators/hunted/hunted.h"

#include <fmt/core.h>

#include "base/error.h"

namespace mwt {

namespace {

std::vector<Point> hunted(Index n, std::uint64_t, const Parameters& parameters) {
  const std::string& algorithm = parameters.text("algorithm");
  const HuntedInstance* nearest = nullptr;
  const auto distance = [n](const HuntedInstance& instance) {
    const auto size = static_cast<std::int64_t>(instance.points.size());
    return size > n ? size - n : n - size;
  };
  for (const HuntedInstance& instance : hunted_instances()) {
    if (instance.algorithm != algorithm) continue;
    if (nearest == nullptr || distance(instance) < distance(*nearest)) nearest = &instance;
  }
  if (distance(*nearest) == 0) return nearest->points;
  throw InputError(
      fmt::format("hunted: no instance of n={} points was kept; the nearest legal n is {}", n, nearest->points.size()));
}

// Alpha as it was found: the law is that the algorithm has not changed.
std::vector<GrowthLaw> laws() {
  constexpr double kTolerance = 1e-9;
  std::vector<GrowthLaw> laws;
  for (const HuntedInstance& instance : hunted_instances()) {
    const auto n = static_cast<Index>(instance.points.size());
    laws.push_back({.algorithm = instance.algorithm,
                    .algorithm_parameters = {},
                    .parameters = {{"algorithm", instance.algorithm}},
                    .kind = GrowthLaw::Kind::range,
                    .lowest = instance.alpha * (1 - kTolerance),
                    .highest = instance.alpha * (1 + kTolerance),
                    .min_n = n,
                    .max_n = n});
  }
  return laws;
}

}  // namespace

GeneratorInfo hunted_entry() {
  return {.name = "hunted",
          .summary = "small sets that mwt hunt found to be bad for one algorithm; n = 8, 10, 12, 16, 20",
          .source = "found for this project by hill climbing on coordinates (mwt hunt)",
          .stresses = "the algorithm that the parameter names",
          .law = "alpha as it was found, the largest known at these sizes: see the growth laws",
          .min_n = 8,
          .max_n = 20,
          .seeded = false,
          .parameters = {{"algorithm",
                          ParameterType::choice,
                          "greedy",
                          "the algorithm for which the set is bad",
                          {"greedy", "flip", "patch", "quadtree"}}},
          .growth_laws = laws(),
          .function = hunted};
}

}  // namespace mwt
