// Many tests at once: how to keep the chance of any false alarm small.
#pragma once

#include <span>
#include <vector>

namespace mwt {

/// The adjusted p-values of S. Holm, "A simple sequentially rejective multiple test procedure", Scandinavian Journal of
/// Statistics 6 (1979), in the order of the arguments: rejecting those that are at most q keeps the probability of any
/// false rejection at most q, however the tests depend on each other. The i-th smallest of m is multiplied by
/// m - i + 1, and none is smaller than that of a smaller p-value. Same as R's p.adjust(p, "holm"). Time O(m log m).
///
/// Precondition: all in [0, 1]; std::invalid_argument otherwise.
[[nodiscard]] std::vector<double> holm_adjusted(std::span<const double> p_values);

}  // namespace mwt
