// The weakly simple polygon around a few triangles of a mesh, and its optimal triangulation.
#pragma once

#include <vector>

#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// One patch after the other: grow, then improve. Keeps its arrays.
class PatchPolygon {
 public:
  /// Of at most `max_k` triangles.
  PatchPolygon(PlanarMesh& mesh, int max_k);

  /// Takes up to k triangles by breadth-first search in the dual from the one left of `start`, never across hull edges
  /// nor edges with one of the marks `closed`.
  void grow(Halfedge start, int k, std::uint32_t closed);

  /// Re-triangulates the patch if an optimal triangulation is shorter for certain; returns whether it did.
  bool improve();

  /// Whether nothing is open to grow further: all around are hull and closed edges.
  [[nodiscard]] bool is_enclosed() const { return is_enclosed_; }

  /// The triangles that were taken, each by its smallest halfedge at that time.
  [[nodiscard]] const std::vector<Halfedge>& triangles() const { return triangles_; }
  /// The boundary's halfedges, the patch on their left.
  [[nodiscard]] const std::vector<Halfedge>& boundary() const { return boundary_; }
  /// The edges inside, slits excluded.
  [[nodiscard]] const std::vector<MeshEdge>& inner() const { return inner_; }
  /// The ends of inner() before the last improve(), in the mesh's numbering.
  [[nodiscard]] const std::vector<Edge>& present() const { return present_; }

 private:
  // A place in the cyclic list of the boundary while it grows.
  struct Link {
    Halfedge side;
    std::size_t next;
  };

  [[nodiscard]] bool is_open(Halfedge side, std::uint32_t closed) const;
  [[nodiscard]] Halfedge name_of_triangle(Halfedge side) const;
  void add_triangle(std::size_t link);
  void collect_boundary();
  void find_optimum();
  void find_best_apex(std::size_t i, std::size_t j);
  [[nodiscard]] bool is_surely_shorter();
  void collect_chords(std::size_t i, std::size_t j, std::vector<Edge>& chords) const;
  void rebuild(std::size_t i, std::size_t j, Halfedge base, std::size_t& used);

  [[nodiscard]] std::size_t at(std::size_t i, std::size_t j) const { return i * row_length_ + j; }

  PlanarMesh& mesh_;
  std::size_t row_length_;  // of the square tables below
  bool is_enclosed_ = false;
  std::vector<Link> links_;
  std::vector<Halfedge> triangles_;
  std::vector<MeshEdge> inner_;
  std::vector<Halfedge> boundary_;
  std::vector<Edge> present_;        // inner_ by its ends, in the mesh's numbering
  std::vector<Edge> chords_;         // the optimum's
  std::vector<Index> corners_;       // origins of boundary_
  std::vector<Point> places_;        // of the corners
  std::vector<double> costs_;        // of chord (i, j) and everything beyond it; symmetric, for reading along rows
  std::vector<std::size_t> apexes_;  // the third corner of the triangle on chord (i, j) in the optimum
};

}  // namespace mwt
