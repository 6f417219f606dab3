// The runs that one picture shows, and the optimum that they are rated by.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/rating/isolated_run.h"
#include "harness/rating/optimum_claims.h"
#include "harness/rating/quality.h"
#include "harness/run/catalogue.h"
#include "harness/run/process_pool.h"

namespace mwt {

/// A run and what it returned, as bytes: its edges, sorted, and its triangles, both as positions in the input. Empty
/// unless the run is ok.
struct ShownRun {
  std::string algorithm;
  RatedRun run;
  std::string edges_and_triangles;
};

struct ShownOptimum {
  std::optional<Interval> interval;  ///< all that is certified
  std::string source;                ///< the exact algorithm whose triangulation is shown
  std::string note;                  ///< without a proved optimum, the outcome of each source
  std::vector<std::string> contradictions;
  std::optional<ShownRun> witness;  ///< the lightest triangulation of an exact algorithm
};

/// Runs on one instance, each in a process of its own. Rated as mwt solve --with-optimum rates a solution, but the
/// optimum cache is left alone: it has no triangulations.
class ShownRuns {
 public:
  ShownRuns(const Catalogue& catalogue, const Instance& instance, const RunLimits& limits)
      : catalogue_(catalogue), instance_(instance), limits_(limits) {}

  /// Starts the run and calls `wait`, which returns when it has ended.
  void run(ProcessPool& pool, const Request& request, const std::function<void()>& wait);

  /// Runs exact algorithms in the order of optimum_sources_for() until one proves the optimum; none if one that ran
  /// has proved it.
  void seek_optimum(ProcessPool& pool, const std::function<void()>& wait);

  /// Fills in optimum and alpha of all runs by everything that any of them certifies.
  void rate_all();

  [[nodiscard]] const std::vector<ShownRun>& runs() const { return runs_; }
  [[nodiscard]] const ShownOptimum& optimum() const { return optimum_; }

 private:
  [[nodiscard]] ShownRun run_isolated(ProcessPool& pool, const Request& request, const std::function<void()>& wait);
  [[nodiscard]] bool is_proved() const { return optimality_of(claims_.bounds()) == Optimality::proved; }
  void offer_witness(const ShownRun& run);

  const Catalogue& catalogue_;
  const Instance& instance_;
  RunLimits limits_;
  std::vector<ShownRun> runs_;
  OptimumClaims claims_;
  ShownOptimum optimum_;
};

}  // namespace mwt
