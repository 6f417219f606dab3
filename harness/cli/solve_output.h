// What `mwt solve` prints about one triangulation.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "geometry/point.h"
#include "harness/rating/rated_run.h"

namespace mwt {

/// What was solved and how, and the rated run.
struct SolveOutput {
  std::string algorithm;
  std::map<std::string, std::string> parameters;
  std::uint64_t seed = 1;
  int threads = 1;
  Index n = 0;
  Index distinct = 0;
  Index duplicates = 0;
  Index hull_size = 0;
  RatedRun run;
  bool optimum_cached = false;  ///< the optimum was proved earlier and comes from the optimum cache
};

/// For people: one fact per line, aligned.
[[nodiscard]] std::string readable_text(const SolveOutput& output);

}  // namespace mwt
