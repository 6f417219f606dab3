// Fits y = c n^e to measurements: a straight line through their logarithms.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "harness/statistics/bootstrap.h"

namespace mwt {

struct Measurement {
  double n = 0;
  double y = 0;
};

struct PowerLaw {
  Estimate exponent;                ///< the line's slope
  Estimate log_factor;              ///< natural logarithm of c, the line's height at n = 1
  std::optional<double> r_squared;  ///< share of the variance of log y that the line explains; none if y is constant
  bool has_interval = false;        ///< false: every n was measured once, so the noise is unknown; ends = value
};

/// The least-squares line through (log n, log y), every measurement weighing the same, solved by a QR decomposition.
///
/// The intervals are percentile bootstrap intervals over the measurements of each n by itself (a stratified bootstrap):
/// they show how the noise at the given sizes moves the line, not whether a line is the right curve. A size that was
/// measured once contributes no noise, and where all were, has_interval is false.
///
/// y is constant if it varies by no more than 1e-11 of itself, which certified intervals are wide.
///
/// Nothing with fewer than two distinct n: there is no line then.
/// Precondition: every n and y positive and finite; std::invalid_argument otherwise.
/// O(resamples * measurements); deterministic.
[[nodiscard]] std::optional<PowerLaw> fit_power_law(std::span<const Measurement> measurements,
                                                    const BootstrapOptions& options = {});

/// The fitted line at each of `places` (values of n), as values of y, with the interval that the same bootstrap gives
/// it: the band around the line. Ends equal the value where every n was measured once.
/// Preconditions: as fit_power_law(), with at least two distinct n; places positive. std::invalid_argument otherwise.
/// O(places * resamples * measurements); deterministic.
[[nodiscard]] std::vector<Estimate> power_law_band(std::span<const Measurement> measurements,
                                                   std::span<const double> places,
                                                   const BootstrapOptions& options = {});

}  // namespace mwt
