// C4: greedy's approximation factor in practice.
#include <fmt/core.h>

#include <algorithm>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"
#include "harness/statistics/binomial_interval.h"
#include "harness/statistics/quantile.h"

namespace mwt::claims {

namespace {

constexpr double kBandLow = 1.1;
constexpr double kBandHigh = 1.5;
constexpr std::size_t kMinInstances = 30;
constexpr std::size_t kMinToCompare = 10;

bool is_in_band(double alpha) { return alpha >= kBandLow && alpha <= kBandHigh; }

std::size_t count_in_band(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::count_if(values.begin(), values.end(), is_in_band));
}

double share_in_band(const std::vector<double>& values) {
  return static_cast<double>(count_in_band(values)) / static_cast<double>(values.size());
}

std::string percent(double share) { return fixed(100 * share, 1) + "%"; }

// One run per instance: where both versions of greedy ran they agree, and the literal one counts.
Runs one_per_instance(const Runs& runs) {
  std::map<std::string, const RunRecord*> chosen;
  for (const RunRecord* run : runs) {
    const RunRecord*& place = chosen[run->instance_id];
    if (place == nullptr || run->algorithm == "greedy_naive") place = run;
  }
  Runs result;
  for (const RunRecord* run : runs) {
    if (chosen.at(run->instance_id) == run) result.push_back(run);
  }
  return result;
}

std::vector<std::string> details_row(const std::string& algorithm, const std::string& family, const std::string& n,
                                     const Runs& runs) {
  const std::vector<double> values = alphas(runs);
  return {algorithm,
          family,
          n,
          std::to_string(values.size()),
          fixed(mean(values), 6),
          fixed(median(values), 6),
          fixed(quantile(values, 0.95), 6),
          fixed(*std::max_element(values.begin(), values.end()), 6),
          fixed(100 * share_in_band(values), 1)};
}

bool is_usual_configuration(const RunRecord& run) {
  if (run.algorithm == "flip_naive") return named_value(run.params, "start") == "delaunay";
  return run.algorithm != "hull_insertion" || named_value(run.params, "order") == "index";
}

ClaimDetails details_of(const StudyRecords& records) {
  ClaimDetails details{
      {"algorithm", "family", "n", "instances", "alpha mean", "alpha median", "alpha p95", "alpha max", "% in 1.1-1.5"},
      {}};
  const Runs rated =
      rated_runs(records, [](const RunRecord& run) { return is_typical(run) && is_usual_configuration(run); });
  for (const auto& [algorithm, of_algorithm] : by_algorithm(rated)) {
    for (const auto& [family, of_family] : by_family(of_algorithm)) {
      std::map<Index, Runs> by_size;
      for (const RunRecord* run : of_family) by_size[run->n].push_back(run);
      for (const auto& [n, runs] : by_size) {
        details.rows.push_back(details_row(algorithm, family, std::to_string(n), runs));
      }
    }
  }
  std::stable_partition(details.rows.begin(), details.rows.end(),
                        [](const auto& row) { return row.front() == "greedy" || row.front() == "greedy_naive"; });
  return details;
}

// "The band fits hull_insertion at n <= 20 (61.1%)": the algorithm and size with the largest share inside.
std::string best_fit(const StudyRecords& records) {
  const Runs rated = rated_runs(records, [](const RunRecord& run) { return is_typical(run) && !is_greedy(run); });
  std::map<std::pair<std::string, Index>, Runs> groups;
  for (const RunRecord* run : rated) groups[{run->algorithm, run->n}].push_back(run);
  std::string text;
  double best = 0;
  for (const auto& [key, runs] : groups) {
    if (runs.size() < kMinToCompare) continue;
    const double share = share_in_band(alphas(runs));
    if (share <= best) continue;
    best = share;
    text = fmt::format("; the band fits best {} at n = {} ({} inside)", key.first, grouped(key.second), percent(share));
  }
  return text;
}

ClaimVerdict verdict_of(const std::vector<double>& values) {
  if (values.size() < kMinInstances) return ClaimVerdict::undecided;
  const std::size_t inside = count_in_band(values);
  const ProbabilityInterval share = clopper_pearson(inside, values.size());
  if (share.lower > 0.5) return ClaimVerdict::reproduced;
  if (share.upper >= 0.5) return ClaimVerdict::undecided;
  const auto below = std::count_if(values.begin(), values.end(), [](double alpha) { return alpha < kBandLow; });
  const auto outside = static_cast<std::ptrdiff_t>(values.size() - inside);
  return 2 * below > outside ? ClaimVerdict::refuted_better : ClaimVerdict::refuted;
}

std::string missing_of(const std::vector<double>& values) {
  if (values.size() < kMinInstances) return fmt::format("{} instances, {} are needed", values.size(), kMinInstances);
  return "the interval for the share of instances inside 1.1-1.5 holds one half; more instances would narrow it";
}

Finding judge_greedy_alpha(const StudyRecords& records) {
  Finding finding;
  finding.rows =
      one_per_instance(rated_runs(records, [](const RunRecord& run) { return is_greedy(run) && is_typical(run); }));
  if (finding.rows.empty()) return finding;
  const std::vector<double> values = alphas(finding.rows);
  finding.verdict = verdict_of(values);
  finding.missing = missing_of(values);
  finding.measured = fmt::format(
      "alpha of greedy: mean {:.4f}, 95% below {:.4f}, largest {:.4f} on {} instances, {}; {} lie in 1.1-1.5{}",
      mean(values), quantile(values, 0.95), *std::max_element(values.begin(), values.end()), grouped(values.size()),
      size_range(finding.rows), percent(share_in_band(values)), best_fit(records));
  finding.details = details_of(records);
  return finding;
}

}  // namespace

Claim greedy_alpha() {
  return {
      "C4",
      "Greedy's alpha is in practice often close to 1.1-1.5, even for large n",
      "5.1.8",
      "greedy_naive and greedy (the same triangulation) on uniform, normal and clustered points and on points from "
      "files, against proved optima; one run per instance",
      "with the exact 95% interval for the share of instances inside 1.1-1.5: reproduced if it lies above one half; "
      "refuted if below, (better than claimed) if most of the others lie below 1.1; undecided with fewer than 30 "
      "instances or if it holds one half",
      "mwt generate uniform --n 100000 --seed 1 -o p.csv && mwt solve p.csv --algorithm greedy --with-optimum",
      judge_greedy_alpha};
}

}  // namespace mwt::claims
