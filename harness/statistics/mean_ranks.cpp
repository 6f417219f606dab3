#include "harness/statistics/mean_ranks.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace mwt {

namespace {

void require_blocks(std::span<const std::vector<double>> blocks) {
  if (blocks.empty() || blocks.front().size() < 2) throw std::invalid_argument("ranks need blocks of at least two");
  for (const std::vector<double>& block : blocks) {
    if (block.size() != blocks.front().size()) throw std::invalid_argument("blocks of different sizes");
    if (std::ranges::any_of(block, [](double value) { return std::isnan(value); }))
      throw std::invalid_argument("ranks of NaN");
  }
}

/// Adds the block's ranks to `sums`; returns the sum of t^3 - t over its groups of t tied values.
double add_ranks(const std::vector<double>& block, std::vector<double>& sums) {
  std::vector<std::size_t> order(block.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return block[i]; });
  double ties = 0;
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && block[order[end]] == block[order[begin]]) ++end;
    const double rank = static_cast<double>(begin + end + 1) / 2;
    for (std::size_t i = begin; i < end; ++i) sums[order[i]] += rank;
    const auto tied = static_cast<double>(end - begin);
    ties += tied * tied * tied - tied;
    begin = end;
  }
  return ties;
}

double normal_cdf(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// P(range of `groups` standard normal values <= q) = k * integral of phi(z) (Phi(z) - Phi(z - q))^(k - 1). The
/// trapezoid rule converges faster than any power of the step for such smooth integrands that vanish at both ends.
double range_cdf(double q, std::size_t groups) {
  constexpr double kStep = 1.0 / 64;
  constexpr int kSteps = 10 * 64;  // beyond z = 10 the integrand is below 1e-22
  double sum = 0;
  for (int i = -kSteps; i <= kSteps; ++i) {
    const double z = i * kStep;
    const double density = std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
    sum += density * std::pow(normal_cdf(z) - normal_cdf(z - q), static_cast<double>(groups - 1));
  }
  return static_cast<double>(groups) * kStep * sum;
}

}  // namespace

double studentized_range_quantile(double p, std::size_t groups) {
  if (!(p > 0 && p < 1) || groups < 2) throw std::invalid_argument("no such studentized range");
  double low = 0, high = 1;
  while (range_cdf(high, groups) < p) high *= 2;
  while (high - low > 1e-12 * high) {
    const double middle = (low + high) / 2;
    (range_cdf(middle, groups) < p ? low : high) = middle;
  }
  return (low + high) / 2;
}

MeanRanks mean_ranks(std::span<const std::vector<double>> blocks, double level) {
  require_blocks(blocks);
  const auto b = static_cast<double>(blocks.size());
  const auto k = static_cast<double>(blocks.front().size());
  MeanRanks result;
  result.blocks = blocks.size();
  result.ranks.assign(blocks.front().size(), 0.0);
  double ties = 0;
  for (const std::vector<double>& block : blocks) ties += add_ranks(block, result.ranks);
  const double squares = std::inner_product(result.ranks.begin(), result.ranks.end(), result.ranks.begin(), 0.0);
  for (double& rank : result.ranks) rank /= b;
  const double untied_share = 1 - ties / (k * (k * k - 1) * b);
  if (untied_share > 0) {
    result.chi_squared = (12 / (k * b * (k + 1)) * squares - 3 * b * (k + 1)) / untied_share;
    const boost::math::chi_squared distribution(k - 1);
    result.p_value = boost::math::cdf(boost::math::complement(distribution, std::max(result.chi_squared, 0.0)));
  }
  result.critical_difference = studentized_range_quantile(1 - level, blocks.front().size()) / std::numbers::sqrt2 *
                               std::sqrt(k * (k + 1) / (6 * b));
  return result;
}

}  // namespace mwt
