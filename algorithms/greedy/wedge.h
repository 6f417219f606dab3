// The room between two neighbouring greedy edges at a point.
#pragma once

#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// The wedge between two fixed halfedges with one origin, counter-clockwise from `first` to `last`, nothing fixed
/// between.
struct Wedge {
  Halfedge first;
  Halfedge last;
};

}  // namespace mwt
