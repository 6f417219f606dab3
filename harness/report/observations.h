// What a study observed: one algorithm on one instance, the repetitions taken together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "harness/report/cells.h"

namespace mwt {

/// Repetitions on the same points are no independent observations: medians over them stand for all.
struct Observation {
  CellKey key;
  std::uint64_t seed = 0;
  std::string instance_id;
  std::size_t runs = 0;  ///< without those that are not applicable
  std::size_t failures = 0;
  std::size_t stopped_early = 0;
  std::optional<double> time_s;  ///< median over the runs that are ok
  std::optional<double> peak_rss_bytes;
  std::optional<double> alpha_lower;  ///< against a proved optimum
  std::optional<double> alpha_upper;
};

/// In the order of the cells, seeds ascending. `runs` are those of the report. Runs that are not applicable make none.
[[nodiscard]] std::vector<Observation> observations_of(const std::vector<RunRecord>& runs);

}  // namespace mwt
