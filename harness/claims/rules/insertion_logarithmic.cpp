// C6: hull DP + insertion as an O(log n) approximation.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

constexpr Index kMinInsertionN = 50;
constexpr double kClearAlphaGrowth = 0.05;

// The lower ends: certified by any known triangulation, so that they show growth even where no optimum is proved.
std::optional<double> alpha(const RunRecord& run) { return run.alpha_lower; }
std::optional<double> alpha_over_log(const RunRecord& run) { return *run.alpha_lower / std::log(run.n); }

const RunRecord& largest(const Runs& runs) {
  return **std::max_element(runs.begin(), runs.end(),
                            [](const RunRecord* a, const RunRecord* b) { return *a->alpha_lower < *b->alpha_lower; });
}

bool are_proved(const Runs& runs) {
  return std::all_of(runs.begin(), runs.end(), [](const RunRecord* run) { return run->optimality == "proved"; });
}

// The two steps at which the source report's proof fails, the second with what was measured instead.
std::string false_steps(const Runs& runs) {
  const auto groups = by_family(runs);
  const auto uniform = groups.find("uniform");
  if (uniform == groups.end()) return "";
  const auto law = growth_of(uniform->second, [](const RunRecord& run) { return run.optimum_upper; });
  if (!law) return "";
  return "; the proof's false steps: w(T0) <= w(T*) (see C7: hull_bound_counterexample), and w(T*) = Omega(n) (uniform "
         "points: w(T*) ~ n^" +
         fixed(law->exponent.value, 2) + ")";
}

// What all families come to.
struct AlphaGrowth {
  bool beyond_log = false;  // somewhere alpha outgrows log n
  bool nowhere_beyond_log = true;
  std::string steepest;  // the family where alpha grows fastest
  double exponent = -1;
  std::string on_uniform;
};

AlphaGrowth alpha_growth_by_family(const Runs& rows, ClaimDetails& details) {
  AlphaGrowth growth;
  details.header = {"family", "sizes", "alpha ~ n^e: e (95%)", "alpha / log n ~ n^e: e (95%)", "largest alpha"};
  for (const auto& [family, runs] : by_growing_family(rows)) {
    const auto law = growth_of(runs, alpha), over_log = growth_of(runs, alpha_over_log);
    if (!law || !over_log) continue;
    growth.beyond_log = growth.beyond_log || over_log->exponent.lower > kClearAlphaGrowth;
    growth.nowhere_beyond_log = growth.nowhere_beyond_log && over_log->exponent.upper <= 0 && are_proved(runs);
    details.rows.push_back({family, size_range(runs), exponent_text(*law), exponent_text(*over_log),
                            significant(*largest(runs).alpha_lower, 4)});
    if (family == "uniform") growth.on_uniform = exponent_text(*law);
    if (law->exponent.value > growth.exponent) growth.steepest = family, growth.exponent = law->exponent.value;
  }
  return growth;
}

Finding judge_insertion_logarithmic(const StudyRecords& records) {
  Finding finding;
  finding.rows = finished_runs(records, [](const RunRecord& run) {
    return run.algorithm == "hull_insertion" && named_value(run.params, "order") == "index" &&
           run.n >= kMinInsertionN && run.alpha_lower;
  });
  const AlphaGrowth growth = alpha_growth_by_family(finding.rows, finding.details);
  finding.missing = fmt::format(
      "finished runs of hull_insertion (order=index) at three sizes of some family, from n = {}, with a certified "
      "alpha",
      kMinInsertionN);
  if (finding.details.rows.empty()) return finding;
  finding.missing =
      "nowhere does alpha surely outgrow log n, nor is that excluded everywhere (see the intervals of alpha / log n); "
      "larger sizes, or proofs of all optima, would decide";
  finding.verdict = growth.beyond_log           ? ClaimVerdict::refuted
                    : growth.nowhere_beyond_log ? ClaimVerdict::holds
                                                : ClaimVerdict::undecided;
  if (!growth.on_uniform.empty()) finding.measured = "alpha on uniform points ~ n^" + growth.on_uniform + "; ";
  const RunRecord& top = largest(finding.rows);
  finding.measured +=
      fmt::format("steepest on {}: n^{:.2f}; largest alpha {} ({}, n = {}){}", growth.steepest, growth.exponent,
                  significant(*top.alpha_lower, 3), top.generator, grouped(top.n), false_steps(finding.rows));
  return finding;
}

}  // namespace

Claim insertion_logarithmic() {
  return {
      "C6",
      "Hull DP + insertion is an O(log n) approximation, and near-optimal in practice",
      "5.2.6",
      "hull_insertion (order=index) on every family with at least three sizes from n = 50: the certified lower ends of "
      "alpha",
      "on each family alpha / log n is fitted as a power of n: refuted if somewhere the exponent's lower 95% limit "
      "exceeds 0.05; holds if everywhere the upper limit is at most 0 and all optima are proved; otherwise undecided",
      "mwt generate uniform --n 100000 --seed 1 -o p.csv && mwt solve p.csv --algorithm hull_insertion --with-optimum",
      judge_insertion_logarithmic};
}

}  // namespace mwt::claims
