// A measure of one algorithm on one family and size over the nightly runs.
#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "harness/tracking/history/nightly_run.h"

namespace mwt {

struct SeriesKey {
  std::string study;
  std::string environment;
  TrackedCell cell;  ///< its seed is 0: all seeds together
  std::string measure;

  friend auto operator<=>(const SeriesKey&, const SeriesKey&) = default;
};

struct Series {
  SeriesKey key;
  std::vector<std::size_t> nightly_runs;  ///< positions in the list of nightly runs, ascending
  std::vector<double> values;             ///< as many
};

/// All series of these nightly runs, by key. A value is the geometric mean of the seeds' values (the mean, for
/// failures), made up so that a seed that is missing on some nightly runs does not move it: the mean over all seeds of
/// their median over the nightly runs, times the mean deviation from it of the seeds that are there.
[[nodiscard]] std::vector<Series> series_of(const std::vector<NightlyRun>& nightly_runs);

}  // namespace mwt
