// Points on an ellipse.
#pragma once

#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo ellipse_entry();

/// (cos t, aspect sin t) for t = 2 pi (i + 1/4) / n: the affine image of a regular n-gon, counter-clockwise, in
/// strictly convex position.
///
/// Why it is bad: for every aspect below 1 the Delaunay triangulation is the zigzag across the short axis: its edges,
/// as chords of the n-gon, are those of the two directions nearest to that axis (a quarter step of phase makes the two
/// equally near, so that no four points are cocircular). A flip would turn such a chord into one of the same number of
/// steps and a direction farther from the axis, which is longer: the zigzag is also a local optimum of flips, while
/// the optimum cuts corners. With the aspect near 1 this is the zigzag of the regular polygon.
/// Precondition: 3 <= n <= kMaxEllipse, 2^-20 <= aspect <= 1. The same on every platform. O(n).
[[nodiscard]] std::vector<Point> ellipse_points(Index n, double aspect);

/// Multiplying by the aspect adds one rounding to those of regular_polygon(), whose bound leaves more than that.
inline constexpr Index kMaxEllipse = 10'000'000;

}  // namespace mwt
