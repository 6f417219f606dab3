// Minimum weight triangulation of a face with holes or isolated vertices: by cutting it open where there is one, by
// linear programming where there are more.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/exact/face_region.h"
#include "geometry/weight.h"

namespace mwt {

struct RegionSolution {
  std::vector<Triangle> triangles;  ///< always a triangulation of the region
  LengthSum diagonals;              ///< their total length, each once
  double lower_bound = 0;           ///< certified, on that of any triangulation by candidates
  bool solved = false;              ///< `triangles` is the best one, up to the interval between the two
  std::uint64_t programs = 0;
  std::uint64_t branchings = 0;
};

/// Regions of more empty triangles than this are filled, not solved: GLPK would neither hold nor finish them.
inline constexpr std::size_t kMaximumProgramTriangles = 4'000'000;

/// The best triangulation by candidates (see algorithms/triangle_lp/triangle_cover.h). Where the deadline or
/// kMaximumProgramTriangles stops it: the best cover found or a constrained Delaunay triangulation, and bounds that
/// still hold.
[[nodiscard]] RegionSolution solve_region(Points points, const FaceRegion& region,
                                          const std::optional<std::chrono::steady_clock::time_point>& deadline);

/// The region filled with a constrained Delaunay triangulation and the simple lower bound.
[[nodiscard]] RegionSolution leave_unsolved(Points points, const FaceRegion& region);

}  // namespace mwt
