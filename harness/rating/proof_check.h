// What the verifier says of a proof file, in a process of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "geometry/numbers/interval.h"
#include "harness/rating/isolated_run.h"
#include "harness/run/execution.h"
#include "harness/run/process_pool.h"

namespace mwt {

enum class ProofVerdict {
  optimal,  ///< verified: the optimum
  bounded,  ///< verified: bounds on the optimum
  refused,  ///< a step does not follow: the solver or what writes its proofs is wrong, or the file is damaged
  failed,   ///< no verdict: a limit, or the verifier failed
};

[[nodiscard]] std::string to_text(ProofVerdict verdict);
/// Throws std::invalid_argument.
void read_text(const std::string& text, ProofVerdict& verdict);

struct ProofCheck {
  ProofVerdict verdict = ProofVerdict::failed;
  std::optional<Interval> interval;  ///< of the verifier's own computation, if it verified
  std::string note;                  ///< without an interval, why
  double time_s = 0;                 ///< of the verifier
  std::uint64_t bytes = 0;           ///< size of the file
};

/// Lets the verifier (verifier/verify.h) read the file in a process of its own: killed when it has used limits.time_s +
/// grace_s of CPU time, with limits.memory_bytes. Preconditions: the file exists, the pool is not full.
void start_proof_check(ProcessPool& pool, const Instance& instance, const std::string& file, const RunLimits& limits,
                       std::function<void(const ProofCheck&)> when_done);

}  // namespace mwt
