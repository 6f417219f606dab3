// 56 bins of directions around a point, and why a point in one bin blocks edges in others.
//
// The diamond test (Das and Joseph 1989; angle pi / 4.6 by Drysdale, McElfresh, Snoeyink, "On exclusion regions for
// optimal triangulations", Discrete Applied Mathematics 109 (2001)): an edge of a minimum weight triangulation has, on
// at least one side, an empty isosceles triangle with base angles kDiamondAngle.
//
// A point at distance r from p, seen at angle d in (0, kDiamondAngle) to the left of direction pq, lies in the left
// triangle of pq as soon as |pq| > r sin(d + kDiamondAngle) / sin(kDiamondAngle). Bins are numbered counter-clockwise
// and five consecutive bins beside a direction's own bin are always within the angle (direction_bins_test.cpp proves
// the figures below), so the nearest points per bin bound the lengths of all edges that may survive in a direction.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "algorithms/exact/candidates/float_rounding.h"

namespace mwt {

inline constexpr double kDiamondAngle = 0.68295492469343343;  // pi / 4.6
inline constexpr double kTangentOfDiamondAngle = 0.81356;     // rounded down: the triangle only shrinks

inline constexpr int kDirectionBins = 56;
inline constexpr int kBinsPerOctant = 7;
inline constexpr int kBlockingBins = 5;  ///< how many bins on each side of a direction's own count

/// Within an octant with t = (smaller / larger coordinate), the bin is 7 t (kBinSlope - kBinCurve t): close to the
/// angle.
inline constexpr float kBinSlope = 1.34761F;
inline constexpr float kBinCurve = 0.34761F;

/// Points closer to a bin's border than this share of a bin do not block: rounding might have moved them across. It
/// moves them by about 1e-5 of a bin, at all distances from kMinDistance on (diamond_kernels.h).
inline constexpr float kBinGuard = 1e-4F;

/// All directions are turned by the angle of this unit vector first, since lattices prefer directions at bin borders.
inline constexpr float kBinTurnCosine = 0.99939F;
inline constexpr float kBinTurnSine = 0.03492F;

/// kBlockingFactor[j]: beyond this multiple of its distance, a point j bins away blocks; rounded up by 1e-4.
/// = sin(s + kDiamondAngle) / sin(kDiamondAngle) for the widest span s of j + 1 consecutive bins.
inline constexpr std::array<float, kBlockingBins + 1> kBlockingFactor = {0,       1.2540F, 1.3557F,
                                                                         1.4395F, 1.5041F, 1.5497F};

/// The position of a direction on the circle of bins, in [0, kDirectionBins]: bin b holds the positions from b to b
/// + 1. Precondition: not the zero vector.
template <class Rounding = RoundedTwice>
[[nodiscard]] float bin_position(float raw_x, float raw_y) {
  const float x = Rounding::multiply_add(-kBinTurnSine, raw_y, kBinTurnCosine * raw_x);
  const float y = Rounding::multiply_add(kBinTurnSine, raw_x, kBinTurnCosine * raw_y);
  const float ax = std::abs(x), ay = std::abs(y);
  const float t = std::min(ax, ay) / std::max(ax, ay);
  float position = t * Rounding::multiply_add(-kBinCurve, t, kBinSlope) * kBinsPerOctant;
  if (ay > ax) position = 2 * kBinsPerOctant - position;
  if (x < 0) position = 4 * kBinsPerOctant - position;
  return y < 0 ? kDirectionBins - position : position;
}

}  // namespace mwt
