#include "harness/statistics/shift.h"

#include <vector>

#include "harness/statistics/quantile.h"

namespace mwt {

namespace {

double median_of_pair_means(std::span<const double> values, std::vector<double>& means) {
  means.clear();
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t j = i; j < values.size(); ++j) means.push_back(0.5 * (values[i] + values[j]));
  }
  return quantile_in_place(means, 0.5);
}

double median_of_differences(std::span<const double> first, std::span<const double> second,
                             std::vector<double>& differences) {
  differences.clear();
  for (const double a : first) {
    for (const double b : second) differences.push_back(b - a);
  }
  return quantile_in_place(differences, 0.5);
}

}  // namespace

double pseudo_median(std::span<const double> values) {
  std::vector<double> means;
  return median_of_pair_means(values, means);
}

double shift_between(std::span<const double> first, std::span<const double> second) {
  std::vector<double> differences;
  return median_of_differences(first, second, differences);
}

Estimate bootstrap_pseudo_median(std::span<const double> values, const BootstrapOptions& options) {
  std::vector<double> means;
  return bootstrap(
      values, [&](std::span<const double> drawn) { return median_of_pair_means(drawn, means); }, options);
}

Estimate bootstrap_shift(std::span<const double> first, std::span<const double> second,
                         const BootstrapOptions& options) {
  std::vector<double> differences;
  return bootstrap_two_samples(
      first, second,
      [&](std::span<const double> a, std::span<const double> b) { return median_of_differences(a, b, differences); },
      options);
}

}  // namespace mwt
