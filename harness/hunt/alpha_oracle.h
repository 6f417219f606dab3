// How badly an algorithm does on a small instance, certified: what a hunt maximises.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "harness/run/catalogue.h"
#include "harness/run/execution.h"

namespace mwt {

/// The exact algorithm that a hunt for n points uses: subset_dp as long as it takes less than a millisecond, then
/// exact. Precondition: n >= 3.
[[nodiscard]] const AlgorithmInfo& solver_for_hunt(const Catalogue& catalogue, Index n);

/// The solver certified more than a triangulation weighs: it is wrong on these points.
class DisprovedOptimum : public std::logic_error {
 public:
  DisprovedOptimum(const std::string& what, std::vector<Point> points)
      : std::logic_error(what), points_(std::move(points)) {}

  [[nodiscard]] const std::vector<Point>& points() const { return points_; }

 private:
  std::vector<Point> points_;
};

/// Rates instances in this process, without a cache. Thread-safe: every call stands for itself.
class AlphaOracle {
 public:
  AlphaOracle(Request request, const AlgorithmInfo& solver);

  /// Certified alpha of the algorithm's triangulation against the solver's proved optimum. Nothing if the points are no
  /// instance (duplicates, all collinear, not finite), if either algorithm does not take them, or if the solver does
  /// not prove its result within a second. Throws std::logic_error if a triangulation is invalid, and DisprovedOptimum
  /// if the algorithm's, or the solver's own, is lighter than the solver's bound.
  [[nodiscard]] std::optional<Interval> alpha(const std::vector<Point>& points) const;

  [[nodiscard]] const Request& request() const { return request_; }
  [[nodiscard]] const AlgorithmInfo& solver() const { return solver_; }

 private:
  Request request_;
  const AlgorithmInfo& solver_;
};

}  // namespace mwt
