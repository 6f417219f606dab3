#include "harness/statistics/quantile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace mwt {

namespace {

void require_quantile_exists(std::span<const double> sample, double p) {
  if (sample.empty()) throw std::invalid_argument("the quantile of an empty sample");
  if (!(p >= 0 && p <= 1)) throw std::invalid_argument("a quantile's p lies between 0 and 1");
  const bool has_nan = std::any_of(sample.begin(), sample.end(), [](double value) { return std::isnan(value); });
  if (has_nan) throw std::invalid_argument("the quantile of a sample with NaN");
}

}  // namespace

double quantile_in_place(std::span<double> sample, double p) {
  require_quantile_exists(sample, p);
  const double position = p * static_cast<double>(sample.size() - 1);
  const std::size_t below = static_cast<std::size_t>(position);
  const double fraction = position - static_cast<double>(below);
  const auto lower = sample.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(sample.begin(), lower, sample.end());
  if (fraction == 0) return *lower;
  return std::lerp(*lower, *std::min_element(lower + 1, sample.end()), fraction);
}

double quantile(std::span<const double> sample, double p) {
  std::vector<double> copy(sample.begin(), sample.end());
  return quantile_in_place(copy, p);
}

double median(std::span<const double> sample) { return quantile(sample, 0.5); }

}  // namespace mwt
