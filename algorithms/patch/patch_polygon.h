// The weakly simple polygon around a few triangles of a mesh, and its optimal triangulation.
#pragma once

#include <vector>

#include "algorithms/mesh/planar_mesh.h"

namespace mwt {

/// One patch after the other: grow, then improve. Keeps its arrays.
class PatchPolygon {
 public:
  explicit PatchPolygon(PlanarMesh& mesh) : mesh_(mesh) {}

  /// Takes up to k triangles by breadth-first search in the dual from the one left of `start`, never across hull edges
  /// nor edges with one of the marks `closed`.
  void grow(Halfedge start, int k, std::uint32_t closed);

  /// Re-triangulates the patch if an optimal triangulation is shorter for certain; says whether it did.
  bool improve();

  /// The boundary's halfedges, the patch on their left.
  [[nodiscard]] const std::vector<Halfedge>& boundary() const { return boundary_; }
  /// The edges inside, slits excluded.
  [[nodiscard]] const std::vector<MeshEdge>& inner() const { return inner_; }

 private:
  // A place in the cyclic list of the boundary while it grows.
  struct Link {
    Halfedge side;
    std::size_t next;
  };

  [[nodiscard]] bool is_open(Halfedge side, std::uint32_t closed) const;
  [[nodiscard]] Halfedge name_of_triangle(Halfedge side) const;
  void add_triangle(std::size_t link);
  void measure_corners();
  void find_optimum();
  void find_best_apex(std::size_t i, std::size_t j);
  [[nodiscard]] bool is_surely_shorter() const;
  void collect_chords(std::size_t i, std::size_t j, std::vector<Edge>& chords) const;
  void rebuild(std::size_t i, std::size_t j, Halfedge base, std::size_t& used);

  [[nodiscard]] const Point& corner(std::size_t i) const { return mesh_.point(corners_[i]); }
  [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const { return i * corners_.size() + j; }

  PlanarMesh& mesh_;
  std::vector<Link> links_;
  std::vector<Halfedge> triangles_;  // each by its smallest halfedge
  std::vector<MeshEdge> inner_;
  std::vector<Halfedge> boundary_;
  std::vector<Index> corners_;       // origins of boundary_
  std::vector<double> distances_;    // between corners
  std::vector<double> costs_;        // of chord (i, j) and everything beyond it
  std::vector<std::size_t> apexes_;  // the third corner of the triangle on chord (i, j) in the optimum
};

}  // namespace mwt
