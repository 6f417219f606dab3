// Quantiles of a sample, by the definition that R, NumPy and pandas use by default.
#pragma once

#include <span>

namespace mwt {

/// The sample quantile of type 7 of Hyndman and Fan, "Sample quantiles in statistical packages", The American
/// Statistician 50 (1996): linear between the order statistics, so that quantile(x, 0) is the smallest and
/// quantile(x, 1) the largest value.
///
/// Preconditions: the sample is not empty, holds no NaN; 0 <= p <= 1. Throws std::invalid_argument otherwise.
/// O(n) expected.
[[nodiscard]] double quantile(std::span<const double> sample, double p);

/// quantile(sample, 0.5): the middle value, or the mean of the two middle ones.
[[nodiscard]] double median(std::span<const double> sample);

/// As quantile(), without a copy: leaves `sample` in another order.
[[nodiscard]] double quantile_in_place(std::span<double> sample, double p);

}  // namespace mwt
