// What the solvers' tests share: running an algorithm by name and checking all it claims.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "algorithms/registry.h"
#include "geometry/checker.h"
#include "geometry/weight.h"

namespace mwt {

/// Runs a registered algorithm with its default parameters and those given. The result's triangulation is checked, and
/// a certified optimum must not contradict its weight.
inline Solution solve_and_check(const std::string& algorithm, Points points,
                                const std::map<std::string, std::string>& parameters = {}, Deadline deadline = {}) {
  const AlgorithmInfo& info = find_algorithm(algorithm);
  Context context;
  context.parameters = Parameters(info.name, info.parameters, parameters);
  context.deadline = deadline;
  Solution solution = info.function(points, context);
  const auto violation = find_violation(points, solution.triangulation);
  EXPECT_FALSE(violation) << algorithm << ": " << violation->message;
  if (solution.optimum) {
    const Interval found = weight(points, solution.triangulation);
    EXPECT_LE(solution.optimum->lower, solution.optimum->upper) << algorithm;
    EXPECT_EQ(solution.optimum->upper, found.upper) << algorithm;
  }
  return solution;
}

/// The same for an algorithm that must prove its result optimal.
inline Solution solve_to_optimality(const std::string& algorithm, Points points) {
  Solution solution = solve_and_check(algorithm, points);
  EXPECT_FALSE(solution.stop_reason) << algorithm << ": " << phrase_of(*solution.stop_reason);
  if (solution.optimum) {
    EXPECT_LE(solution.optimum->relative_width(), 1e-12) << algorithm;
  } else {
    ADD_FAILURE() << algorithm << " certifies no optimum";
  }
  return solution;
}

}  // namespace mwt
