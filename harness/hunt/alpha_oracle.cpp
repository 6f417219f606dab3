#include "harness/hunt/alpha_oracle.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/weight.h"
#include "harness/rating/optimum_claims.h"
#include "harness/rating/quality.h"

namespace mwt {

namespace {

// A solution that the checker accepts, and its weight.
struct CheckedSolution {
  Solution solution;
  Interval weight;
};

CheckedSolution solve_checked(const Request& request, Points points) {
  Context context;
  context.seed = request.seed;
  context.threads = request.threads;
  context.parameters = request.parameters;
  if (request.time_limit_s) {
    const std::chrono::duration<double> limit(*request.time_limit_s);
    context.deadline = Context::Clock::now() + std::chrono::duration_cast<Context::Clock::duration>(limit);
  }
  Solution solution = request.algorithm->function(points, context);
  if (const auto violation = find_violation(points, solution.triangulation)) {
    throw std::logic_error(request.algorithm->name + ": invalid triangulation: " + violation->message);
  }
  const Interval found = weight(points, solution.triangulation);
  return {std::move(solution), found};
}

Request request_for(const AlgorithmInfo& solver) {
  Request request;
  request.algorithm = &solver;
  request.parameters = Parameters(solver.name, solver.parameters, {});
  request.time_limit_s = 1;
  return request;
}

}  // namespace

const AlgorithmInfo& solver_for_hunt(const Catalogue& catalogue, Index n) {
  constexpr Index kMaxForSubsets = 13;
  return catalogue.algorithm(n <= kMaxForSubsets ? "subset_dp" : "exact");
}

AlphaOracle::AlphaOracle(Request request, const AlgorithmInfo& solver)
    : request_(std::move(request)), solver_(solver) {}

DisprovedOptimum AlphaOracle::disproved(const Interval& claimed, const std::string& witness, const Interval& weight,
                                        const std::vector<Point>& points) const {
  return {Disproof{{"", solver_.name, claimed}, witness, weight.upper}.text(), points};
}

std::optional<Interval> AlphaOracle::rate(const std::vector<Point>& points) const {
  try {
    const PointSet set = make_point_set(points, "hunt");
    if (set.duplicates() > 0) return std::nullopt;
    const CheckedSolution reference = solve_checked(request_for(solver_), points);
    const WitnessedOptimum optimum = witnessed_optimum(reference.solution.optimum, reference.weight);
    if (optimum.contradiction) throw disproved(*reference.solution.optimum, "", reference.weight, points);
    if (optimality_of(optimum.interval) != Optimality::proved) return std::nullopt;
    const CheckedSolution found = solve_checked(request_, points);
    if (found.weight.upper < optimum.interval->lower) {
      throw disproved(*optimum.interval, request_.algorithm->name, found.weight, points);
    }
    return alpha_of(found.weight, *optimum.interval);
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const NotApplicable&) {
    return std::nullopt;
  }
}

}  // namespace mwt
