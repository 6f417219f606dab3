// Where a series of measurements steps to another level: the nightly runs on which something became slower or faster.
//
// The series is explained by levels that hold for a while (a Potts model): of all ways to do so, the one is taken that
// minimises the sum over all values of min(d^2, clip^2), d being the distance from the level in units of the noise,
// plus `penalty` for each step. As one value adds at most clip^2, a single spike - or any two values in a row - never
// pays for a step, however large: with the defaults it takes 3 values at the end of the series, and 6 in its middle for
// a level that is left again. (The bounded loss is that of P. Fearnhead, G. Rigaill, "Changepoint detection in the
// presence of outliers", JASA 114 (2019).) Levels lie on a grid of a tenth of the noise, on which the minimum is exact
// (Viterbi).
//
// The noise is estimated from the series itself: the largest of the robust standard deviations (median of absolute
// values) of its differences over 1 to 5 places, divided by sqrt(2). Steps and spikes change it little, and differences
// over several places include noise that is correlated from one nightly run to the next.
//
// What to expect, seen in simulations of 20,000 series of 60 values each (change_points_test.cpp repeats them with
// fewer): series with a false alarm, in 20,000: 0 for normal noise, 2 for Student's t with 3 and with 2 degrees of
// freedom and for Laplace's, 9 for skewed noise (exponential), 0 for normal noise with 5% spikes; of autocorrelated
// noise, 42 at an autocorrelation of 0.3, and 1,290 at 0.6, where a wandering level hardly differs from a stepping one.
// A step of 3.3 times the noise was found in 73% of the series 6 nightly runs later and in 99% 16 nightly runs later,
// on the very nightly run in 88%; one of 5 times in 93% 4 nightly runs later. A slow drift becomes a staircase.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mwt {

struct Step {
  std::size_t first = 0;  ///< position of the first value at the new level; never 0
  double before = 0;      ///< median of the values since the step before
  double after = 0;       ///< median of the values until the next step
};

struct StepOptions {
  double penalty = 24;   ///< for each step
  double clip = 3;       ///< in units of the noise
  double min_noise = 0;  ///< the noise is taken to be at least this; 0 is fine unless most values are equal
};

/// All steps, in order. Deterministic. Fewer than 6 values have none. Time O(n^2) for usual series: n times the grid.
/// Preconditions: every value finite, penalty and clip positive; std::invalid_argument otherwise.
[[nodiscard]] std::vector<Step> find_steps(std::span<const double> series, const StepOptions& options = {});

/// The noise as described above; 0 for fewer than 2 values.
[[nodiscard]] double noise_of_series(std::span<const double> series);

/// For a series without noise, as of weights and proved alphas: every change is a step, but a single value between two
/// equal ones (a spike) is none.
[[nodiscard]] std::vector<Step> find_exact_steps(std::span<const double> series);

}  // namespace mwt
