// C8: what inserting one interior point costs.
#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

constexpr Index kMinStepN = 20;
constexpr double kClearStepGrowth = 0.05;
// In the unit square an insertion adds three edges of at most sqrt 2 each.
constexpr double kMaxInUnitSquare = 3 * std::numbers::sqrt2;
constexpr const char* kUnitSquare = "uniform";

// The mean over all insertions: what the source report's proof sums up.
std::optional<double> increase(const RunRecord& run) {
  const auto hull = named_number(run.counters, "hull_weight"), points = named_number(run.counters, "interior_points");
  if (!hull || !points || !(*points > 0) || !run.weight_upper) return std::nullopt;
  return (*run.weight_upper - *hull) / *points;
}

std::optional<double> increase_over_log(const RunRecord& run) {
  const std::optional<double> value = increase(run);
  return value ? std::optional(*value / std::log(run.n)) : std::nullopt;
}

double max_increase(const Runs& runs) {
  double largest = 0;
  for (const RunRecord* run : runs) largest = std::max(largest, increase(*run).value_or(0));
  return largest;
}

struct StepGrowth {
  bool has_unit_square = false;
  bool holds_in_unit_square = false;
  bool fails_in_unit_square = false;
  bool fails_elsewhere = false;
  std::string steepest;
  double exponent = 0;
};

StepGrowth step_growth_by_family(const Runs& rows, ClaimDetails& details) {
  StepGrowth growth;
  details.header = {"family", "sizes", "increase ~ n^e: e (95%)", "increase / log n ~ n^e: e (95%)",
                    "largest mean increase"};
  for (const auto& [family, runs] : by_growing_family(rows)) {
    const auto law = growth_of(runs, increase), over_log = growth_of(runs, increase_over_log);
    if (!law || !over_log) continue;
    const double largest = max_increase(runs);
    details.rows.push_back(
        {family, size_range(runs), exponent_text(*law), exponent_text(*over_log), significant(largest, 4)});
    const bool fails = over_log->exponent.lower > kClearStepGrowth;
    if (family == kUnitSquare) {
      growth.has_unit_square = true;
      growth.fails_in_unit_square = fails;
      growth.holds_in_unit_square = over_log->exponent.upper <= 0 && largest <= kMaxInUnitSquare;
    } else if (fails) {
      growth.fails_elsewhere = true;
      if (law->exponent.value > growth.exponent) growth.steepest = family, growth.exponent = law->exponent.value;
    }
  }
  return growth;
}

Finding judge_insertion_step(const StudyRecords& records) {
  Finding finding;
  finding.rows = finished_runs(records, [](const RunRecord& run) {
    return run.algorithm == "hull_insertion" && run.n >= kMinStepN && increase(run);
  });
  const StepGrowth growth = step_growth_by_family(finding.rows, finding.details);
  const auto groups = by_family(finding.rows);
  const auto unit_square = groups.find(kUnitSquare);
  finding.missing =
      fmt::format("finished runs of hull_insertion on {} at three sizes, from n = {}", kUnitSquare, kMinStepN);
  if (unit_square == groups.end()) return finding;
  if (growth.has_unit_square)
    finding.missing = "in the unit square growth is neither sure nor excluded; larger sizes would decide";
  if (growth.fails_in_unit_square) {
    finding.verdict = ClaimVerdict::refuted;
  } else if (growth.holds_in_unit_square) {
    finding.verdict = growth.fails_elsewhere ? ClaimVerdict::ill_posed : ClaimVerdict::holds;
  }
  finding.measured = "in the unit square (uniform) an insertion adds at most " +
                     significant(max_increase(unit_square->second), 3) +
                     " on average over a run (never above 3 sqrt 2)";
  if (growth.fails_elsewhere) {
    finding.measured += fmt::format(
        ", but where coordinates grow with n it outgrows log n: on {} like n^{:.2f}. The claim depends on the unit of "
        "length, the optimum does not",
        growth.steepest, growth.exponent);
  }
  return finding;
}

}  // namespace

Claim insertion_step() {
  return {"C8",
          "Inserting one interior point increases the weight by at most O(log n)",
          "5.2.5",
          "hull_insertion on every family with at least three sizes from n = 20: (w(T) - w(T0)) / interior points",
          "the mean increase over log n is fitted as a power of n: in the unit square it may not grow (refuted if the "
          "lower 95% limit exceeds 0.05); ill-posed if it does not grow there but does elsewhere, for then the answer "
          "depends on the unit of length; holds if it grows nowhere; otherwise undecided",
          "mwt generate jittered_grid --n 1000 -o p.csv && mwt solve p.csv --algorithm hull_insertion --json",
          judge_insertion_step};
}

}  // namespace mwt::claims
