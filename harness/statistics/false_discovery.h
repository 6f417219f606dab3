// Many tests at once: how to keep the share of false alarms among the alarms small.
#pragma once

#include <span>
#include <vector>

namespace mwt {

/// The adjusted p-values of Y. Benjamini, Y. Hochberg, "Controlling the false discovery rate", J. Royal Statistical
/// Society B 57 (1995), in the order of the arguments: rejecting those that are at most q keeps the expected share of
/// false rejections at most q, for independent tests and for positively dependent ones (Benjamini, Yekutieli 2001).
/// The i-th smallest of m is multiplied by m / i, and none is larger than that of a larger p-value. Same as R's
/// p.adjust(p, "BH"). Time O(m log m).
///
/// Precondition: all in [0, 1]; std::invalid_argument otherwise.
[[nodiscard]] std::vector<double> benjamini_hochberg(std::span<const double> p_values);

}  // namespace mwt
