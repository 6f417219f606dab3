// C10: how likely local search ends near the optimum.
#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"
#include "harness/statistics/binomial_interval.h"

namespace mwt::claims {

namespace {

constexpr Index kMinSearchN = 20;
constexpr double kProbability = 0.5;  // the claim: above 1 - delta, delta at most one half
// The source report's own, from the harder end; then harder questions.
constexpr std::array<double, 4> kEpsilons = {0.1, 0.2, 0.01, 0.001};
constexpr double kDecidingEpsilon = 0.1;

struct Cell {
  std::string start;
  Index n = 0;

  friend auto operator<=>(const Cell&, const Cell&) = default;
};

std::map<Cell, Runs> cells_of(const Runs& runs) {
  std::map<Cell, Runs> cells;
  for (const RunRecord* run : runs)
    cells[{named_value(run->params, "start").value_or("delaunay"), run->n}].push_back(run);
  return cells;
}

std::uint64_t successes(const Runs& runs, double epsilon) {
  return static_cast<std::uint64_t>(
      std::count_if(runs.begin(), runs.end(), [&](const RunRecord* run) { return *run->alpha_upper < 1 + epsilon; }));
}

// What one epsilon comes to over all cells.
struct Summary {
  std::vector<std::string> open_cells;  // whose interval holds one half
  std::uint64_t successes = 0;
  double min_lower = 1;
  bool every_cell_above = true;
  bool some_cell_below = false;
};

Summary add_rows(const std::map<Cell, Runs>& cells, double epsilon, ClaimDetails& details) {
  Summary summary;
  for (const auto& [cell, runs] : cells) {
    const std::uint64_t count = successes(runs, epsilon);
    const ProbabilityInterval interval = clopper_pearson(count, runs.size());
    details.rows.push_back({cell.start, std::to_string(cell.n), significant(epsilon, 1), std::to_string(count),
                            std::to_string(runs.size()), fixed(interval.lower, 3), fixed(interval.upper, 3)});
    summary.successes += count;
    summary.min_lower = std::min(summary.min_lower, interval.lower);
    summary.every_cell_above = summary.every_cell_above && interval.lower > kProbability;
    summary.some_cell_below = summary.some_cell_below || interval.upper <= kProbability;
    if (interval.lower <= kProbability)
      summary.open_cells.push_back(
          fmt::format("start={} n={} ({} of {})", cell.start, grouped(cell.n), count, runs.size()));
  }
  return summary;
}

Finding judge_local_search_probability(const StudyRecords& records) {
  Finding finding;
  finding.rows = rated_runs(records, [](const RunRecord& run) {
    return run.algorithm == "flip_naive" && run.generator == "uniform" && run.n >= kMinSearchN &&
           named_value(run.params, "improvement") == "first";
  });
  if (finding.rows.empty()) return finding;
  const std::map<Cell, Runs> cells = cells_of(finding.rows);
  finding.details.header = {"start", "n", "epsilon", "successes", "runs", "probability at least", "at most"};
  std::string harder;
  for (const double epsilon : kEpsilons) {
    const Summary summary = add_rows(cells, epsilon, finding.details);
    const std::string share = grouped(summary.successes) + " of " + grouped(finding.rows.size());
    if (epsilon == kDecidingEpsilon) {
      if (summary.every_cell_above) finding.verdict = ClaimVerdict::holds;
      if (summary.some_cell_below) finding.verdict = ClaimVerdict::refuted;
      finding.missing = "more finished runs of: " + joined(summary.open_cells) +
                        "; six successes of six are the fewest that show P > 1/2";
      finding.measured = fmt::format(
          "{} runs end below 1.1 OPT (uniform, {}); in every cell of n and start P >= {:.2f} with 95% confidence",
          share, size_range(finding.rows), summary.min_lower);
    } else if (epsilon < kDecidingEpsilon) {
      harder += "; below " + significant(1 + epsilon, epsilon < 0.005 ? 4 : 3) + " OPT: " + share;
    }
  }
  finding.measured += harder;
  return finding;
}

}  // namespace

Claim local_search_probability() {
  return {
      "C10",
      "Local search: P[weight < (1+eps) OPT] > 1 - delta with eps in [0.1, 0.2], delta <= 0.5, n >= 20",
      "5.3.4",
      "flip_naive (improvement=first) on uniform points from n = 20, for every start and n, against proved optima",
      "with the exact 95% interval (Clopper-Pearson) for the probability at eps = 0.1 in every cell of n and start: "
      "holds if all lie above one half; refuted if one does not reach above it; otherwise undecided. eps = 0.2 follows "
      "from 0.1",
      "mwt generate uniform --n 100000 --seed 1 -o p.csv && mwt solve p.csv --algorithm flip_naive --param start=sweep "
      "--with-optimum",
      judge_local_search_probability};
}

}  // namespace mwt::claims
