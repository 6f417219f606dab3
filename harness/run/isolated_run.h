// One run in a process of its own: from a request to a complete row, whatever happens to the process.
#pragma once

#include <functional>
#include <memory>

#include "harness/records/records.h"
#include "harness/run/execution.h"
#include "harness/run/process_pool.h"
#include "harness/run/worker.h"
#include "harness/study/study.h"

namespace mwt {

/// Starts the run in `pool`. `keys` says what is run; the record handed to `when_done` is it with status and measures
/// filled in: from the worker, or from how the process ended. Precondition: the pool is not full.
///
/// The process is killed at time_s + grace_s, plus an allowance for checking the result and for the
/// Delaunay time that grows with n.
void start_isolated_run(ProcessPool& pool, const Request& request, std::shared_ptr<const Instance> instance,
                        const RunRecord& keys, const RunLimits& limits, const Timing& timing,
                        std::function<void(RunRecord)> when_done);

}  // namespace mwt
