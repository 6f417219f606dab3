// The times of two sides, cell by cell and algorithm by algorithm: which rows are slower or faster, and how sure that
// is. The rules are in comparison.h.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/statistics/bootstrap.h"
#include "harness/tracking/cell.h"

namespace mwt {

struct CompareOptions {
  double threshold = 0.05;   ///< relative; slower by less is no regression, faster by less no improvement
  double error_rate = 0.05;  ///< false discovery rate, separately for algorithms and for cells
  bool paired = false;       ///< repetition i of both was measured side by side
  bool force = false;        ///< compare times of different machines, and of identical binaries
  std::optional<std::string> time_measure;  ///< one of measures(); see below for the default
};

enum class Verdict {
  same,              ///< differences beyond the threshold are excluded in both directions
  not_slower,        ///< slower by more than the threshold is excluded; faster is not
  unclear,           ///< neither excluded nor sure: slower by more than the threshold is possible
  regression,        ///< slower by more than the threshold
  improvement,       ///< faster by more than the threshold
  identical_binary,  ///< not judged
};
[[nodiscard]] std::string name_of(Verdict verdict);

/// How the times of some runs compare.
struct TimeRow {
  std::string name;                 ///< of the algorithm; "all" for all of them
  std::string algorithm;            ///< the same with its parameters
  std::string instance;             ///< empty for a row of an algorithm
  std::optional<TrackedCell> cell;  ///< none for a row of an algorithm
  std::size_t observations = 0;
  std::optional<double> base;  ///< median; rows of algorithms have none, for their cells are not alike
  std::optional<double> now;
  Estimate ratio;       ///< of new to base, with its 95% bootstrap interval
  double q_slower = 1;  ///< adjusted p-value of "slower by more than the threshold"
  double q_faster = 1;
  Verdict verdict = Verdict::unclear;
};

using Repetitions = std::map<int, double>;  ///< logarithms of times

/// A cell whose times are judged.
struct TimedCell {
  TrackedCell cell;
  Repetitions base;
  Repetitions now;
};

/// The `name` and `algorithm` of the row of all algorithms.
inline constexpr const char* kAllAlgorithms = "all";

/// Fewer cells do not show how much a cell differs between two sessions; they are then judged by repetitions alone.
inline constexpr std::size_t kMinCellsForSpread = 5;

/// now - base for each repetition that both sides have.
[[nodiscard]] Repetitions paired_log_ratios(const TimedCell& cell);

struct TimeTable {
  std::vector<TimeRow> algorithms;  ///< with more than one of them, also the row of all
  std::vector<TimeRow> cells;
};

/// How two sides were measured.
struct Measuring {
  bool has_delaunay_time = false;
  bool can_exclude = false;  ///< whether a slowdown that does not show is none: the machine was in the same state
};

/// Precondition: at least one cell; each has a time of both sides, in the same repetition if options.paired.
[[nodiscard]] TimeTable make_time_table(const std::vector<TimedCell>& cells, const CompareOptions& options,
                                        const Measuring& measuring);

}  // namespace mwt
