// The faces between fixed edges: what is inside each, and how large ones are made smaller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "algorithms/greedy/greedy_parts.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Fixed edges cut the plane into faces that do not influence each other. Those that no cache holds are made smaller by
/// fixing edges that are certainly greedy, in the order of memory: those that CrossingBounds proves, then CertainEars.
/// Marks edges inside with kFaceMark while they are collected, and with what was tried on them.
class Faces {
 public:
  /// Faces with more edges than `large_face` are large.
  Faces(const GreedyParts& parts, std::size_t large_face) : parts_(parts), mesh_(parts.mesh), large_face_(large_face) {}

  /// Allocates memory for faces of so many edges.
  void reserve(std::size_t edges) { edges_.reserve(edges); }

  /// Tries the next means to make the face with e inside smaller, if it is large; call it again then. False if it is
  /// small or nothing is left to try: edges() are all edges inside then, e among them.
  [[nodiscard]] bool reduce_face(MeshEdge e);

  /// Collected by the last call that returned false. In any order, for any use.
  [[nodiscard]] std::span<MeshEdge> edges() { return edges_; }

  /// Ears fixed so far that were no edges of the mesh before.
  [[nodiscard]] std::size_t inserted_ears() const { return inserted_ears_; }

  /// Whether the deadline has passed.
  [[nodiscard]] bool stopped_early() const { return stopped_; }

 private:
  void collect(MeshEdge e);
  [[nodiscard]] bool are_bounds_promising() const;
  void fix_uncrossed();
  void take_certain_ears();
  void leave(std::uint32_t tried);
  void sort();

  GreedyParts parts_;
  PlanarMesh& mesh_;
  std::size_t large_face_;
  KeptVector<MeshEdge> edges_;
  std::size_t inserted_ears_ = 0;
  bool stopped_ = false;
};

}  // namespace mwt
