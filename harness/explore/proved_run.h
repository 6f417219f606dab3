// An exact algorithm's run with the proof of its result.
#pragma once

#include <functional>
#include <string>

#include "harness/rating/isolated_run.h"

namespace mwt {

/// Starts the run in a process of its own; `when_done` gets it, and the content of its proof file (verifier/FORMAT.md),
/// empty if it proves nothing. Preconditions: the pool is not full, the algorithm has proofs.
void start_proved_run(ProcessPool& pool, Request request, const Instance& instance, const RunLimits& limits,
                      std::function<void(RatedRun, std::string)> when_done);

}  // namespace mwt
