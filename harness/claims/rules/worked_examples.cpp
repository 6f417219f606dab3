// C1, C2 and C9: the source report's worked examples. Their point sets have so few triangulations that a weight to the
// printed digits tells which one it is; worked_examples_test.cpp shows it.
#include <fmt/core.h>

#include <array>
#include <cmath>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"
#include "harness/io/text/text.h"

namespace mwt::claims {

namespace {

// A figure as the source report prints it.
struct Printed {
  double value;
  int digits;

  [[nodiscard]] bool is_rounding_of(double x) const { return std::abs(x - value) <= 0.5 * std::pow(10.0, -digits); }
};

constexpr std::uint64_t kTriangles = 12;  // 2 * 10 - 6 - 2
constexpr Printed kGreedyWeight{70.9586, 4};
constexpr Printed kInsertionWeight{86.5447479007, 10};

bool agrees(const RunRecord& run, const Printed& printed) {
  return run.weight_lower && run.weight_upper && printed.is_rounding_of(*run.weight_lower) &&
         printed.is_rounding_of(*run.weight_upper) && run.triangles == kTriangles;
}

Finding judge_weight(Runs runs, const Printed& printed) {
  Finding finding;
  finding.rows = std::move(runs);
  if (finding.rows.empty()) return finding;
  finding.verdict = ClaimVerdict::reproduced;
  for (const RunRecord* run : finding.rows) {
    if (!agrees(*run, printed)) finding.verdict = ClaimVerdict::refuted;
  }
  const RunRecord& first = *finding.rows.front();
  finding.measured =
      fmt::format("total {:.10f}, {} triangles", first.weight_upper.value_or(0), first.triangles.value_or(0));
  if (first.alpha_upper) finding.measured += "; alpha = " + fixed(*first.alpha_upper, 5);
  return finding;
}

Finding judge_greedy(const StudyRecords& records) {
  Finding finding = judge_weight(
      finished_runs(
          records,
          [](const RunRecord& run) { return run.generator == "report_example" && run.algorithm == "greedy_naive"; }),
      kGreedyWeight);
  if (!finding.rows.empty() && finding.rows.front()->optimal == "yes") finding.measured += ", the optimum itself";
  return finding;
}

Finding judge_insertion(const StudyRecords& records) {
  Finding finding = judge_weight(finished_runs(records,
                                               [](const RunRecord& run) {
                                                 return run.generator == "report_example" &&
                                                        run.algorithm == "hull_insertion" &&
                                                        named_value(run.params, "order") == "index";
                                               }),
                                 kInsertionWeight);
  if (!finding.rows.empty() && finding.rows.front()->perimeter_sum) {
    finding.measured += "; the sum of edge lengths, though the source report calls it a sum of perimeters (that is " +
                        fixed(*finding.rows.front()->perimeter_sum, 4) + ")";
  }
  return finding;
}

// The local search run: its state after 0, 1 and all flips.
struct State {
  const char* max_flips;
  Printed perimeters;
};
constexpr std::array<State, 3> kStates = {
    {{"0", {11.0751, 4}}, {"1", {10.9347, 4}}, {"-1", {10.7929, 4}}},
};
constexpr double kFlips = 2;

Runs runs_of_state(const StudyRecords& records, const State& state) {
  return finished_runs(records, [&](const RunRecord& run) {
    return run.generator == "local_search_figure" && run.algorithm == "flip_naive" &&
           named_value(run.params, "start") == "local_search_figure_start.csv" &&
           named_value(run.params, "max_flips") == state.max_flips;
  });
}

Finding judge_local_search(const StudyRecords& records) {
  Finding finding;
  bool all_agree = true, all_there = true;
  for (const State& state : kStates) {
    const Runs runs = runs_of_state(records, state);
    all_there = all_there && !runs.empty();
    for (const RunRecord* run : runs) {
      const double total = run->perimeter_sum.value_or(0);
      all_agree = all_agree && state.perimeters.is_rounding_of(total);
      finding.measured += (finding.measured.empty() ? "perimeters " : " -> ") + fixed(total, 4);
      finding.rows.push_back(run);
    }
  }
  finding.missing = "a finished run from the source report's start for each of max_flips = 0, 1, -1";
  if (!all_there) return finding;
  const std::optional<double> flips = named_number(finding.rows.back()->counters, "flips");
  finding.measured += " in " + fixed(flips.value_or(0), 0) + " flips";
  finding.verdict = all_agree && flips == kFlips ? ClaimVerdict::reproduced : ClaimVerdict::refuted;
  return finding;
}

}  // namespace

Claim greedy_example() {
  return {"C1",
          "Greedy on the ten points A .. J gives the 12 listed triangles, total weight 70.9586",
          "5.1.3",
          "greedy_naive on report_example",
          "reproduced: 12 triangles whose weight rounds to 70.9586, which one triangulation of these points has; "
          "refuted: any other",
          "mwt generate report_example -o p.csv && mwt solve p.csv --algorithm greedy_naive --with-optimum",
          judge_greedy};
}

Claim insertion_example() {
  return {"C2",
          "Hull DP + insertion on the same points gives the 12 listed triangles, total weight 86.5447479007",
          "5.2.3",
          "hull_insertion (order=index) on report_example",
          "reproduced: 12 triangles whose weight rounds to 86.5447479007, which one triangulation of these points has; "
          "refuted: any other",
          "mwt generate report_example -o p.csv && mwt solve p.csv --algorithm hull_insertion --with-optimum",
          judge_insertion};
}

Claim local_search_example() {
  return {"C9",
          "The local search run of Figures 7-11: sums of perimeters 11.0751 -> 10.9347 -> 10.7929",
          "5.3.1",
          "flip_naive on local_search_figure, from the source report's start, after 0, 1 and all flips",
          "reproduced: the three sums round to the printed ones and the run ends after two flips; refuted: any differs",
          "mwt generate local_search_figure -o p.csv && mwt solve p.csv --algorithm flip_naive --param "
          "start=harness/studies/local_search_figure_start.csv",
          judge_local_search};
}

}  // namespace mwt::claims
