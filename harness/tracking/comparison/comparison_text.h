// A comparison for people and for programs.
#pragma once

#include <string>

#include "harness/tracking/comparison/comparison.h"
#include "harness/tracking/comparison/settle.h"

namespace mwt {

/// The verdict in one sentence: "1 regression (time of greedy x1.150), 0 improvements, 2 unclear (time of flip x1.031;
/// time of sweep x0.992) in 48 cells".
[[nodiscard]] std::string verdict_line(const Comparison& comparison);

/// The verdict, notes, exact findings, the table of algorithms, and the cells that differ or are unclear (all with
/// `every_cell`).
[[nodiscard]] std::string comparison_text(const Comparison& comparison, bool every_cell);

/// The same as GitHub's Markdown.
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison, bool every_cell);

/// One object: outcome, verdict, regression, threshold, error_rate, paired, time_measure, compared_cells, notes,
/// only_in_base, only_in_new, untimed, algorithms and cells (algorithm, instance, observations, base and now (cells
/// only), ratio, ratio_lower, ratio_upper, q_slower, q_faster, verdict), findings (algorithm, instance, aspect,
/// regression, text).
[[nodiscard]] std::string comparison_json(const Comparison& comparison);

/// Of folders and the runs in turn that settled them. The JSON object: outcome, verdict, regression, suspected (the
/// folders) and confirmed (in turn; null if nothing was open) as comparison_json(), not_run.
[[nodiscard]] std::string verdict_line(const Settled& settled);
[[nodiscard]] std::string settled_text(const Settled& settled, bool every_cell);
[[nodiscard]] std::string settled_markdown(const Settled& settled, bool every_cell);
[[nodiscard]] std::string settled_json(const Settled& settled);

}  // namespace mwt
