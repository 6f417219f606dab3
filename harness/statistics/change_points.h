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
// Noise that is correlated from one nightly run to the next makes levels that wander, which such a staircase explains
// as steps. Each step must therefore be evident, too: its height, the difference of the medians at both sides, is
// compared with its standard error for noise with the autocorrelation that the series shows around its levels
// (corrected for their estimation, and raised by a margin for its own error). The least evident step is taken out, and
// the rest judged anew, until all that are left are evident.
//
// What to expect: change_points_test.cpp measures it, and README.md of harness/tracking/ has its table. Of 1,000 stable
// series of 60 values fewer than one has a false alarm, whether noise is normal, heavy-tailed, skewed, spiky, or
// autocorrelated by up to 0.6. The price: what is seen of a short series does not exclude autocorrelation, so that a
// step needs more nightly runs to be found than in noise that is known to be independent. A slow drift becomes a
// staircase.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace mwt {

struct Step {
  std::size_t first = 0;  ///< position of the first value at the new level; never 0
  double before = 0;      ///< median of the values since the step before
  double after = 0;       ///< median of the values until the next step
  double error = 0;       ///< the standard error of after - before; 0 for series without noise
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

/// For a series with hardly any noise, as of instructions: every value that lies off the level, the median of the
/// values since the last step, by more than the tolerance is a step, but a single one before a return to the level is
/// none. Precondition: tolerance is positive; std::invalid_argument otherwise.
[[nodiscard]] std::vector<Step> find_steps_beyond(std::span<const double> series, double tolerance);

/// For a series without noise, as of weights and proved alphas: every change is a step, but a single value between two
/// equal ones (a spike) is none.
[[nodiscard]] std::vector<Step> find_exact_steps(std::span<const double> series);

}  // namespace mwt
