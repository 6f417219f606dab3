// What an algorithm did, step by step, for pages that play it.
#pragma once

#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// A point was inserted: the triangle that held it, and the corner opposite the side on which it lies, or kNoIndex.
struct TracedSplit {
  Triangle triangle;
  Index point = kNoIndex;
  Index opposite = kNoIndex;
};

/// An algorithm that supports it fills the one that its context points to; it returns the same triangulation.
struct StepTrace {
  std::vector<Edge> kept;           ///< greedy: its edges in the order in which it takes them
  std::vector<Triangle> start;      ///< insertion: the triangles before it
  std::vector<TracedSplit> splits;  ///< insertion: in order; a point on an edge splits two triangles
};

}  // namespace mwt
