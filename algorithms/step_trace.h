// What an algorithm did, step by step, for pages that play it.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/triangulation.h"

namespace mwt {

/// A point was inserted: the triangle that held it, and the corner opposite the side on which it lies, or kNoIndex.
struct TracedSplit {
  Triangle triangle;
  Index point = kNoIndex;
  Index opposite = kNoIndex;
};

/// A patch was triangulated anew: its edges that are no longer there, and those in their place.
struct TracedPatch {
  std::vector<Edge> removed;
  std::vector<Edge> added;
  double gain = 0;  ///< how much shorter the new edges are, for display
};

/// A cell of a quadtree, a parent before its children.
struct TracedCell {
  double left = 0;
  double bottom = 0;
  double right = 0;
  double top = 0;
  bool is_leaf = false;
  std::vector<Edge> edges;  ///< of a leaf: those of its points' own triangulation
};

/// An algorithm that supports it fills the one that its context points to; it returns the same triangulation.
struct StepTrace {
  std::vector<Edge> kept;            ///< greedy: its edges in the order in which it takes them
  std::vector<Triangle> start;       ///< insertion, patches, annealing: the triangles before
  std::vector<TracedSplit> splits;   ///< insertion: in order; a point on an edge splits two triangles
  std::vector<TracedPatch> patches;  ///< patches: those that improved, in order
  std::vector<Flip> flips;           ///< annealing: in order; where an edge became longer the gain is negative
  std::size_t annealed = 0;          ///< annealing: so many of the flips come before those to a local optimum
  std::vector<TracedCell> cells;     ///< quadtree
  std::vector<Edge> joints;          ///< quadtree: the edges that join leaves, those within smaller cells first
  std::vector<Edge> cuts;            ///< exact: where it cuts faces with holes open; parts of them, too
};

}  // namespace mwt
