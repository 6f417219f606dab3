// Several treatments on the same blocks: which ranks do they take, and how far apart must mean ranks be to mean
// anything?
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mwt {

/// Ranks of k treatments, 1 for the smallest value of a block; tied values share their mean rank.
struct MeanRanks {
  std::size_t blocks = 0;
  std::vector<double> ranks;       ///< mean over the blocks, one per treatment
  double chi_squared = 0;          ///< Friedman's statistic, corrected for ties; 0 if all values of all blocks are tied
  double p_value = 1;              ///< of "the treatments do not differ", by the chi-squared approximation
  double critical_difference = 0;  ///< Nemenyi's at the level
};

/// M. Friedman, "The use of ranks to avoid the assumption of normality implicit in the analysis of variance", J.
/// American Statistical Association 32 (1937), and the critical difference of P. B. Nemenyi's test as in J. Demsar,
/// "Statistical comparisons of classifiers over multiple data sets", J. Machine Learning Research 7 (2006): two mean
/// ranks that are further apart differ at `level`, whichever of all pairs they are.
///
/// The statistic equals that of SciPy's friedmanchisquare. Infinite values are the largest.
/// Preconditions: at least one block; every block has the same number, at least 2, of values; no NaN;
/// std::invalid_argument otherwise. Time O(b k log k).
[[nodiscard]] MeanRanks mean_ranks(std::span<const std::vector<double>> blocks, double level = 0.05);

/// The p-quantile of the studentized range of `groups` normal means with infinitely many degrees of freedom, to 1e-10.
/// Preconditions: 0 < p < 1, groups >= 2; std::invalid_argument otherwise.
[[nodiscard]] double studentized_range_quantile(double p, std::size_t groups);

}  // namespace mwt
