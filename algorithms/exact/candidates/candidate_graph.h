// Which edges may still belong to a minimum weight triangulation, in order around every vertex.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The graph that the LMT-skeleton hands to the face solver: halfedges in compressed rows, one row (star) per vertex.
///
/// Properties:
///   (1) each edge is in both ends' stars, none twice, no certain edge with a point in its interior;
///   (2) each star is in counter-clockwise cyclic order, exact, starting anywhere, no direction twice;
///   (3) some minimum weight triangulation uses candidates only and contains every certain edge;
///   (4) certain edges do not cross each other; hull edges (between neighbours on the boundary) are certain.
/// A few candidates may cross certain edges or pass through points that are no neighbours of their ends. No minimum
/// weight triangulation contains those; the face solver finds and deletes what matters (crossing_candidates.h).
struct CandidateGraph {
  Points points;
  std::vector<std::uint32_t> first;   ///< star of v: halfedges first[v] .. first[v + 1]; size n + 1
  std::vector<Index> target;          ///< the other end of each halfedge
  std::vector<std::uint8_t> certain;  ///< 1 if the edge is known to be in the minimum weight triangulation

  [[nodiscard]] std::span<const Index> star(Index v) const {
    return std::span(target).subspan(first[v], first[v + 1] - first[v]);
  }
};

/// The graph of these edges, each once, of which those among `certain` (ascending) are certain. The points must stay
/// alive. O(edges log edges).
[[nodiscard]] CandidateGraph make_candidate_graph(Points points, std::span<const Edge> edges,
                                                  std::span<const Edge> certain);

/// The edges of the graph that are certain (1) or not (0): a < b, those of one vertex a in the order of its star.
[[nodiscard]] std::vector<Edge> edges_marked(const CandidateGraph& graph, std::uint8_t certain);

}  // namespace mwt
