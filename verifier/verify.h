// Checks a proof that a triangulation is a minimum weight triangulation of a set of points, or nearly one.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt::verifier {

struct Verdict {
  double lower = 0;         ///< the weight of a minimum weight triangulation lies in [lower, upper]
  double upper = 0;         ///< and so does that of the triangulation in the proof
  bool is_optimal = false;  ///< (upper - lower) / upper <= kOptimalWidth: is_narrow()

  std::size_t points = 0;
  std::size_t candidates = 0;  ///< after the diamond test
  std::size_t removed = 0;
  std::size_t certain = 0;
  std::size_t regions = 0;
};

inline constexpr double kOptimalWidth = 1e-12;

/// Whether the interval is no wider than that, as those of optima are. An upper end beyond all doubles is infinity, and
/// such an interval is not.
[[nodiscard]] inline bool is_narrow(double lower, double upper) {
  return std::isfinite(upper) && upper - lower <= kOptimalWidth * upper;
}

/// What README.md says, step by step. The interval is computed here; the one that the proof claims must agree with it:
/// the two have points in common, and neither end of the one proved is outside the one claimed by more than
/// kOptimalWidth of itself.
///
/// Points as read from a file; equal ones count once. Throws Refused at the first step that does not follow, naming it
/// and its place; points by their positions in the file. Throws InputError if the points have no triangulation or the
/// file is no proof.
[[nodiscard]] Verdict verify(const std::vector<Point>& points, const std::string& proof_file);

}  // namespace mwt::verifier
