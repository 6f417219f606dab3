#include "harness/hunt/alpha_oracle.h"

#include <stdexcept>
#include <string>
#include <utility>

#include "base/error.h"
#include "harness/rating/quality.h"
#include "harness/rating/rated_run.h"
#include "harness/run/command/command.h"

namespace mwt {

namespace {

// The run, or what went wrong with its triangulation.
RatedRun run_here(const Request& request, Points points) {
  RatedRun run = judged(*request.algorithm, points, solve_unmeasured(request, points));
  if (run.status == RunStatus::invalid_output) {
    if (request.algorithm->runs_outside) throw CommandFailure(run.status, run.message);
    throw std::logic_error(request.algorithm->name + ": invalid triangulation: " + run.message);
  }
  return run;
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

std::optional<Interval> AlphaOracle::alpha(const std::vector<Point>& points) const {
  try {
    const PointSet set = make_point_set(points, "hunt");
    if (set.duplicates() > 0) return std::nullopt;
    OptimumClaims claims;
    const auto add = [&](const Request& request) {
      RatedRun run = run_here(request, points);
      if (is_disproved(run)) throw DisprovedOptimum(run.message, points);
      const auto disproofs = add_run(claims, request.algorithm->name, request.algorithm->name, run);
      if (!disproofs.empty()) throw DisprovedOptimum(disproofs.front().text(), points);
      return run;
    };
    add(request_for(solver_));
    if (optimality_of(claims.bounds()) != Optimality::proved) return std::nullopt;
    RatedRun run = add(request_);
    rate(run, claims.bounds());
    if (run.status != RunStatus::ok) throw CommandFailure(run.status, run.message);  // it claims too much
    return Interval{run.alpha_lower.value(), run.alpha_upper.value()};
  } catch (const InputError&) {
    return std::nullopt;
  } catch (const NotApplicable&) {
    return std::nullopt;
  }
}

}  // namespace mwt
