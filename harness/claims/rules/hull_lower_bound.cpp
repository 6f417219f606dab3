// C7: whether the hull's optimal triangulation weighs no more than the optimum of all points.
#include <fmt/core.h>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

// A certified lower end of w(T0), as hull_insertion counts it.
std::optional<double> hull_weight(const RunRecord& run) { return named_number(run.counters, "hull_weight"); }

// In certified ends only: w(T0) > w(T*) for sure.
bool contradicts(const RunRecord& run) { return *hull_weight(run) > *run.optimum_upper; }

Finding judge_hull_lower_bound(const StudyRecords& records) {
  Finding finding;
  finding.rows = rated_runs(records, [](const RunRecord& run) {
    return run.algorithm == "hull_insertion" && hull_weight(run) && run.optimum_upper;
  });
  if (finding.rows.empty()) return finding;
  std::size_t contradictions = 0;
  const RunRecord* clearest = nullptr;
  for (const RunRecord* run : finding.rows) {
    if (!contradicts(*run)) continue;
    ++contradictions;
    const auto ratio = [](const RunRecord& of) { return *hull_weight(of) / *of.optimum_upper; };
    if (clearest == nullptr || ratio(*run) > ratio(*clearest)) clearest = run;
  }
  finding.measured = grouped(contradictions) + " of " + grouped(finding.rows.size()) + " instances contradict it";
  finding.verdict = contradictions > 0 ? ClaimVerdict::refuted : ClaimVerdict::holds;
  if (clearest != nullptr) {
    finding.measured +=
        fmt::format("; on {} (n = {}) w(T0) = {:.3f} > w(T*) = {:.3f}: an inner point may make the optimum lighter",
                    clearest->generator, grouped(clearest->n), *hull_weight(*clearest), *clearest->optimum_upper);
  }
  return finding;
}

}  // namespace

Claim hull_lower_bound() {
  return {
      "C7",
      "The hull's optimal triangulation is a lower bound: w(T0) <= w(T*)",
      "5.2.4",
      "hull_insertion on every instance with a proved optimum: its counter hull_weight is w(T0)",
      "refuted: the certified lower end of w(T0) exceeds the upper end of the optimum somewhere; holds: nowhere",
      "mwt generate hull_bound_counterexample -o p.csv && mwt solve p.csv --algorithm hull_insertion --with-optimum "
      "--json",
      judge_hull_lower_bound};
}

}  // namespace mwt::claims
