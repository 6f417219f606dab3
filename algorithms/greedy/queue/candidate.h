// What may become greedy's next edge, and the queue of such candidates that came up on the way.
#pragma once

#include <cstdint>
#include <queue>

#include "geometry/mesh/edge_order.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// A mesh edge, or an ear: an edge that cuts off the corner between two fixed ones.
class Candidate {
 public:
  /// A mesh edge, as long as it is not flipped away.
  [[nodiscard]] static Candidate edge(const PlanarMesh& mesh, const EdgeOrder& order, MeshEdge e) {
    return Candidate(order.key(mesh.origin(2 * e), mesh.target(2 * e), 2 * e));
  }
  /// The third side of a wedge, named by its first halfedge, which is fixed and so stays.
  [[nodiscard]] static Candidate ear(const PlanarMesh& mesh, const EdgeOrder& order, Halfedge first, Halfedge last) {
    return Candidate(order.key(mesh.target(first), mesh.target(last), kEarBit | first));
  }

  [[nodiscard]] const EdgeKey& key() const { return key_; }
  [[nodiscard]] bool is_ear() const { return (key_.tag & kEarBit) != 0; }
  [[nodiscard]] Halfedge place() const { return key_.tag & ~kEarBit; }
  [[nodiscard]] bool joins(Index a, Index b) const {
    return (key_.a == a && key_.b == b) || (key_.a == b && key_.b == a);
  }

 private:
  static constexpr std::uint32_t kEarBit = std::uint32_t{1} << 31;  // a mesh has fewer than 3 * 2^29 halfedges
  explicit Candidate(const EdgeKey& key) : key_(key) {}

  EdgeKey key_;
};

/// Whether one candidate comes after another in greedy's order.
struct ComesLater {
  const EdgeOrder* order;
  bool operator()(const Candidate& one, const Candidate& two) const { return order->precedes(two.key(), one.key()); }
};

/// The first candidate in greedy's order on top.
class CandidateQueue : public std::priority_queue<Candidate, KeptVector<Candidate>, ComesLater> {
 public:
  explicit CandidateQueue(const EdgeOrder& order) : priority_queue(ComesLater{&order}) {}
};

}  // namespace mwt
