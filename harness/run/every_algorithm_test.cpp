// Every algorithm of the registry on every family of the other registry: what it returns is a triangulation.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "algorithms/registry.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/checker.h"
#include "geometry/point_set.h"
#include "geometry/weight.h"

namespace mwt {
namespace {

// Sanitizers slow everything down tenfold; the largest size is left to the optimised build.
#ifdef __SANITIZE_ADDRESS__
const std::vector<Index> kSizes = {3, 4, 5, 10, 100};
#else
const std::vector<Index> kSizes = {3, 4, 5, 10, 100, 1000};
#endif

// Exact algorithms may need for ever on some inputs: they must then return the best they have.
constexpr auto kPatience = std::chrono::milliseconds(200);

class EveryAlgorithm : public ::testing::TestWithParam<std::string> {};

// The family's instance of n points; none if there is no such size or it is no point set (all collinear).
std::vector<Point> instance(const GeneratorInfo& family, Index n) {
  try {
    return make_point_set(generate(family.name, n, 1), family.name).points;
  } catch (const InputError&) {
    return {};
  }
}

// Returns whether the algorithm takes the instance.
bool expect_triangulation(const AlgorithmInfo& algorithm, Points points) {
  Context context;
  context.parameters = Parameters(algorithm.name, algorithm.parameters, {});
  if (algorithm.exactness == Exactness::exact) context.deadline = Context::Clock::now() + kPatience;
  try {
    const Solution solution = algorithm.function(points, context);
    const auto violation = find_violation(points, solution.triangulation);
    EXPECT_FALSE(violation) << violation->message;
    if (violation) return true;
    const Interval weight_of_solution = weight(points, solution.triangulation);
    if (solution.optimum) {
      EXPECT_LE(solution.optimum->lower, weight_of_solution.upper);
    }
    return true;
  } catch (const NotApplicable&) {
    return false;
  }
}

TEST_P(EveryAlgorithm, GivesATriangulationOnEveryFamily) {
  const AlgorithmInfo& algorithm = find_algorithm(GetParam());
  std::size_t solved = 0;
  for (const GeneratorInfo& family : generators()) {
    std::vector<Index> sizes = kSizes;
    if (family.fixed_n != 0) sizes = {family.fixed_n};
    for (const Index n : sizes) {
      if (n > algorithm.max_n) continue;
      SCOPED_TRACE(family.name + " n=" + std::to_string(n));
      const std::vector<Point> points = instance(family, n);
      if (!points.empty() && expect_triangulation(algorithm, points)) ++solved;
    }
  }
  EXPECT_GE(3 * solved, generators().size()) << "the algorithm takes hardly anything";
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const AlgorithmInfo& algorithm : algorithms()) result.push_back(algorithm.name);
  return result;
}

INSTANTIATE_TEST_SUITE_P(Registry, EveryAlgorithm, ::testing::ValuesIn(names()),
                         [](const auto& algorithm) { return algorithm.param; });

}  // namespace
}  // namespace mwt
