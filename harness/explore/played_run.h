// An algorithm's run with all its steps.
#pragma once

#include <functional>
#include <string>

#include "harness/rating/isolated_run.h"

namespace mwt {

/// Starts the run in a process of its own; `when_done` gets it, and the encoded frame `trace` of harness/explore/jobs.h
/// if the run is ok and has steps. Precondition: the pool is not full.
void start_played_run(ProcessPool& pool, Request request, const Instance& instance, const RunLimits& limits,
                      std::function<void(RatedRun, std::string)> when_done);

}  // namespace mwt
