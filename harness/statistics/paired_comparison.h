// Two treatments of the same subjects: which is better, by how much, and how sure that is.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "harness/statistics/bootstrap.h"

namespace mwt {

struct PairedComparison {
  std::size_t positive = 0;  ///< differences above 0
  std::size_t zero = 0;
  std::size_t negative = 0;
  double p_value = 1;  ///< of "the differences are distributed symmetrically about 0"

  /// The matched-pairs rank-biserial correlation (D. S. Kerby, "The simple difference formula", Comprehensive
  /// Psychology 3, 2014): the share of the rank sum that is positive less the share that is negative. 1: all
  /// differences are positive, -1: all negative; 0 without any.
  double effect = 0;

  double shift = 0;  ///< pseudo_median() of the differences (shift.h)

  /// Holds the shift with at least the given confidence, whatever the distribution, if it is symmetric: the means of
  /// all pairs of differences between which the signed-rank test does not reject (J. L. Hodges, E. L. Lehmann 1963).
  /// `value` is the shift. Missing where there are too few differences: of five, no interval has 95%.
  std::optional<Estimate> interval;

  [[nodiscard]] std::size_t pairs() const { return positive + zero + negative; }
};

/// Wilcoxon's signed-rank test, two-sided, exact up to kExactRankTestSize differences and the normal approximation with
/// continuity correction beyond; zeros as Pratt has them (rank_tests.h). The p-values are those of SciPy's wilcoxon().
/// Preconditions: at least one difference, no NaN; 0 < confidence < 1; std::invalid_argument otherwise. O(n^2) memory.
[[nodiscard]] PairedComparison compare_pairs(std::span<const double> differences, double confidence = 0.95);

}  // namespace mwt
