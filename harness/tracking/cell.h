// A cell of a study: one algorithm with its parameters on one instance. What is compared, and followed over the nightly
// runs.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "harness/records/records.h"

namespace mwt {

struct TrackedCell {
  std::string algorithm;
  std::string params;
  std::string generator;
  std::string generator_params;
  Index n = 0;
  std::uint64_t seed = 0;
  int threads = 1;

  friend auto operator<=>(const TrackedCell&, const TrackedCell&) = default;
};

[[nodiscard]] TrackedCell cell_of(const RunRecord& record);

/// "flip start=sweep", "clustered clusters=5", "clustered clusters=5 n=100 seed=1": parts of a cell for messages and
/// tables.
[[nodiscard]] std::string algorithm_label(const TrackedCell& cell);
[[nodiscard]] std::string family_label(const TrackedCell& cell);
[[nodiscard]] std::string instance_label(const TrackedCell& cell);

/// The records of every cell, in their order.
[[nodiscard]] std::map<TrackedCell, std::vector<const RunRecord*>> by_cell(const std::vector<RunRecord>& runs);

}  // namespace mwt
