// Whether a power law is the right curve at all, which the interval of its exponent does not show.
#pragma once

#include <optional>
#include <span>

#include "harness/statistics/power_law.h"

namespace mwt {

struct LackOfFit {
  /// Of "the medians lie on a power law, but for the noise": small where none fits. Missing where nothing can be
  /// tested.
  std::optional<double> p_value;
  /// The factor by which the law misses the median of the size that it misses most; at least 1.
  double max_misfit = 1;
};

/// The F test of lack of fit, on the logarithms: how far the medians of the sizes lie off the best line through them,
/// each weighted by its precision, against the scatter within sizes (pooled over them; the variance of a median of m
/// values is taken as pi / 2m of it, of one or two values 1 / m). Needs three sizes, one of them measured repeatedly.
///
/// Where every size was measured once, noise cannot be separated from lack of fit; then curvature is tested: the F test
/// of the quadratic term in log n against what a parabola leaves. Needs four sizes.
///
/// Precondition: `law` is fit_power_law() of `measurements`.
[[nodiscard]] LackOfFit test_lack_of_fit(std::span<const Measurement> measurements, const PowerLaw& law);

}  // namespace mwt
