// What a solver concludes on its way to an optimum, so that a program that shares no code with it can check every step.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/numbers/interval.h"
#include "geometry/triangulation.h"

namespace mwt {

/// Why edges leave the candidates, or are certain. verifier/README.md has the theorems.
enum class EdgeReason : std::uint8_t {
  not_locally_minimal,  ///< leaves: no quadrilateral of empty triangles of candidates in which no flip shortens it
  crosses_certain,      ///< leaves: it crosses an edge that is certain
  uncrossed,            ///< is certain: at one of its ends, no side of an empty triangle of candidates crosses it
  in_beta_skeleton,     ///< is certain: no point sees it at more than 58 degrees
};

/// Edges for which the same reason holds, one after the other: each conclusion may build on those before.
struct EdgeConclusions {
  EdgeReason reason = EdgeReason::uncrossed;
  std::vector<Edge> edges;
  std::vector<Edge> crossed;  ///< crosses_certain: for each edge a certain one that it crosses, or one from a point
                              ///< to itself if the edge passes through a point
};

/// A node of a tree of decisions on a region's open edges, in preorder.
struct DualNode {
  enum class Kind : std::uint8_t {
    leaf,         ///< dual values
    branch,       ///< an edge, followed by the tree of the case that it is part of the triangulation, then by that of
                  ///< the case that it is not
    base,         ///< dual values, followed by a tree whose leaves may be changes
    changed_leaf  ///< the dual values of the nearest base above, but for some
  };
  Kind kind = Kind::leaf;
  std::uint32_t edge = 0;                    ///< branch: position among the region's open edges
  std::vector<std::uint32_t> changed_sides;  ///< changed_leaf: positions, ascending, of what the following are about
  std::vector<std::uint32_t> changed_edges;  ///< changed_leaf: the same for open edges
  std::vector<std::int64_t> side_duals;      ///< of the sides, walk by walk, each before the next corner
  std::vector<std::int64_t> edge_duals;      ///< of the open edges' sides from their first to their second place
  std::vector<std::int64_t> other_duals;     ///< of their other sides; may be empty where no edge is decided to be in
};

/// Dual values that bound what the open edges (candidates that are not certain) of a region weigh; see
/// verifier/regions.h for what they prove. The unit of length is 2^unit_exponent.
struct DualRegion {
  int unit_exponent = 0;
  std::vector<Index> places;              ///< the points of all walks around the region, then isolated ones
  std::vector<std::uint32_t> walk_sizes;  ///< the region lies left of each closed walk
  std::vector<std::array<std::uint32_t, 2>> open_edges;  ///< by places, first < second; ascending
  std::vector<DualNode> tree;
  double lower_bound = 0;  ///< what the dual values prove, rounded down
};

/// The conclusions in their order; edges and points by position in `order`. A solver that supports proofs fills the one
/// that its context points to; it does nothing else differently.
struct ProofTrace {
  std::vector<Index> order;  ///< the instance's points by position; empty: as they are
  std::vector<EdgeConclusions> edges;
  std::vector<DualRegion> regions;
  double lower_bound = 0;    ///< what all this proves of the optimum, rounded down
  bool is_complete = false;  ///< set by solvers that wrote what they have; others leave everything empty
};

/// The trace of a bound that needs no conclusions, such as the length of the hull.
[[nodiscard]] inline ProofTrace trace_of_bound(double lower_bound) {
  ProofTrace trace;
  trace.lower_bound = lower_bound;
  trace.is_complete = true;
  return trace;
}

}  // namespace mwt
