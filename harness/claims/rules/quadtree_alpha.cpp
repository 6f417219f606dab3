// C13: how good the quadtree triangulation is.
#include <fmt/core.h>

#include <algorithm>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"
#include "harness/statistics/quantile.h"

namespace mwt::claims {

namespace {

constexpr Index kMinQuadtreeN = 20;
constexpr std::size_t kMinQuadtreeInstances = 30;
constexpr double kGood = 1.5;  // the upper end of what the source report calls near-optimal of greedy
constexpr double kClearQuadtreeGrowth = 0.05;

std::optional<PowerLaw> growth_on_uniform(const Runs& runs) {
  const auto groups = by_family(runs);
  const auto uniform = groups.find("uniform");
  if (uniform == groups.end()) return std::nullopt;
  return growth_of(uniform->second, [](const RunRecord& run) { return run.alpha_upper; });
}

ClaimVerdict quadtree_verdict(const std::vector<double>& values, const PowerLaw& growth) {
  if (quantile(values, 0.95) > kGood || growth.exponent.lower > kClearQuadtreeGrowth) return ClaimVerdict::refuted;
  return growth.exponent.upper <= kClearQuadtreeGrowth ? ClaimVerdict::holds : ClaimVerdict::undecided;
}

std::string quadtree_missing(std::size_t instances, const std::optional<PowerLaw>& growth) {
  if (instances < kMinQuadtreeInstances)
    return fmt::format("{} instances, {} are needed", instances, kMinQuadtreeInstances);
  if (!growth) return "rated runs on uniform points at three sizes";
  return "growth on uniform points is neither sure nor excluded; more sizes would decide";
}

Finding judge_quadtree_alpha(const StudyRecords& records) {
  Finding finding;
  const Runs everywhere =
      rated_runs(records, [](const RunRecord& run) { return run.algorithm == "quadtree" && run.n >= kMinQuadtreeN; });
  std::copy_if(everywhere.begin(), everywhere.end(), std::back_inserter(finding.rows),
               [](const RunRecord* run) { return is_typical(*run); });
  const std::optional<PowerLaw> growth = growth_on_uniform(finding.rows);
  if (finding.rows.empty()) return finding;
  const std::vector<double> values = alphas(finding.rows);
  finding.missing = quadtree_missing(values.size(), growth);
  if (growth && values.size() >= kMinQuadtreeInstances) finding.verdict = quadtree_verdict(values, *growth);
  const RunRecord& largest = worst(everywhere);
  finding.measured = fmt::format("alpha on random points: mean {:.4f}, 95% below {:.4f} ({})", mean(values),
                                 quantile(values, 0.95), size_range(finding.rows));
  if (growth) finding.measured += ", on uniform points ~ n^" + exponent_text(*growth);
  finding.measured += fmt::format("; no bound in general: {} on {}, n = {}", significant(*largest.alpha_upper, 3),
                                  largest.generator, grouped(largest.n));
  return finding;
}

}  // namespace

Claim quadtree_alpha() {
  return {
      "C13",
      "The quadtree triangulation is a good approximation (no figure given)",
      "5.4",
      "quadtree on uniform, normal and clustered points and on points from files, from n = 20, against proved optima",
      "read as alpha at most 1.5, the source report's word for near-optimal: holds if 95% of the runs are within it "
      "and alpha on uniform points does not grow (exponent's upper 95% limit at most 0.05); refuted if fewer are, or "
      "it does; undecided with fewer than 30 instances or between",
      "mwt generate uniform --n 100000 --seed 1 -o p.csv && mwt solve p.csv --algorithm quadtree --with-optimum",
      judge_quadtree_alpha};
}

}  // namespace mwt::claims
