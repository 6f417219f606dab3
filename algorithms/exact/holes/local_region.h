// A region on its own: its points in lexicographic order, everything by their numbers.
#pragma once

#include <vector>

#include "algorithms/exact/faces/face_region.h"

namespace mwt {

/// What remains valid when the instance's other points are forgotten.
struct LocalRegion {
  std::vector<Index> vertices;  ///< in the whole instance
  std::vector<Point> points;    ///< in lexicographic order
  std::vector<Edge> boundary;   ///< directed, the region on the left
  std::vector<Edge> sides;      ///< directed edges that may have a triangle on their left

  /// The same triangles by their numbers in the whole instance.
  [[nodiscard]] std::vector<Triangle> in_instance(std::vector<Triangle> triangles) const;
};

[[nodiscard]] LocalRegion make_local(Points points, const FaceRegion& region);

}  // namespace mwt
