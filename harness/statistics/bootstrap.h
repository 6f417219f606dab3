// Bootstrap confidence intervals: how far a statistic would move if the experiment were repeated.
//
// Percentile intervals: the statistic is computed on `resamples` samples drawn with replacement from the observations,
// and the interval holds the middle `confidence` of these values (B. Efron, R. J. Tibshirani, "An Introduction to the
// Bootstrap", 1993, chapter 13). They need no model of the noise, but observations that are independent; for very
// small samples they are too short: of five observations, the percentile interval of the median covers the truth less
// often than its nominal confidence.
//
// Deterministic: the same observations, options and seed give the same interval on every platform.
// Time: `resamples` times that of the statistic.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace mwt {

/// A statistic's value on the observations, and an interval for what it estimates.
struct Estimate {
  double value = 0;
  double lower = 0;
  double upper = 0;
};

struct BootstrapOptions {
  double confidence = 0.95;  ///< between 0 and 1, both excluded
  int resamples = 2000;      ///< at least 1
  std::uint64_t seed = 1;
};

/// For any statistic of observations that the caller numbers from 0: `statistic` gets the numbers of those drawn, some
/// of them several times. First it is called on 0 .. count - 1 in order, for Estimate::value.
///
/// Where every number's group is given, each group's observations are drawn from that group alone (a stratified
/// bootstrap), so that every resample has as many of each group as the experiment had.
///
/// Preconditions: count >= 1; groups empty or one per observation; the statistic is never NaN. std::invalid_argument
/// otherwise.
[[nodiscard]] Estimate bootstrap_over(std::size_t count,
                                      const std::function<double(std::span<const std::size_t>)>& statistic,
                                      const BootstrapOptions& options = {}, std::span<const std::size_t> groups = {});

/// For any statistic of a sample that does not depend on its order.
[[nodiscard]] Estimate bootstrap(std::span<const double> sample,
                                 const std::function<double(std::span<const double>)>& statistic,
                                 const BootstrapOptions& options = {});

/// For any statistic of two samples that were measured independently: each is drawn by itself.
/// Precondition: neither is empty; std::invalid_argument otherwise.
[[nodiscard]] Estimate bootstrap_two_samples(
    std::span<const double> first, std::span<const double> second,
    const std::function<double(std::span<const double>, std::span<const double>)>& statistic,
    const BootstrapOptions& options = {});

[[nodiscard]] Estimate bootstrap_median(std::span<const double> sample, const BootstrapOptions& options = {});

/// median(numerators) / median(denominators), where the i-th of both were measured together (side by side, or on the
/// same instance): pairs are drawn, so that what moves both moves neither end of the interval. Preconditions: as many
/// of one as of the other; all positive and finite. std::invalid_argument otherwise.
[[nodiscard]] Estimate bootstrap_paired_ratio_of_medians(std::span<const double> numerators,
                                                         std::span<const double> denominators,
                                                         const BootstrapOptions& options = {});

/// median(numerators) / median(denominators) of two samples measured independently: each is drawn by itself.
/// Preconditions: neither is empty; all positive and finite. std::invalid_argument otherwise.
[[nodiscard]] Estimate bootstrap_ratio_of_medians(std::span<const double> numerators,
                                                  std::span<const double> denominators,
                                                  const BootstrapOptions& options = {});

}  // namespace mwt
