// Forces given edges into a Delaunay mesh.
#pragma once

#include <span>
#include <vector>

#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Makes a Delaunay mesh the constrained Delaunay triangulation that contains given edges. Constraints that are there
/// already cost a look around one of their ends; for others the edges that they cross are flipped out (S. W. Sloan, "A
/// fast algorithm for generating constrained Delaunay triangulations", Computers & Structures 47, 1993), and the
/// Delaunay property is restored by Lawson's flips.
///
/// Preconditions: `edges` in the caller's numbers of points; no two cross, none passes through a point, otherwise
/// std::logic_error (found where they meet in the mesh; the mesh is then of no use). Exact. Leaves no marks. Linear in
/// practice for short constraints; 8 bytes per point besides the mesh. Deterministic.
void insert_constraints(PlanarMesh& delaunay, std::span<const Edge> edges);

}  // namespace mwt
