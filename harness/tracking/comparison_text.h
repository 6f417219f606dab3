// A comparison for people and for programs.
#pragma once

#include <string>

#include "harness/tracking/comparison.h"

namespace mwt {

/// The verdict in one sentence: "1 regression (time of greedy x1.150), 0 improvements in 48 cells".
[[nodiscard]] std::string verdict_line(const Comparison& comparison);

/// The verdict, notes, exact findings, the table of algorithms, and the cells that are not `same` (all with
/// `every_cell`).
[[nodiscard]] std::string comparison_text(const Comparison& comparison, bool every_cell);

/// The same as GitHub's Markdown.
[[nodiscard]] std::string comparison_markdown(const Comparison& comparison, bool every_cell);

/// One object: verdict, regression, threshold, error_rate, paired, time_measure, compared_cells, notes, algorithms and
/// cells (algorithm, instance, observations, base, now, ratio, ratio_lower, ratio_upper, q_slower, q_faster, verdict),
/// findings (algorithm, instance, aspect, regression, text).
[[nodiscard]] std::string comparison_json(const Comparison& comparison);

}  // namespace mwt
