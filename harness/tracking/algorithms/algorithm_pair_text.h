// A comparison of two algorithms for people and for programs.
#pragma once

#include <string>

#include "harness/tracking/algorithms/algorithm_pair.h"

namespace mwt {

/// One sentence for alpha and one for time, over all instances: "alpha: patch is better on 40 of 44 instances, equal on
/// 2: x0.9712 (0.9650 .. 0.9771)".
[[nodiscard]] std::string summary_of(const AlgorithmPair& pair);

/// The sentences, notes, and a table for alpha and one for time.
[[nodiscard]] std::string algorithm_pair_text(const AlgorithmPair& pair);

/// The same as GitHub's Markdown.
[[nodiscard]] std::string algorithm_pair_markdown(const AlgorithmPair& pair);

/// One object: folder, a, b, time_measure, error_rate, notes, alpha and times (family, n (0: all), a and b (medians,
/// where known), pairs, b_better, equal, a_better, ratio, ratio_lower and ratio_upper (null: too few pairs), effect, p,
/// q, verdict).
[[nodiscard]] std::string algorithm_pair_json(const AlgorithmPair& pair);

}  // namespace mwt
