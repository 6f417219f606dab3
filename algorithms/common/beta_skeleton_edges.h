// Edges of the beta-skeleton: every minimum weight triangulation contains them, so that searches end there.
#pragma once

#include "geometry/mesh/angle.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Mark of an edge known to be in every minimum weight triangulation.
inline constexpr std::uint32_t kBetaSkeletonMark = 1U << 16;
static_assert((kBetaSkeletonMark & kLastingMarks) != 0);

/// Marks the edges of the beta-skeleton for beta = 1.17682: S.-W. Cheng, Y.-F. Xu, "On beta-skeleton as a subgraph of
/// the minimum weight triangulation", Theoretical Computer Science 262 (2001). In the Delaunay triangulation they are
/// the edges whose opposite angles are both at most arcsin(1/beta), about 58.19 degrees. Rounded towards no mark.
/// Precondition: the mesh is a Delaunay triangulation. O(n).
void mark_beta_skeleton(PlanarMesh& delaunay);

/// Whether the angle is surely at most arcsin(1/beta). `angle` is not above 180 degrees. O(1).
[[nodiscard]] bool is_surely_small(const Angle& angle);

/// Points that see an edge at a larger angle are at most this multiple of its length from either end: beta, rounded up.
inline constexpr double kMaxDistanceOfWitness = 1.18;

/// Marks those edges of `mesh`, any triangulation of the same points, that are beta-skeleton edges in `delaunay`. O(n
/// log n).
void copy_beta_skeleton(const PlanarMesh& delaunay, PlanarMesh& mesh);

}  // namespace mwt
