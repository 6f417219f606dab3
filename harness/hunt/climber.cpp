#include "harness/hunt/climber.h"

#include <utility>

#include "harness/hunt/moves.h"

namespace mwt {

Climber::Climber(const AlphaOracle& oracle, Index n, std::uint64_t seed, std::uint64_t number, ClimberState state)
    : oracle_(oracle), n_(n), stream_(scatter_bits(seed) + scatter_bits(~number)), state_(std::move(state)) {}

void Climber::step() {
  // An engine of its own for every step, so that the number of evaluations is all there is to save.
  RandomEngine engine(scatter_bits(stream_ + state_.evaluations));
  ++state_.evaluations;
  const std::uint64_t patience = 400 * std::uint64_t{n_};
  if (state_.evaluations - state_.last_progress > patience) start_anew(engine);
  std::vector<Point> points = proposal(engine);
  const std::optional<Interval> alpha = oracle_.alpha(points);
  if (!alpha || alpha->lower < state_.current.alpha) return;
  if (alpha->lower > state_.current.alpha) state_.last_progress = state_.evaluations;
  state_.current = {std::move(points), alpha->lower};
  if (state_.current.alpha > state_.best.alpha) state_.best = state_.current;
}

std::vector<Point> Climber::proposal(RandomEngine& engine) const {
  return state_.current.points.empty() ? random_start(n_, engine) : mutated(state_.current.points, engine);
}

void Climber::start_anew(RandomEngine& engine) {
  state_.last_progress = state_.evaluations;
  state_.current = {};
  const bool from_best = uniform_below(engine, 2) == 0;
  if (!from_best) return;
  constexpr int kShakes = 4;
  std::vector<Point> shaken = state_.best.points;
  for (int i = 0; i < kShakes; ++i) shaken = mutated(std::move(shaken), engine);
  state_.current.points = std::move(shaken);
}

}  // namespace mwt
