// One run in a process of its own: from a request to a judged run, whatever happens to the process.
#pragma once

#include <functional>
#include <string>

#include "harness/rating/rated_run.h"
#include "harness/run/execution.h"
#include "harness/run/process_pool.h"

namespace mwt {

/// Limits of one run in its own process.
struct RunLimits {
  double time_s = 60;                                   ///< the algorithm's soft deadline
  double grace_s = 2;                                   ///< killed at time_s + grace_s
  std::uint64_t memory_bytes = std::uint64_t{2} << 30;  ///< data beyond what the worker begins with
};

/// How times are taken.
struct Timing {
  double min_time_s = 0.005;   ///< CPU time; shorter executions are repeated until they fill it
  bool delaunay_time = false;  ///< whether the Delaunay time is measured too, after everything else
};

/// Starts the run in `pool`. `when_done` gets it judged, not rated: from the worker, or with the status that follows
/// from how the process ended; an exception of the algorithm is a status, too. The process
/// has its own copy of the instance. Precondition: the pool is not full.
///
/// The process is killed at time_s + grace_s, plus an allowance for checking the result and for the
/// Delaunay time that grows with n. An execution longer than time_s + grace_s is a timeout although it has ended.
///
/// With a `proof_file`, the process writes there what proves the algorithm's bounds, if the run is ok and the algorithm
/// has a proof (harness/io/proof_file.h); where there is none, or it cannot be written, the run is as without. Its
/// times include what the algorithm does for the proof.
void start_isolated_run(ProcessPool& pool, const Request& request, const Instance& instance, const RunLimits& limits,
                        const Timing& timing, std::function<void(RatedRun)> when_done,
                        const std::string& proof_file = "");

/// What a run sends back besides its measures: bytes, made in its process from the execution if the run is ok.
using RunEnclosure = std::function<std::string(const Execution&)>;

/// The same; `when_done` also gets the bytes of `enclose`, none unless the run is ok. All that a run sends may take 64
/// MiB.
void start_isolated_run_with(ProcessPool& pool, const Request& request, const Instance& instance,
                             const RunLimits& limits, const Timing& timing, RunEnclosure enclose,
                             std::function<void(RatedRun, std::string)> when_done);

}  // namespace mwt
