// A triangulation that can be flipped: flat arrays of half-edges, in which an edge keeps its number for life.
#pragma once

#include <array>
#include <vector>

#include "geometry/predicates.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The edges of a triangulation, numbered 0 .. edge_count() - 1, and the triangles left and right of each.
///
/// Edge e consists of the half-edges 2e and 2e + 1, of which each has its triangle on its left. A flip changes the ends
/// of that edge and nothing about the ends of others, so loops over edge numbers and tables by edge number survive
/// flips. 16 bytes per edge beyond the triangulation itself. Copyable.
class FlipTriangulation {
 public:
  /// Edges are numbered in the order of their first triangle in the list. Precondition: a valid triangulation
  /// (geometry/checker.h). O(n).
  explicit FlipTriangulation(const Triangulation& triangulation);

  [[nodiscard]] Index edge_count() const { return static_cast<Index>(origin_.size() / 2); }

  [[nodiscard]] Edge edge(Index e) const { return make_edge(origin_[2 * e], origin_[2 * e + 1]); }

  /// Whether e is an edge of the hull, with a triangle on one side only.
  [[nodiscard]] bool is_boundary(Index e) const { return next_[2 * e] == kNoIndex || next_[2 * e + 1] == kNoIndex; }

  /// The ends a, b of an edge and the third corners of its triangles: c left of a -> b and d right of it.
  struct Quadrilateral {
    Index a, b, c, d;
  };

  /// Precondition: not a boundary edge.
  [[nodiscard]] Quadrilateral quadrilateral(Index e) const {
    const Index h = 2 * e, twin = h + 1;
    return {origin_[h], origin_[twin], origin_[next_[next_[h]]], origin_[next_[next_[twin]]]};
  }

  /// The numbers of the quadrilateral's sides: bc, ca, ad, db. Precondition: not a boundary edge.
  [[nodiscard]] std::array<Index, 4> sides(Index e) const {
    const Index bc = next_[2 * e], ad = next_[2 * e + 1];
    return {bc / 2, next_[bc] / 2, ad / 2, next_[ad] / 2};
  }

  /// Replaces diagonal ab of the quadrilateral by dc. Precondition: the quadrilateral is strictly convex.
  void flip(Index e);

  /// The triangles, each listed with its half-edge of smallest number first, in the order of these numbers. O(n).
  [[nodiscard]] Triangulation triangulation() const;

 private:
  Index point_count_ = 0;
  std::vector<Index> origin_;  // of half-edge h; its other end is origin_[h ^ 1]
  std::vector<Index> next_;    // counter-clockwise around the triangle left of h; kNoIndex outside the hull
};

/// Whether e can be flipped: it is no boundary edge and its quadrilateral is strictly convex.
[[nodiscard]] inline bool is_flippable(Points points, const FlipTriangulation& triangulation, Index e) {
  if (triangulation.is_boundary(e)) return false;
  const auto [a, b, c, d] = triangulation.quadrilateral(e);
  // The two triangles turn left at c and d already; what is open are the angles at a and b.
  return orientation(points[d], points[b], points[c]) > 0 && orientation(points[c], points[a], points[d]) > 0;
}

}  // namespace mwt
