// One benchmark's instance, verified before anything is timed.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/catalogue.h"
#include "harness/execution.h"

namespace mwt {

/// What a benchmark runs: an algorithm on an instance of a family, both with their default parameters.
struct BenchmarkCell {
  const AlgorithmInfo* algorithm = nullptr;
  const GeneratorInfo* family = nullptr;
  Index n = 0;

  /// "greedy_report/uniform/1000".
  [[nodiscard]] std::string name() const;
};

/// Every algorithm on every family at n = 10, 100, ... up to what both sensibly take; named instances at their n.
[[nodiscard]] std::vector<BenchmarkCell> benchmark_cells(const Catalogue& catalogue);

/// A cell ready to be timed.
struct PreparedCell {
  Instance instance;
  Request request;
  double yardstick_s = 0;         ///< median of seven Delaunay triangulations of the same points by CGAL
  std::optional<Interval> alpha;  ///< where an optimum is cheap: up to kLargestRatedN points
  std::string reason_to_skip;     ///< not empty: the algorithm or the family does not take this n, or the
                                  ///< algorithm's output is wrong
};
inline constexpr Index kLargestRatedN = 10000;

/// Generates the instance (seed 1), runs the algorithm once, checks its output, and looks for the optimum.
[[nodiscard]] PreparedCell prepare(const Catalogue& catalogue, const BenchmarkCell& cell);

}  // namespace mwt
