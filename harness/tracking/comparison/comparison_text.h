// A comparison for people and for programs.
#pragma once

#include <string>

#include "harness/tracking/comparison/comparison.h"
#include "harness/tracking/comparison/settle.h"

namespace mwt {

/// The verdict in one sentence: "1 regression (time of greedy x1.150 (1.121 .. 1.180), by itself in 5 of 8 cells), 0
/// improvements, 1 unclear (time of flip x1.031 (0.98 .. 1.09)) in 48 cells". Factors have their 95% intervals.
[[nodiscard]] std::string verdict_line(const Comparison& comparison);

/// The verdict, notes, exact findings, the table of algorithms, and the cells that differ or are unclear (all with
/// `every_cell`).
[[nodiscard]] std::string comparison_text(const Comparison& comparison, bool every_cell);

/// The same as GitHub's Markdown.
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison, bool every_cell);

/// One object: outcome, verdict, regression, threshold, error_rate, paired, time_measure, compared_cells, notes,
/// base_commit, new_commit, only_in_base, only_in_new, untimed, algorithms and cells (algorithm, instance,
/// observations, base and now (cells only), ratio, ratio_lower, ratio_upper, q_slower, q_faster, verdict), findings
/// (algorithm, instance, aspect, regression, confirmed, text).
[[nodiscard]] std::string comparison_json(const Comparison& comparison);

/// Of folders and the runs in turn that settled them. The JSON object: outcome, verdict, regression, suspected (the
/// folders) and confirmed (in turn; null if nothing was open) as comparison_json(), not_run.
[[nodiscard]] std::string verdict_line(const Settled& settled);
[[nodiscard]] std::string settled_text(const Settled& settled, bool every_cell);
[[nodiscard]] std::string settled_markdown(const Settled& settled, bool every_cell);
[[nodiscard]] std::string settled_json(const Settled& settled);

}  // namespace mwt
