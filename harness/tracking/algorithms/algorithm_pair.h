// Compares two algorithms on the instances of one study: which triangulates lighter, which is faster, and how sure
// that is.
//
// Pairs are instances: the points that both algorithms ran on. A cell is a family and size, its pairs are the seeds;
// one more row holds all instances together. A pair's observation is the logarithm of B's value over A's:
//
// - alpha: of the weights, for on the same points the ratio of weights is the ratio of alphas, whether or not the
//   optimum is known. Weights whose certified intervals meet are equal.
// - time: of the medians over the repetitions; only where the same machine ran both.
//
// A row states the ratio (Hodges-Lehmann) with its exact 95% interval, Wilcoxon's two-sided signed-rank test and the
// rank-biserial correlation as effect size (statistics/paired_comparison.h). The p-values of cells are adjusted by
// Benjamini and Hochberg, those of alpha and of times each by themselves; the row of all is one test and is not.
//
// A deadline or a failure may be what makes an algorithm look good: instances on which only one of the two succeeded,
// and runs that were stopped early, are counted in the notes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/statistics/paired_comparison.h"
#include "harness/tracking/result_set.h"

namespace mwt {

enum class PairVerdict {
  a_is_better,
  b_is_better,
  equal,     ///< on every instance
  not_sure,  ///< no difference is shown, which does not exclude one
};

/// The instances of one family and size, or all.
struct PairRow {
  std::string family;       ///< with its parameters; "all"
  Index n = 0;              ///< 0 for the row of all
  std::optional<double> a;  ///< median alpha, where every optimum is proved, or median time; none for the row of all
  std::optional<double> b;
  PairedComparison comparison;  ///< of log(b / a)
  double q_value = 1;           ///< adjusted
  PairVerdict verdict = PairVerdict::not_sure;
};

struct AlgorithmPair {
  std::string folder;
  std::string a;  ///< with parameters
  std::string b;
  std::string time_measure;
  double error_rate = 0.05;
  std::vector<PairRow> alpha;  ///< cells, then all of them if there are several
  std::vector<PairRow> times;
  std::vector<std::string> notes;
};

struct AlgorithmPairOptions {
  std::string a;  ///< "flip", or "flip start=sweep" to choose among several
  std::string b;
  std::optional<std::string> time_measure;  ///< else cpu_time_s, or wall_time_s where several threads were allowed
};

/// Deterministic. Throws InputError: an algorithm that the results do not have, or that does not tell them apart (both
/// with the names that there are); the same one twice; no instance that both ran on with success; a measure that is no
/// time.
[[nodiscard]] AlgorithmPair compare_algorithms(const ResultSet& results, const AlgorithmPairOptions& options);

}  // namespace mwt
