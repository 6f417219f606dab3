#include "harness/statistics/paired_comparison.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "harness/statistics/rank_tests.h"
#include "harness/statistics/shift.h"

namespace mwt {

namespace {

std::vector<double> negated(std::span<const double> values) {
  std::vector<double> result;
  for (const double value : values) result.push_back(-value);
  return result;
}

/// Among the sizes of all differences, so that zeros have the smallest ranks; ties share their mean.
double rank_biserial(std::span<const double> differences) {
  std::vector<double> ordered(differences.begin(), differences.end());
  std::sort(ordered.begin(), ordered.end(), [](double a, double b) { return std::fabs(a) < std::fabs(b); });
  double positive = 0, negative = 0;
  for (std::size_t begin = 0; begin < ordered.size();) {
    std::size_t end = begin;
    while (end < ordered.size() && std::fabs(ordered[end]) == std::fabs(ordered[begin])) ++end;
    const double rank = 0.5 * static_cast<double>(begin + end + 1);
    for (; begin < end; ++begin) {
      if (ordered[begin] > 0) positive += rank;
      if (ordered[begin] < 0) negative += rank;
    }
  }
  return positive + negative > 0 ? (positive - negative) / (positive + negative) : 0;
}

/// The number of rank sums of n differences, from the smallest, that together have at most this probability: 0 if even
/// the smallest sum has more.
std::size_t rejected_sums(std::size_t n, double probability) {
  const double count = static_cast<double>(n);
  if (n > kExactRankTestSize) {
    const double deviation = std::sqrt(count * (count + 1) * (2 * count + 1) / 24);
    const double least =
        count * (count + 1) / 4 + boost::math::quantile(boost::math::normal(), probability) * deviation;
    return least > 0 ? static_cast<std::size_t>(least) : 0;
  }
  std::vector<double> of_sum(n * (n + 1) / 2 + 1, 0.0);
  of_sum[0] = 1;
  for (std::size_t rank = 1; rank <= n; ++rank) {
    for (std::size_t sum = of_sum.size(); sum-- > 0;)
      of_sum[sum] = 0.5 * (of_sum[sum] + (sum >= rank ? of_sum[sum - rank] : 0.0));
  }
  std::size_t sums = 0;
  for (double below = of_sum[0]; below <= probability; below += of_sum[sums]) ++sums;
  return sums;
}

std::optional<Estimate> interval_of_shift(std::span<const double> differences, double shift, double confidence) {
  const std::size_t outside = rejected_sums(differences.size(), (1 - confidence) / 2);
  if (outside == 0) return std::nullopt;
  std::vector<double> means;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    for (std::size_t j = i; j < differences.size(); ++j) means.push_back(0.5 * (differences[i] + differences[j]));
  }
  const auto lower = means.begin() + static_cast<std::ptrdiff_t>(outside - 1);
  std::nth_element(means.begin(), lower, means.end());
  Estimate interval{shift, *lower, 0};
  const auto upper = means.end() - static_cast<std::ptrdiff_t>(outside);
  std::nth_element(means.begin(), upper, means.end());
  interval.upper = *upper;
  return interval;
}

}  // namespace

PairedComparison compare_pairs(std::span<const double> differences, double confidence) {
  if (differences.empty()) throw std::invalid_argument("a comparison of no pairs");
  if (!(confidence > 0 && confidence < 1)) throw std::invalid_argument("confidence lies between 0 and 1");
  PairedComparison comparison;
  for (const double difference : differences) {
    ++(difference > 0 ? comparison.positive : difference < 0 ? comparison.negative : comparison.zero);
  }
  const double smaller = std::min(signed_rank_p_value(differences), signed_rank_p_value(negated(differences)));
  comparison.p_value = std::min(1.0, 2 * smaller);
  comparison.effect = rank_biserial(differences);
  comparison.shift = pseudo_median(differences);
  comparison.interval = interval_of_shift(differences, comparison.shift, confidence);
  return comparison;
}

}  // namespace mwt
