// C5: greedy's worst case.
#include <fmt/core.h>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

// The fastest growth on any family.
struct Steepest {
  std::string family;
  PowerLaw law;
};

std::optional<Steepest> steepest_of(const Runs& runs) {
  std::optional<Steepest> steepest;
  for (const auto& [family, of_family] : by_growing_family(runs)) {
    const auto law = growth_of(of_family, [](const RunRecord& run) { return run.alpha_upper; });
    if (!law) continue;
    if (!steepest || law->exponent.value > steepest->law.exponent.value) steepest = {family, *law};
  }
  return steepest;
}

Finding judge_greedy_linear_bound(const StudyRecords& records) {
  Finding finding;
  finding.rows = rated_runs(records, is_greedy);
  const std::optional<Steepest> steepest = steepest_of(finding.rows);
  finding.missing = "rated runs of greedy or greedy_naive at three sizes of some family";
  if (!steepest) return finding;
  bool is_below_n = true;
  for (const RunRecord* run : finding.rows) is_below_n = is_below_n && *run->alpha_upper <= run->n;
  const RunRecord& largest = worst(finding.rows);
  if (steepest->law.exponent.lower > 1) {
    finding.verdict = ClaimVerdict::refuted;
  } else if (is_below_n && steepest->law.exponent.upper <= 1) {
    finding.verdict = ClaimVerdict::holds;
  }
  finding.missing = is_below_n
                        ? "the exponent's interval on " + steepest->family + " holds 1; more sizes would narrow it"
                        : "some alpha is above n, at sizes too small to show growth";
  finding.measured = fmt::format(
      "steepest on {}: alpha grows like n^{}; largest alpha {} at n = {} on {}. The worst case is Theta(sqrt n) "
      "(Levcopoulos, Krznaric 1998)",
      steepest->family, exponent_text(steepest->law), significant(*largest.alpha_upper, 4), grouped(largest.n),
      largest.generator);
  return finding;
}

}  // namespace

Claim greedy_linear_bound() {
  return {"C5",
          "Greedy is never worse than O(n) times the optimum",
          "5.1.4",
          "greedy_naive and greedy on every family, against proved optima",
          "holds: alpha <= n everywhere, and on the family where it grows fastest the exponent's upper 95% limit is at "
          "most 1; refuted: its lower limit is above 1; otherwise undecided",
          "mwt generate greedy_corridor --n 1000 -o p.csv && mwt solve p.csv --algorithm greedy --with-optimum",
          judge_greedy_linear_bound};
}

}  // namespace mwt::claims
