// The search for bad inputs: several climbers side by side, their state on disk.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/hunt/climber.h"

namespace mwt {

/// What a hunt is: two hunts that agree here do the same steps.
struct HuntPlan {
  Request request;                        ///< the algorithm that is hunted, its parameters and its seed
  const AlgorithmInfo* solver = nullptr;  ///< exact
  Index n = 0;
  std::uint64_t seed = 1;
  int climbers = 1;  ///< each in a thread of its own

  /// One line that names all of this; first line of the state file.
  [[nodiscard]] std::string identity() const;
};

/// When to stop; whichever comes first.
struct HuntLimits {
  double budget_s = 60;
  std::optional<std::uint64_t> evaluations;  ///< of each climber, earlier calls included; makes a hunt deterministic
};

struct HuntResult {
  RatedInstance worst;
  std::uint64_t evaluations = 0;  ///< of all climbers, earlier calls included
  bool interrupted = false;
};

/// Runs the climbers until a limit or an interrupt, keeping their state in `state_file`, written every second and at
/// the end, complete or not at all: after kill -9 a second is lost. `has_improved` is called with better instances, at
/// most once a second, in the calling thread.
///
/// If `state_file` exists, the hunt goes on from there; throws InputError if it is another hunt's or damaged.
/// std::logic_error from an oracle ends the hunt.
[[nodiscard]] HuntResult hunt(const HuntPlan& plan, const HuntLimits& limits, const std::string& state_file,
                              const std::function<void(const HuntResult&)>& has_improved);

}  // namespace mwt
