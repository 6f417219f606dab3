// Triangulations of points, and how good they are.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mwt/points.h"

namespace mwt::v1 {

struct Options {
  std::string algorithm = "greedy";                 ///< one of algorithms()
  std::map<std::string, std::string> parameters{};  ///< of the algorithm, as text; missing ones have defaults
  std::uint64_t seed = 1;                           ///< of pseudo-random numbers
  int threads = 1;
  std::optional<double> time_limit_s{};  ///< then the best triangulation so far is returned, and stop_reason is set

  /// Once another thread sets this to true, the call soon throws Interrupted; null: nothing stops it.
  const std::atomic<bool>* interrupt = nullptr;
};

struct Result {
  std::vector<Triangle> triangles;  ///< checked by exact predicates; of equal points only the first is a corner
  Interval weight;                  ///< sum of the lengths of all edges
  std::optional<Interval> optimum;  ///< of a minimum weight triangulation's weight, where the algorithm certifies it
  bool is_proved = false;           ///< the triangulation is one of minimum weight, to 1e-12 of its weight
  std::string stop_reason;          ///< empty, or what stopped the algorithm early: deadline, memory, size, precision
  std::map<std::string, double> counters;  ///< what the algorithm did, by name
  double time_s = 0;                       ///< wall time of the algorithm alone
};

/// A triangulation of the points by one algorithm. Points may repeat and be collinear; fewer than three distinct
/// points, or all points on one line, are an InputError. Deterministic, whatever the number of threads, unless the time
/// limit stops it. Time: that of the algorithm, and O(n log n) for checking. Thread-safe. Throws InputError,
/// NotApplicable, Interrupted, InternalError.
[[nodiscard]] Result triangulate(std::span<const Point> points, const Options& options = {});

struct SolveOptions {
  int threads = 1;
  std::optional<double> time_limit_s{};  ///< then there are bounds on the optimum, and the best triangulation found
  std::string proof_file{};              ///< where to write a proof for mwt_verify; empty: none is written
  const std::atomic<bool>* interrupt = nullptr;  ///< as in Options
};

/// A minimum weight triangulation, with a certified interval for its weight: the algorithm `exact`. NP-hard in general;
/// a million random points take seconds. Otherwise as triangulate().
[[nodiscard]] Result minimum_weight_triangulation(std::span<const Point> points, const SolveOptions& options = {});

/// The weight over the optimum, rounded outwards; at least 1. Precondition: both positive.
[[nodiscard]] Interval alpha(const Interval& weight, const Interval& optimum);

/// The certified sum of the lengths of all edges of a triangulation, every edge once.
[[nodiscard]] Interval weight(std::span<const Point> points, std::span<const Triangle> triangles);

/// The first rule that the triangles break as a triangulation of the points; nothing if they are one. Exact. O(n log
/// n).
[[nodiscard]] std::optional<std::string> broken_rule(std::span<const Point> points,
                                                     std::span<const Triangle> triangles);

/// A parameter of an algorithm or of a family.
struct Parameter {
  std::string name;
  std::string default_value;
  std::string summary;
};

/// An algorithm or a family of points.
struct Entry {
  std::string name;
  std::string summary;
  std::vector<Parameter> parameters;
};

[[nodiscard]] std::vector<Entry> algorithms();
[[nodiscard]] std::vector<Entry> families();

/// An instance of a family: n points, the same for the same seed on every machine. Throws InputError: no such family,
/// no instance of that size, a wrong parameter.
[[nodiscard]] std::vector<Point> generate(const std::string& family, std::uint32_t n, std::uint64_t seed = 1,
                                          const std::map<std::string, std::string>& parameters = {});

}  // namespace mwt::v1
