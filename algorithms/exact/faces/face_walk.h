// Walks around the faces of the certain edges of a candidate graph.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/exact/candidates/candidate_graph.h"

namespace mwt {

/// A corner of a face: the sector at `vertex` from its certain halfedge `halfedge` counter-clockwise to the next
/// certain one. The face lies in that sector, left of the halfedge. Every halfedge that is not certain lies in exactly
/// one corner, so that candidates belong to faces without any geometry. A vertex is a corner several times where its
/// face touches itself (at slits, for example).
struct Corner {
  Index vertex = 0;
  std::uint32_t halfedge = 0;
  std::uint32_t candidates = 0;  ///< halfedges inside the sector; they follow `halfedge` in the star
};

/// The corners around a face or along one component of its boundary, counter-clockwise.
using Walk = std::vector<Corner>;

/// Whether the walk goes around a triangle without candidates inside.
[[nodiscard]] inline bool is_triangle(const Walk& walk) {
  return walk.size() == 3 && walk[0].candidates == 0 && walk[1].candidates == 0 && walk[2].candidates == 0;
}

/// The target of the corner's candidate number `position`, counter-clockwise from 0.
[[nodiscard]] inline Index candidate_of(const CandidateGraph& graph, const Corner& corner, std::uint32_t position) {
  const std::uint32_t end = graph.first[corner.vertex + 1];
  std::uint32_t halfedge = corner.halfedge + 1 + position;
  if (halfedge >= end) halfedge -= end - graph.first[corner.vertex];
  return graph.target[halfedge];
}

/// Whether one of the corner's candidates leads to `target`.
[[nodiscard]] bool leads_to(const CandidateGraph& graph, const Corner& corner, Index target);

enum class WalkEnd {
  closed,    ///< all the way round; the start is the smallest halfedge of the walk, its owner
  no_owner,  ///< a smaller halfedge was met
  too_long,  ///< more corners than the limit
};

/// Finds a face's corners in counter-clockwise order. A walk around an inner component of a face goes clockwise around
/// the component: the face is always on the left.
///
/// Time per step linear in the star. The functions may be called from several threads.
class FaceWalker {
 public:
  explicit FaceWalker(const CandidateGraph& graph) : graph_(graph) {}

  /// The corners of the walk along certain halfedge `start` of vertex `from`, the start's own corner last. `corners` is
  /// complete only if the walk closed.
  WalkEnd walk(Index from, std::uint32_t start, std::size_t limit, Walk& corners) const;

  /// All corners of the face left of certain halfedge `start` of vertex `from`, wherever in its walk that is; the
  /// start's own corner last.
  [[nodiscard]] Walk corners_of_face(Index from, std::uint32_t start) const;

  /// The same for a certain edge from a to b. O(stars of both ends) more.
  [[nodiscard]] Walk corners_of_face(const Edge& start) const {
    return corners_of_face(start.a, corner_towards(start.a, start.b).halfedge);
  }

  /// The corner at `vertex` whose sector contains or begins with the halfedge to `neighbour`; precondition: the
  /// halfedge exists and the vertex has a certain edge. `candidates` is left 0.
  [[nodiscard]] Corner corner_towards(Index vertex, Index neighbour) const;

  /// The smallest halfedge of the walk around the outer face. O(hull).
  [[nodiscard]] std::uint32_t owner_of_outer_face() const;

  /// The number of points on the hull's boundary. O(hull).
  [[nodiscard]] std::size_t outer_face_size() const;

 private:
  [[nodiscard]] std::uint32_t halfedge_between(Index vertex, Index neighbour) const;
  [[nodiscard]] Corner corner_after(Index from, Index to) const;
  [[nodiscard]] Corner some_corner_of_outer_face() const;

  const CandidateGraph& graph_;
};

}  // namespace mwt
