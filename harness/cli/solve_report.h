// What `mwt solve` says about one triangulation.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/stop_reason.h"
#include "geometry/numbers/interval.h"
#include "geometry/point.h"

namespace mwt {

/// The fields of the JSON object, in its order; missing ones are null there.
struct SolveReport {
  std::string algorithm;
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 1;
  int threads = 1;
  Index n = 0;
  Index distinct = 0;
  Index duplicates = 0;
  Index hull_size = 0;
  std::uint64_t triangles = 0;
  std::optional<std::uint64_t> edges;  ///< this and the next two: only of a valid triangulation
  std::optional<Interval> weight;
  std::optional<double> perimeter_sum;
  std::optional<std::string> count;       ///< exact number of triangulations, decimal
  std::optional<StopReason> stop_reason;  ///< of what stopped early
  std::optional<Interval> optimum;
  std::string optimality = "none";
  bool optimum_cached = false;  ///< it was proved earlier and comes from the optimum cache
  std::optional<Interval> alpha;
  bool valid = false;
  double wall_time_s = 0;
  double cpu_time_s = 0;
  std::uint64_t peak_rss_bytes = 0;
  std::vector<std::pair<std::string, double>> phases;
  std::map<std::string, double> counters;
};

/// For people: one fact per line, aligned.
[[nodiscard]] std::string readable_text(const SolveReport& report);

}  // namespace mwt
