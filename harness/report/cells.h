// Groups the runs of a study for reporting.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

/// What the runs of a cell have in common.
struct CellKey {
  std::string generator;
  std::string generator_params;
  std::string algorithm;
  std::string params;
  Index n = 0;

  friend auto operator<=>(const CellKey&, const CellKey&) = default;

  /// The same for all sizes: cells that differ in n alone form a series.
  [[nodiscard]] CellKey series() const;
};

/// One algorithm on the instances of one family and size.
///
/// Repetitions on the same points are no independent observations of an algorithm's behaviour on a family. Therefore
/// an observation is the median over the repetitions on one instance; only where a cell has a single instance are its
/// repetitions the observations of the times.
struct Cell {
  CellKey key;
  std::size_t runs = 0;  ///< without those that are not applicable
  std::size_t failures = 0;
  std::size_t not_applicable = 0;
  std::size_t stopped_early = 0;       ///< runs that are ok, but did less than their algorithm does in more time
  std::size_t instances = 0;           ///< with at least one run that is ok
  std::vector<double> times;           ///< observations, s
  std::vector<double> over_delaunay;   ///< observations: time over the Delaunay time's, where that was measured
  std::vector<double> peak_rss_bytes;  ///< observations
  std::vector<double> alphas;          ///< one per instance with a proved optimum: upper ends of certified intervals
  double max_alpha = 0;                ///< over all such runs; 0 if there is none
  std::size_t optimal = 0;             ///< instances among these on which every run is proved optimal
};

/// Families in the order of their first run, algorithms in the order of the registry (unknown ones last, by name),
/// sizes ascending: cells of one series are neighbours.
[[nodiscard]] std::vector<Cell> cells_of(const std::vector<RunRecord>& runs);

}  // namespace mwt
