// How time and alpha grow with n: power laws fitted to the cells of a series.
#pragma once

#include <optional>
#include <vector>

#include "harness/report/cells.h"
#include "harness/statistics/power_law.h"

namespace mwt {

/// A power law needs at least this many sizes; through two of them every line fits.
inline constexpr std::size_t kFewestSizes = 3;

struct Growth {
  std::size_t sizes = 0;
  std::size_t observations = 0;
  Index smallest_n = 0;
  Index largest_n = 0;
  PowerLaw law;
};

/// The laws of one series; missing with too few sizes. All sizes count, small ones, where fixed costs still show,
/// included.
struct SeriesGrowth {
  CellKey series;  ///< n is 0
  std::optional<Growth> time;
  std::optional<Growth> alpha;
};

/// Every series with at least one law, in the order of the cells. Precondition: cells of one series are neighbours.
[[nodiscard]] std::vector<SeriesGrowth> growth_of(const std::vector<Cell>& cells);

}  // namespace mwt
