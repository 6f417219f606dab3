// Minimum weight triangulation of a face with one hole or one isolated vertex: a shortest path in its universal cover.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_region.h"
#include "geometry/weight.h"

namespace mwt {

struct AnnulusSolution {
  std::vector<Triangle> triangles;  ///< none if none below the limit was found
  LengthSum diagonals;
  double lower_bound = 0;  ///< certified: triangulations by candidates are not lighter, or not below the limit
  bool is_late = false;    ///< the deadline stopped the search: better triangulations may exist
};

/// A triangulation of such a face has edges from the outer to the inner boundary. Two that follow each other span a
/// triangle whose third side is a chord of one boundary (or an edge of it) that cuts off a polygon without hole; so it
/// is a closed path in the strip that covers the face (strip.h), and the lightest one is found by strip_paths.h, given
/// what each chord cuts off: the interval program of each boundary, repeated twice so that chords across the cut are
/// intervals too. Every triangulation contains one of a few edges at an extreme point of the hole, where paths begin.
///
/// `limit`: what is not lighter than this is of no interest. Nothing if the region is no such face (see make_strip()),
/// has no triangulation by candidates, or if the deadline passes before bounds are known. Exact and deterministic,
/// except for the deadline. Time: that of a polygon's program over both boundaries twice, and O(arcs of the strip).
[[nodiscard]] std::optional<AnnulusSolution> solve_annulus(Points points, const FaceRegion& region, double limit,
                                                           const Deadline& deadline);

}  // namespace mwt
