// C6: hull DP + insertion as an O(log n) approximation.
#include <cmath>

#include "harness/claims/report_claims.h"
#include "harness/claims/selection.h"
#include "harness/text.h"

namespace mwt::claims {

namespace {

constexpr Index kSmallestN = 50;
constexpr double kClearGrowth = 0.05;

std::optional<double> alpha_over_log(const RunRecord& run) { return *run.alpha_upper / std::log(run.n); }
std::optional<double> alpha(const RunRecord& run) { return run.alpha_upper; }

// The two steps at which the report's proof fails, the second with what was measured instead.
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

Finding judge(const StudyRecords& records) {
  Finding finding;
  finding.rows = rated_runs(records, [](const RunRecord& run) {
    return run.algorithm == "hull_insertion" && named_value(run.params, "order") == "index" && run.n >= kSmallestN;
  });
  finding.details.header = {"family", "sizes", "alpha ~ n^e: e (95%)", "alpha / log n ~ n^e: e (95%)", "largest alpha"};
  double steepest = -1;
  bool grows = false, all_bounded = true;
  for (const auto& [family, runs] : by_growing_family(finding.rows)) {
    const auto law = growth_of(runs, alpha), over_log = growth_of(runs, alpha_over_log);
    if (!law || !over_log) continue;
    grows = grows || over_log->exponent.lower > kClearGrowth;
    all_bounded = all_bounded && over_log->exponent.upper <= 0;
    finding.details.rows.push_back({family, size_range(runs), exponent_text(*law), exponent_text(*over_log),
                                    significant(*worst(runs).alpha_upper, 4)});
    if (family == "uniform") finding.measured += "alpha on uniform points ~ n^" + exponent_text(*law) + "; ";
    if (law->exponent.value <= steepest) continue;
    steepest = law->exponent.value;
  }
  if (finding.details.rows.empty()) return finding;
  finding.verdict = grows ? ClaimVerdict::refuted : all_bounded ? ClaimVerdict::holds : ClaimVerdict::undecided;
  const RunRecord& largest = worst(finding.rows);
  finding.measured += "steepest exponent " + fixed(steepest, 2) + "; largest alpha " +
                      significant(*largest.alpha_upper, 3) + " (" + largest.generator + ", n = " + grouped(largest.n) +
                      ")" + false_steps(finding.rows);
  return finding;
}

}  // namespace

Claim insertion_logarithmic() {
  return {
      "C6",
      "Hull DP + insertion is an O(log n) approximation, and near-optimal in practice",
      "5.2.6",
      "hull_insertion (order=index) on every family with at least three sizes from n = 50, against proved optima",
      "on each family alpha / log n is fitted as a power of n: refuted if somewhere the exponent's lower 95% limit "
      "exceeds 0.05; holds if everywhere the upper limit is at most 0; otherwise undecided",
      "mwt generate uniform --n 100000 --seed 1 -o p.csv && mwt solve p.csv --algorithm hull_insertion --with-optimum",
      judge};
}

}  // namespace mwt::claims
