// Places on the boundary of a face: wedges in the mesh, corners on the list of its boundary.
#pragma once

#include <cstdint>

#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// The room between two fixed halfedges with one origin, counter-clockwise from `first` to `last`, nothing fixed
/// between.
struct Wedge {
  Halfedge first;
  Halfedge last;
};

/// A place on the boundary of a face (FaceBoundary), by its number. A point has as many corners as the face comes to
/// it.
using Corner = std::uint32_t;

}  // namespace mwt
