// How sure one can be of a probability after counting successes.
#pragma once

#include <cstdint>

namespace mwt {

/// Holds the probability.
struct ProbabilityInterval {
  double lower = 0;
  double upper = 1;
};

/// The exact interval of C. J. Clopper, E. S. Pearson, "The use of confidence or fiducial limits illustrated in the
/// case of the binomial", Biometrika 26 (1934): whatever the probability of success, it lies in the interval with at
/// least the given confidence. Without trials: [0, 1].
///
/// Preconditions: successes <= trials, 0 < confidence < 1; std::invalid_argument otherwise.
[[nodiscard]] ProbabilityInterval clopper_pearson(std::uint64_t successes, std::uint64_t trials,
                                                  double confidence = 0.95);

}  // namespace mwt
