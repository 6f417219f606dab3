// How time and alpha grow with n: power laws fitted to the cells of a series.
#pragma once

#include <optional>
#include <vector>

#include "harness/report/cells.h"
#include "harness/statistics/lack_of_fit.h"
#include "harness/statistics/power_law.h"

namespace mwt {

/// A power law needs at least this many sizes; through two of them every line fits.
inline constexpr std::size_t kMinSizes = 3;

/// Whether the medians of the sizes lie on a power law. `no`: the F test of lack of fit rejects at 1%, and the law
/// misses some median by more than a tenth; its exponent is then the slope of a line through a curve, and the
/// exponent's interval does not extend to other sizes. Precise measurements of anything show smaller misfits.
enum class Fit { yes, no, untested };

struct Growth {
  std::size_t sizes = 0;
  std::size_t observations = 0;
  Index min_n = 0;
  Index max_n = 0;
  PowerLaw law;
  LackOfFit lack_of_fit;

  [[nodiscard]] Fit fit() const;
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
