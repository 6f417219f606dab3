// Tests of "are these values larger?" that assume no distribution and that no outlier can sway: exact rank tests.
//
// Both are one-sided and permutation tests: under the null hypothesis every arrangement of the ranks is equally likely,
// and the p-value is the share of arrangements that are at least as extreme as the one seen, counted exactly, ties
// included (tied values share their mean rank). For many values (see below) the normal approximation with the variance
// of the actual ranks and a continuity correction is used instead. Deterministic.
#pragma once

#include <cstddef>
#include <span>

namespace mwt {

/// Up to this many values altogether the p-values are exact.
inline constexpr std::size_t kExactRankTestSize = 100;

/// F. Wilcoxon, "Individual comparisons by ranking methods", Biometrics Bulletin 1 (1945): the p-value of "the
/// differences are distributed symmetrically about 0" (or about something less) against "they tend to be larger".
/// Differences of 0 are ranked with the others and then left out (J. W. Pratt 1959). 1 if there is no other difference.
///
/// With k differences the smallest possible p-value is 2^-k: with five pairs it is 0.03.
/// Precondition: no NaN; std::invalid_argument otherwise. Time O(k^3) while exact.
[[nodiscard]] double signed_rank_p_value(std::span<const double> differences);

/// Wilcoxon's rank-sum test (H. B. Mann, D. R. Whitney 1947): the p-value of "both samples have the same distribution"
/// against "the second one's values tend to be larger". 1 if a sample is empty.
///
/// The smallest possible p-value is 1 / C(a + b, a): with 3 values against 3 it is 0.05.
/// Precondition: no NaN; std::invalid_argument otherwise. Time O((a + b)^4) while exact.
[[nodiscard]] double rank_sum_p_value(std::span<const double> first, std::span<const double> second);

}  // namespace mwt
