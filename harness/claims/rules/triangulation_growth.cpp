// C15: whether 4^n bounds the number of triangulations.
#include <fmt/core.h>

#include "harness/claims/rules/rules.h"
#include "harness/claims/rules/triangulation_numbers.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

constexpr Index kMinCountedN = 12;
constexpr double kClaimedFactor = 4;

Finding judge_triangulation_growth(const StudyRecords& records) {
  Finding finding;
  finding.details.header = {"family", "sizes", "factor per point (95%)"};
  bool some_above = false, all_within = true;
  std::string figures;
  for (const auto& [family, growth] : growth_factors(counting_runs(records), kMinCountedN)) {
    finding.rows.insert(finding.rows.end(), growth.runs.begin(), growth.runs.end());
    finding.details.rows.push_back({family, size_range(growth.runs), factor_text(growth.factor)});
    some_above = some_above || growth.factor.lower > kClaimedFactor;
    all_within = all_within && growth.factor.upper <= kClaimedFactor;
    figures += (figures.empty() ? "" : ", ") + family + " " + factor_text(growth.factor);
  }
  finding.missing = fmt::format("counts at three sizes of some family, from n = {}", kMinCountedN);
  if (finding.rows.empty()) return finding;
  finding.missing = "some factor's interval holds 4; more sizes would narrow it";
  finding.verdict = some_above ? ClaimVerdict::refuted : all_within ? ClaimVerdict::holds : ClaimVerdict::undecided;
  finding.measured =
      fmt::format("each further point multiplies the number by {} ({}); 4 is the limit in convex position only",
                  figures, size_range(finding.rows));
  return finding;
}

}  // namespace

Claim triangulation_growth() {
  return {
      "C15",
      "The number of triangulations of random points is asymptotically O(4^n)",
      "4.2",
      "counts of subset_dp and brute_force on every family with at least three sizes from n = 12",
      "on each family log(number) is fitted as a line in n: refuted if its growth factor's lower 95% limit exceeds 4 "
      "somewhere; holds if the upper limits are at most 4 everywhere; otherwise undecided",
      "mwt generate uniform --n 18 --seed 1 -o p.csv && mwt solve p.csv --algorithm subset_dp",
      judge_triangulation_growth};
}

}  // namespace mwt::claims
