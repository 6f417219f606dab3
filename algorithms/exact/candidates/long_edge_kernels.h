// The inner loop of the diamond test for long edges, on vectors: chosen at run time for the machine's instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

#include "algorithms/exact/candidates/direction_bins.h"
#include "geometry/point.h"

namespace mwt {

/// kTangentOfDiamondAngle is less than the tangent by 4e-7 of it: more than all rounding of doubles, so that points
/// that turn out below the roof of a triangle are there.
inline constexpr double kTangentForDoubles = kTangentOfDiamondAngle;

/// Products below this may have lost bits to underflow.
inline constexpr double kTrustedProduct = 1e-280;

/// Points to look for in triangles: coordinates one by one, padded with NaN to a multiple of kWidth.
struct PointColumns {
  static constexpr std::size_t kWidth = 8;

  const double* x;
  const double* y;
  std::size_t count;  ///< with the padding
};

/// Which triangles of edge pq hold a point.
struct DiamondOccupancy {
  bool left = false;
  bool right = false;
  bool on_edge = false;  ///< a point lies in the edge's interior

  [[nodiscard]] bool excludes() const { return on_edge || (left && right); }
};

/// Stops as soon as the edge is excluded. `scale`: see NearPoints. The edge's own ends may be among the points.
[[nodiscard]] DiamondOccupancy find_occupancy(const PointColumns& points, const Point& p, const Point& q, double scale);

}  // namespace mwt
