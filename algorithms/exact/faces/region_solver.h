// Minimum weight triangulation of a face with holes or isolated vertices: by cutting it open where there is one, else
// by dividing it along edges that turn out certain, and by linear programming what cannot be divided.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/stop_reason.h"
#include "geometry/weight.h"

namespace mwt {

struct RegionSolution {
  std::vector<Triangle> triangles;        ///< always a triangulation of the region
  LengthSum diagonals;                    ///< their total length, each once
  double lower_bound = 0;                 ///< certified, on that of any triangulation by candidates
  bool solved = false;                    ///< `triangles` is the best one, up to the interval between the two
  std::optional<StopReason> stop_reason;  ///< why not, unless solved
  std::uint64_t programs = 0;
  std::uint64_t branchings = 0;
};

/// Regions of more empty triangles than this are filled, not solved: GLPK would neither hold nor finish them.
inline constexpr std::size_t kMaximumProgramTriangles = 4'000'000;

/// The best triangulation by candidates. Where the deadline or kMaximumProgramTriangles stops it: the best
/// triangulation found, parts of it perhaps constrained Delaunay, and bounds that still hold.
///
/// With two boundary components: cut_region.h. Otherwise, or where that does not decide it, the region's empty
/// triangles are reduced to those that can fit together (consistent_triangles.h). Edges that all triangulations by
/// these contain (certain_sides.h) divide the region into polygons and smaller regions; one that nothing divides is a
/// linear program (algorithms/triangle_lp/triangle_cover.h).
[[nodiscard]] RegionSolution solve_region(Points points, const FaceRegion& region, const Deadline& deadline);

/// The region filled with a constrained Delaunay triangulation and the simple lower bound.
[[nodiscard]] RegionSolution leave_unsolved(Points points, const FaceRegion& region, StopReason reason);

}  // namespace mwt
