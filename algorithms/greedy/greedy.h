// The greedy triangulation at the cost of one to three Delaunay triangulations.
#pragma once

#include "algorithms/algorithm.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// What the greedy algorithm did.
struct GreedyCounters {
  std::size_t ears = 0;   ///< edges that had to be inserted: those of greedy that were in no triangulation on the way
  std::size_t flips = 0;  ///< flips to insert them and to restore the Delaunay property
  bool stopped_early = false;
};

/// The greedy triangulation of `points`: edges in order of exact squared length, then smaller index, then larger index;
/// each is taken unless it crosses a taken one or passes through a point. Edge for edge what the naive algorithm
/// yields, for arbitrary doubles.
///
/// From the Delaunay triangulation by keeping a constrained Delaunay triangulation of the edges taken so far; README.md
/// describes the method, PROOFS.md why it is right.
/// Preconditions: distinct points, not all collinear, fewer than 2^28.
/// Time O(n log n) in practice: about one and a half of CGAL's Delaunay triangulations on uniform, clustered, lattice
/// and log-radial points; for a million points about two and a half on a circle and on roads, and up to three along a
/// spiral. An adversary can make edge insertions cost more. Less than 200 bytes per point. Deterministic.
[[nodiscard]] Triangulation greedy_triangulation(Points points);

/// Turns a mesh that is the Delaunay triangulation of its points into their greedy triangulation. At the deadline of
/// `context` it stops with a valid triangulation that is greedy up to some length and constrained Delaunay beyond.
/// Other marks on edges survive where the edge does.
GreedyCounters make_greedy(PlanarMesh& mesh, const Context& context);

[[nodiscard]] AlgorithmInfo greedy_entry();

}  // namespace mwt
