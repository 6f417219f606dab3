#include "harness/statistics/rank_tests.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace mwt {

namespace {

void require_numbers(std::span<const double> values) {
  const bool has_nan = std::any_of(values.begin(), values.end(), [](double value) { return std::isnan(value); });
  if (has_nan) throw std::invalid_argument("ranks of NaN");
}

/// Twice the mean rank of every value, so that ties have integers too.
std::vector<std::size_t> doubled_ranks(std::span<const double> values) {
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::size_t> ranks(values.size());
  for (std::size_t begin = 0; begin < order.size();) {
    std::size_t end = begin;
    while (end < order.size() && values[order[end]] == values[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = begin + end + 1;  // first and last rank of the tie
    begin = end;
  }
  return ranks;
}

/// P(Z >= z) for a standard normal Z.
double normal_upper_tail(double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); }

/// Approximate P(sum >= observed); doubled ranks are 2 apart, so a step of the sum is 2 unless there are ties.
double approximate_tail(std::size_t observed, double mean, double variance) {
  if (variance <= 0) return 1;
  return normal_upper_tail((static_cast<double>(observed) - 1 - mean) / std::sqrt(variance));
}

/// The share of the 2^k sign patterns whose positive ranks sum to at least `observed`.
double share_of_signs(const std::vector<std::size_t>& ranks, std::size_t observed) {
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  std::vector<double> probability(total + 1, 0.0);
  probability[0] = 1;
  for (const std::size_t rank : ranks) {
    for (std::size_t sum = total + 1; sum-- > 0;)
      probability[sum] = 0.5 * (probability[sum] + (sum >= rank ? probability[sum - rank] : 0.0));
  }
  return std::accumulate(probability.begin() + static_cast<std::ptrdiff_t>(observed), probability.end(), 0.0);
}

/// The share of all choices of `chosen` ranks whose sum is at least `observed`.
double share_of_choices(const std::vector<std::size_t>& ranks, std::size_t chosen, std::size_t observed) {
  const std::size_t total = std::accumulate(ranks.begin(), ranks.end(), std::size_t{0});
  // probability[k][sum]: that the ranks considered so far are chosen k times with this sum, when each of the remaining
  // places is equally likely to be among the chosen: drawing without replacement, rank by rank.
  std::vector<std::vector<double>> probability(chosen + 1, std::vector<double>(total + 1, 0.0));
  probability[0][0] = 1;
  for (std::size_t seen = 0; seen < ranks.size(); ++seen) {
    const double left = static_cast<double>(ranks.size() - seen);
    for (std::size_t k = std::min(seen + 1, chosen) + 1; k-- > 0;) {
      const double stays = 1 - static_cast<double>(chosen - k) / left;
      const double joins = k > 0 ? static_cast<double>(chosen - k + 1) / left : 0.0;
      for (std::size_t sum = total + 1; sum-- > 0;) {
        const double from_fewer = k > 0 && sum >= ranks[seen] ? joins * probability[k - 1][sum - ranks[seen]] : 0.0;
        probability[k][sum] = std::max(0.0, stays) * probability[k][sum] + from_fewer;
      }
    }
  }
  return std::accumulate(probability[chosen].begin() + static_cast<std::ptrdiff_t>(observed), probability[chosen].end(),
                         0.0);
}

}  // namespace

double signed_rank_p_value(std::span<const double> differences) {
  require_numbers(differences);
  std::vector<double> sizes;
  for (const double difference : differences) sizes.push_back(std::fabs(difference));
  const std::vector<std::size_t> all_ranks = doubled_ranks(sizes);
  std::vector<std::size_t> ranks;
  std::size_t positive = 0;
  double squares = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    if (differences[i] == 0) continue;
    ranks.push_back(all_ranks[i]);
    squares += static_cast<double>(all_ranks[i]) * static_cast<double>(all_ranks[i]);
    if (differences[i] > 0) positive += all_ranks[i];
  }
  if (ranks.size() <= kExactRankTestSize) return std::min(1.0, share_of_signs(ranks, positive));
  const double total = static_cast<double>(std::accumulate(ranks.begin(), ranks.end(), std::size_t{0}));
  return approximate_tail(positive, total / 2, squares / 4);
}

double rank_sum_p_value(std::span<const double> first, std::span<const double> second) {
  require_numbers(first);
  require_numbers(second);
  if (first.empty() || second.empty()) return 1;
  std::vector<double> all(first.begin(), first.end());
  all.insert(all.end(), second.begin(), second.end());
  const std::vector<std::size_t> ranks = doubled_ranks(all);
  const std::size_t observed =
      std::accumulate(ranks.begin() + static_cast<std::ptrdiff_t>(first.size()), ranks.end(), std::size_t{0});
  if (all.size() <= kExactRankTestSize) return std::min(1.0, share_of_choices(ranks, second.size(), observed));

  const double count = static_cast<double>(all.size());
  const double chosen = static_cast<double>(second.size());
  const double mean = count + 1;  // of the doubled ranks
  double squares = 0;
  for (const std::size_t rank : ranks)
    squares += (static_cast<double>(rank) - mean) * (static_cast<double>(rank) - mean);
  return approximate_tail(observed, chosen * mean, chosen * (count - chosen) / (count * (count - 1)) * squares);
}

}  // namespace mwt
