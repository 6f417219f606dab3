// One benchmark's instance, verified before anything is timed.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/rating/rated_run.h"
#include "harness/run/catalogue.h"
#include "harness/run/execution.h"

namespace mwt {

/// Parameters given by name; all others keep their defaults.
using GivenParameters = std::map<std::string, std::string>;

/// What a benchmark runs: an algorithm on an instance of a family.
struct BenchmarkCell {
  const AlgorithmInfo* algorithm = nullptr;
  GivenParameters algorithm_parameters;
  const GeneratorInfo* family = nullptr;
  GivenParameters family_parameters;
  Index n = 0;

  /// "greedy_naive/uniform/1000", "patch:k=14/clustered:clusters=50,sigma=.01/100000".
  [[nodiscard]] std::string name() const;
};

/// Every algorithm on every family at n = 10, 100, ... up to `max_n` and to what both sensibly take; named
/// instances at their n. With default parameters, and with those of a few common variants.
[[nodiscard]] std::vector<BenchmarkCell> benchmark_cells(const Catalogue& catalogue, Index max_n);

/// A cell ready to be timed.
struct PreparedCell {
  Instance instance;
  Request request;
  RatedRun run;                ///< rated where an optimum is cheap: up to kMaxRatedN points
  std::string reason_to_skip;  ///< not empty: the algorithm or the family does not take this n, or the
                               ///< algorithm's output or certified bound is wrong
};
inline constexpr Index kMaxRatedN = 100'000;

/// Generates the instance (seed 1), runs the algorithm once, checks its output, and looks for the optimum with the
/// exact algorithms, half a minute each; once per instance. A bound that a triangulation disproves is reported on
/// standard error and counts no more.
[[nodiscard]] PreparedCell prepare(const Catalogue& catalogue, const BenchmarkCell& cell);

/// The processor time of the Delaunay time and of an algorithm, in turns, so that what else the machine does cancels.
class TimeOverDelaunay {
 public:
  static constexpr std::size_t kDelaunayTimes = 7;

  /// Measures the Delaunay time if it has not been measured seven times yet.
  void measure_delaunay_time(Points points);

  void add(double algorithm_s) { algorithm_s_.push_back(algorithm_s); }

  /// Median of the algorithm's times over the median of seven of the Delaunay time, which are completed here.
  [[nodiscard]] double ratio(Points points);

 private:
  std::vector<double> delaunay_times_s_;
  std::vector<double> algorithm_s_;
};

}  // namespace mwt
