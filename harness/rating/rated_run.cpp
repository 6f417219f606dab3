#include "harness/rating/rated_run.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "base/number_text.h"
#include "geometry/checker.h"
#include "geometry/convex_hull.h"
#include "geometry/weight.h"
#include "harness/rating/quality.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxMessage = 1000;
constexpr std::string_view kClaimed = "claimed";

// The results of the checker and of the certified sums for a triangulation.
struct Judgement {
  std::optional<std::string> violation;  // the rest is meaningless if there is one
  Interval weight;
  Interval perimeter_sum;
  std::uint64_t triangles = 0;
  std::uint64_t edges = 0;
};

Judgement judge(Points points, const Triangulation& triangulation) {
  Judgement judgement;
  if (const auto violation = find_violation(points, triangulation)) {
    judgement.violation = violation->message;
    return judgement;
  }
  judgement.weight = weight(points, triangulation);
  judgement.perimeter_sum = perimeter_sum(points, triangulation);
  judgement.triangles = triangulation.triangles.size();
  // By Euler's formula, for the checker has seen that 3 sides per triangle pair up except on the hull.
  judgement.edges = (judgement.triangles * 3 + convex_hull(points).size()) / 2;
  return judgement;
}

void fill_in_costs(RatedRun& run, const Execution& execution) {
  run.wall_time_s = execution.wall_time_s;
  run.cpu_time_s = execution.cpu_time_s;
  run.iterations = execution.iterations;
  run.peak_rss_bytes = execution.peak_rss_bytes;
  run.phases.assign(execution.phases.begin(), execution.phases.end());
  run.instructions = execution.counts.instructions;
  run.cycles = execution.counts.cycles;
  run.cache_misses = execution.counts.cache_misses;
  run.branch_misses = execution.counts.branch_misses;
}

void fill_in_solution(RatedRun& run, const Solution& solution, const Judgement& judgement) {
  run.weight_lower = judgement.weight.lower;
  run.weight_upper = judgement.weight.upper;
  run.perimeter_sum = judgement.perimeter_sum.middle();
  run.edges = judgement.edges;
  run.stopped_early = solution.stopped_early();
  run.stop_reason = solution.stop_reason;
  run.triangulation_count = solution.count.value_or("");
  run.counters.assign(solution.counters.begin(), solution.counters.end());
  run.claimed_lower = solution.claimed_lower;
}

void clear_rating(RatedRun& run) {
  run.optimum_lower.reset();
  run.optimum_upper.reset();
  run.optimality.clear();
  run.alpha_lower.reset();
  run.alpha_upper.reset();
  run.optimal.clear();
}

// A trivial lower bound is no claim.
bool is_claim(const std::optional<double>& lower) { return lower && *lower > 0 && std::isfinite(*lower); }

}  // namespace

RatedRun judged(const AlgorithmInfo& algorithm, Points points, const Execution& execution) {
  const Solution& solution = execution.solution;
  const Judgement judgement = judge(points, solution.triangulation);
  RatedRun run;
  fill_in_costs(run, execution);
  run.triangles = solution.triangulation.triangles.size();
  run.checker = judgement.violation.value_or("ok");
  if (judgement.violation) {
    fail(run, RunStatus::invalid_output, *judgement.violation);
    return run;
  }
  run.status = RunStatus::ok;
  fill_in_solution(run, solution, judgement);
  const WitnessedOptimum optimum = witnessed_optimum(solution.optimum, judgement.weight);
  if (optimum.contradiction) {
    fail(run, RunStatus::error, Disproof{{"", algorithm.name, *solution.optimum}, "", judgement.weight.upper}.text());
  } else if (optimum.interval) {
    run.certified_lower = optimum.interval->lower;
  }
  return run;
}

void rate(RatedRun& run, const std::optional<Interval>& optimum) {
  if (run.status != RunStatus::ok) return;
  clear_rating(run);
  const Interval weight{run.weight_lower.value(), run.weight_upper.value()};
  if (const double known = optimum ? optimum->upper : weight.upper; run.claimed_lower > known) {
    run.delaunay_time_s.reset();
    return fail(run, RunStatus::error,
                fmt::format("it claims that no triangulation weighs less than {}, but one weighs {}",
                            number_text(*run.claimed_lower), number_text(known)));
  }
  run.optimality = !optimum && run.claimed_lower ? kClaimed : name_of(optimality_of(optimum));
  run.optimal = name_of(is_optimal(weight, optimum));
  if (!optimum) return;
  const Interval alpha = alpha_of(weight, *optimum);
  run.optimum_lower = optimum->lower;
  run.optimum_upper = optimum->upper;
  run.alpha_lower = alpha.lower;
  run.alpha_upper = alpha.upper;
}

std::vector<Disproof> add_run(OptimumClaims& claims, const std::string& id, const std::string& whose,
                              const RatedRun& run) {
  if (run.status != RunStatus::ok || !run.weight_upper) return {};
  if (!is_claim(run.certified_lower)) return claims.add_weight({whose, *run.weight_upper});
  return claims.add_claim({id, whose, {*run.certified_lower, *run.weight_upper}});
}

void reject(RatedRun& run, const Disproof& disproof) {
  run.status = RunStatus::error;
  run.message = disproof.text();
  run.delaunay_time_s.reset();
  clear_rating(run);
}

bool is_disproved(const RatedRun& run) {
  return run.status == RunStatus::error && run.message.starts_with(kContradiction);
}

void fail(RatedRun& run, RunStatus status, const std::string& message) {
  run.status = status;
  run.message = message.size() <= kMaxMessage ? message : message.substr(0, kMaxMessage) + " ...";
}

std::optional<double> named_number(const NamedNumbers& numbers, std::string_view name) {
  const auto found = std::ranges::find(numbers, name, &NamedNumbers::value_type::first);
  return found == numbers.end() ? std::nullopt : std::optional(found->second);
}

std::string to_text(const NamedNumbers& numbers) {
  std::string text;
  for (const auto& [name, value] : numbers) {
    if (!text.empty()) text += ' ';
    for (const char c : name) text += c == ' ' || c == '=' ? '_' : c;
    text += '=' + number_text(value);
  }
  return text;
}

void read_text(const std::string& text, NamedNumbers& numbers) {
  numbers.clear();
  if (text.empty()) return;
  for (const std::string& field : split(text, ' ')) {
    const std::size_t equals = field.find('=');
    const std::optional<double> number =
        equals == std::string::npos ? std::nullopt : parse_number(field.substr(equals + 1));
    if (!number) throw std::invalid_argument(text);
    numbers.emplace_back(field.substr(0, equals), *number);
  }
}

std::string to_text(RunStatus status) { return std::string(name_of(status)); }

void read_text(const std::string& text, RunStatus& status) {
  const std::optional<RunStatus> found = status_of(text);
  if (!found) throw std::invalid_argument(text);
  status = *found;
}

std::string to_text(StopReason reason) { return std::string(name_of(reason)); }

void read_text(const std::string& text, StopReason& reason) {
  const std::optional<StopReason> found = stop_reason_of(text);
  if (!found) throw std::invalid_argument(text);
  reason = *found;
}

}  // namespace mwt
