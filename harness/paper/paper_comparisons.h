// Is A better than B, and how sure is that? Paired tests between all algorithms of a paper.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/paper/paper_data.h"
#include "harness/statistics/mean_ranks.h"
#include "harness/statistics/paired_comparison.h"

namespace mwt {

/// Differences are significant at this level, after the correction.
inline constexpr double kPaperLevel = 0.05;

/// Two algorithms on the same instances.
struct AlgorithmPair {
  std::size_t first = 0;
  std::size_t second = 0;
  PairedComparison comparison;  ///< of PaperData::difference(): above 0 where the first is better
  double p_adjusted = 1;        ///< Holm's, over all pairs of the same tests

  [[nodiscard]] bool is_significant() const { return p_adjusted <= kPaperLevel; }
};

/// All pairs of algorithms on `instances`, not adjusted yet. A failure counts as worse than everything else. Empty
/// without instances.
[[nodiscard]] std::vector<AlgorithmPair> pairs_on(const PaperData& data, PaperMeasure measure,
                                                  const std::vector<std::size_t>& instances);

/// Adjusts all these pairs together.
void adjust_for_many(std::vector<std::vector<AlgorithmPair>>& blocks);

/// The algorithm that is significantly better than every other one, if there is one. Precondition: adjusted.
[[nodiscard]] std::optional<std::size_t> winner_of(const std::vector<AlgorithmPair>& pairs);

/// Mean ranks over the instances, and the largest groups of algorithms, as first and last position in the order of the
/// ranks, within which no two mean ranks differ by Nemenyi's critical difference.
struct AlgorithmRanks {
  MeanRanks ranks;
  std::vector<std::size_t> order;  ///< algorithms by mean rank
  std::vector<std::pair<std::size_t, std::size_t>> groups;
};

/// Nothing with fewer than two algorithms or without instances. Values that difference() holds for equal are tied.
[[nodiscard]] std::optional<AlgorithmRanks> ranks_on(const PaperData& data, PaperMeasure measure,
                                                     const std::vector<std::size_t>& instances);

}  // namespace mwt
