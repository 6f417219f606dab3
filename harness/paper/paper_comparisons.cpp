#include "harness/paper/paper_comparisons.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "harness/statistics/holm.h"

namespace mwt {

namespace {

// Rank tests need no more than the order of the differences: those with a failure are the largest.
void make_finite(std::vector<double>& differences) {
  double largest = 0;
  for (const double difference : differences) {
    if (std::isfinite(difference)) largest = std::max(largest, std::abs(difference));
  }
  for (double& difference : differences) {
    if (std::isinf(difference)) difference = std::copysign(2 * largest + 1, difference);
  }
}

// The values of one instance, those that are not certainly different made equal: each takes the smallest value that it
// is not certainly larger than.
std::vector<double> tied_values(const PaperData& data, PaperMeasure measure, std::size_t instance) {
  std::vector<double> values;
  for (std::size_t a = 0; a < data.algorithms.size(); ++a) values.push_back(data.value(measure, a, instance));
  std::vector<double> tied = values;
  for (std::size_t a = 0; a < values.size(); ++a) {
    for (std::size_t b = 0; b < values.size(); ++b) {
      if (data.difference(measure, a, b, instance) == 0) tied[a] = std::min(tied[a], values[b]);
    }
  }
  return tied;
}

// Largest ranges of positions whose ranks differ by less than the critical difference.
std::vector<std::pair<std::size_t, std::size_t>> groups_of(const std::vector<double>& ordered, double critical) {
  std::vector<std::pair<std::size_t, std::size_t>> groups;
  for (std::size_t first = 0; first < ordered.size(); ++first) {
    std::size_t last = first;
    while (last + 1 < ordered.size() && ordered[last + 1] - ordered[first] < critical) ++last;
    const bool is_new = groups.empty() || last > groups.back().second;
    if (last > first && is_new) groups.emplace_back(first, last);
  }
  return groups;
}

}  // namespace

std::vector<AlgorithmPair> pairs_on(const PaperData& data, PaperMeasure measure,
                                    const std::vector<std::size_t>& instances) {
  std::vector<AlgorithmPair> pairs;
  if (instances.empty()) return pairs;
  for (std::size_t first = 0; first < data.algorithms.size(); ++first) {
    for (std::size_t second = first + 1; second < data.algorithms.size(); ++second) {
      std::vector<double> differences;
      for (const std::size_t instance : instances)
        differences.push_back(data.difference(measure, first, second, instance));
      make_finite(differences);
      pairs.push_back({first, second, compare_pairs(differences), 1});
    }
  }
  return pairs;
}

void adjust_for_many(std::vector<std::vector<AlgorithmPair>>& blocks) {
  std::vector<double> p_values;
  for (const std::vector<AlgorithmPair>& block : blocks) {
    for (const AlgorithmPair& pair : block) p_values.push_back(pair.comparison.p_value);
  }
  const std::vector<double> adjusted = holm_adjusted(p_values);
  std::size_t next = 0;
  for (std::vector<AlgorithmPair>& block : blocks) {
    for (AlgorithmPair& pair : block) pair.p_adjusted = adjusted[next++];
  }
}

std::optional<std::size_t> winner_of(const std::vector<AlgorithmPair>& pairs) {
  std::optional<std::size_t> winner;
  std::size_t last = 0;
  for (const AlgorithmPair& pair : pairs) last = std::max(last, pair.second);
  for (std::size_t candidate = 0; candidate <= last && !pairs.empty(); ++candidate) {
    const bool beats_all = std::ranges::all_of(pairs, [&](const AlgorithmPair& pair) {
      if (pair.first != candidate && pair.second != candidate) return true;
      const double effect = pair.first == candidate ? pair.comparison.effect : -pair.comparison.effect;
      return pair.is_significant() && effect > 0;
    });
    if (beats_all) winner = candidate;
  }
  return winner;
}

std::optional<AlgorithmRanks> ranks_on(const PaperData& data, PaperMeasure measure,
                                       const std::vector<std::size_t>& instances) {
  if (instances.empty() || data.algorithms.size() < 2) return std::nullopt;
  std::vector<std::vector<double>> blocks;
  for (const std::size_t instance : instances) blocks.push_back(tied_values(data, measure, instance));
  AlgorithmRanks result;
  result.ranks = mean_ranks(blocks, kPaperLevel);
  result.order.resize(data.algorithms.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t{0});
  std::ranges::stable_sort(result.order, {}, [&](std::size_t a) { return result.ranks.ranks[a]; });
  std::vector<double> ordered;
  for (const std::size_t a : result.order) ordered.push_back(result.ranks.ranks[a]);
  result.groups = groups_of(ordered, result.ranks.critical_difference);
  return result;
}

}  // namespace mwt
