// The faces between fixed edges: what is inside each, and how large ones are made smaller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/bounds/crossing_bounds.h"
#include "algorithms/greedy/ears/certain_ears.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/face_cuts.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Fixed edges cut the plane into faces that do not influence each other. Those that no cache holds are made smaller by
/// fixing edges that are certainly greedy, in the order of memory: the edges that CrossingBounds proves, CertainEars,
/// FaceCuts. Marks edges inside with kFaceMark while they are collected, and with what was tried on them.
///
/// Precondition of all: the mesh is a Delaunay triangulation constrained by the edges of kFixedMark, all greedy.
class Faces {
 public:
  /// Faces with more edges than `large_face` are large.
  Faces(PlanarMesh& mesh, const EdgeOrder& order, FixedStars& stars, EarInsertion& insertion, const Context& context,
        std::size_t large_face)
      : mesh_(mesh),
        large_face_(large_face),
        stars_(stars),
        certain_ears_(mesh, order, stars, insertion, context),
        crossing_bounds_(mesh),
        cuts_(mesh) {}

  /// Allocates memory for faces of so many edges.
  void reserve(std::size_t edges) { edges_.reserve(edges); }

  /// If most edges are inside large faces, makes all faces smaller, without telling them apart. True if they are still
  /// large after that: edges() are those of all faces then.
  [[nodiscard]] bool reduce_all();

  /// Tries the next means to make the face with e inside smaller, if it is large: its edges are to be asked for again
  /// then. False if it is small or nothing is left to try: edges() are all edges inside then, e among them.
  [[nodiscard]] bool reduce_face(MeshEdge e);

  /// Collected by the last call that leaves something to be solved. In any order, for any use.
  [[nodiscard]] std::span<MeshEdge> edges() { return edges_; }

  /// Ears fixed so far that were no edges of the mesh before.
  [[nodiscard]] std::size_t inserted_ears() const { return certain_ears_.inserted(); }

  /// Whether the deadline has passed.
  [[nodiscard]] bool stopped_early() const { return stopped_; }

 private:
  [[nodiscard]] bool are_large();
  [[nodiscard]] bool reduce(std::uint32_t tried);
  void divide();
  void take_certain_ears();
  void cut();
  void collect_all();
  void collect(MeshEdge e, std::size_t most = std::numeric_limits<std::size_t>::max());
  void leave(std::uint32_t tried);
  void sort();

  PlanarMesh& mesh_;
  std::size_t large_face_;
  FixedStars& stars_;
  CertainEars certain_ears_;
  CrossingBounds crossing_bounds_;
  FaceCuts cuts_;
  KeptVector<MeshEdge> edges_;
  bool stopped_ = false;
};

}  // namespace mwt
