// One hill climber that looks for an instance with large alpha.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "generators/random.h"
#include "harness/hunt/alpha_oracle.h"

namespace mwt {

/// An instance and how badly the algorithm does on it; alpha 0 stands for none yet.
struct RatedInstance {
  std::vector<Point> points;
  double alpha = 0;  ///< lower end of the certified interval
};

/// The whole state of a climber: saving and restoring it continues the climb exactly.
struct ClimberState {
  std::uint64_t evaluations = 0;
  std::uint64_t last_progress = 0;  ///< the evaluation at which `current` last became better
  RatedInstance current;
  RatedInstance best;
};

/// Hill climbing: each step mutates the current instance and keeps the change unless alpha becomes smaller (steps on
/// plateaus are taken). After 400 n evaluations without progress it starts anew, in turns from random points and from a
/// shaken copy of its best instance. Deterministic: a step depends on the state, the seed and the climber's number
/// only.
class Climber {
 public:
  Climber(const AlphaOracle& oracle, Index n, std::uint64_t seed, std::uint64_t number, ClimberState state = {});

  /// One evaluation.
  void step();

  [[nodiscard]] const ClimberState& state() const { return state_; }

 private:
  [[nodiscard]] std::vector<Point> proposal(RandomEngine& engine) const;
  void start_anew(RandomEngine& engine);

  const AlphaOracle& oracle_;
  Index n_;
  std::uint64_t stream_;
  ClimberState state_;
};

}  // namespace mwt
