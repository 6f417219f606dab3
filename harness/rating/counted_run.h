// What valgrind's callgrind counts of a run: instructions, simulated misses, and which functions they are in.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "harness/rating/isolated_run.h"
#include "harness/run/callgrind/profile.h"

namespace mwt {

/// Whether valgrind is there to be run.
[[nodiscard]] bool has_valgrind();

/// Whether the run can be counted: it is ok and complete, and was run here by one thread.
[[nodiscard]] bool can_be_counted(const RatedRun& run, const Request& request);

struct CountedRun {
  std::optional<CallgrindProfile> profile;
  std::string why_not;  ///< if there is none
};

/// Executes the algorithm once more, by `program` (a path of mwt) under callgrind in a process of its own, without a
/// time limit of its own, and counts the algorithm alone. Caches are simulated as results/README.md says, on every
/// machine. Nothing is counted if that takes 300 times as long as the measured run and ten minutes, or gives another
/// triangulation's weight than the measured run.
///
/// Valgrind executes the instructions of a processor that it supports: code that chooses by the processor (Highway's
/// kernels) takes its AVX2 form there, whatever the machine has. It rounds to nearest always, so that certified bounds
/// computed under it are worth nothing; only the counts are taken.
///
/// Preconditions: can_be_counted(); the pool is not full.
void start_counted_run(ProcessPool& pool, const std::string& program, const Request& request, const Instance& instance,
                       const RunLimits& limits, const RatedRun& measured, std::function<void(CountedRun)> when_done);

}  // namespace mwt
