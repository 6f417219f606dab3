// By how much values are shifted: the estimates that belong to the rank tests (rank_tests.h).
#pragma once

#include <span>

#include "harness/statistics/bootstrap.h"

namespace mwt {

/// The median of the means of all pairs of values, each with itself included: Hodges and Lehmann's estimate of the
/// centre of a symmetric distribution ("Estimates of location based on rank tests", Annals of Mathematical Statistics
/// 34, 1963). Nearly as precise as the mean for normal noise, and up to 29% of wild values cannot carry it away.
/// Precondition: not empty; no NaN; std::invalid_argument otherwise. O(n^2).
[[nodiscard]] double pseudo_median(std::span<const double> values);

/// The median of the differences of all values of `second` from all of `first`: Hodges and Lehmann's estimate of how
/// far the second sample is shifted. Precondition: neither empty; no NaN; std::invalid_argument otherwise. O(n m).
[[nodiscard]] double shift_between(std::span<const double> first, std::span<const double> second);

[[nodiscard]] Estimate bootstrap_pseudo_median(std::span<const double> values, const BootstrapOptions& options = {});

/// The two samples are drawn independently.
[[nodiscard]] Estimate bootstrap_shift(std::span<const double> first, std::span<const double> second,
                                       const BootstrapOptions& options = {});

}  // namespace mwt
