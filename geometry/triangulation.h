// A triangulation as a flat list of triangles, and what follows from it: edges, adjacency, boundary.
#pragma once

#include <array>
#include <compare>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// Corners in counter-clockwise order.
using Triangle = std::array<Index, 3>;

/// An undirected edge, a < b.
struct Edge {
  Index a = 0;
  Index b = 0;

  friend auto operator<=>(const Edge&, const Edge&) = default;
};

[[nodiscard]] inline Edge make_edge(Index a, Index b) { return a < b ? Edge{a, b} : Edge{b, a}; }

/// A triangulation of points 0 .. point_count - 1. The type promises nothing: geometry/checker.h decides validity.
struct Triangulation {
  Index point_count = 0;
  std::vector<Triangle> triangles;
};

/// The three directed edges of a triangle; the i-th is opposite corner i.
[[nodiscard]] inline Edge directed_edge(const Triangle& triangle, int i) {
  return {triangle[static_cast<std::size_t>((i + 1) % 3)], triangle[static_cast<std::size_t>((i + 2) % 3)]};
}

/// Every edge once, sorted by (a, b). O(n) buckets plus sorting within a vertex. Precondition: indices in range.
[[nodiscard]] std::vector<Edge> edges_of(const Triangulation& triangulation);

/// For triangle t and corner i, the triangle across the edge opposite that corner, kNoIndex on the hull.
/// Precondition: each directed edge occurs at most once (any triangulation that the checker accepts). O(n).
[[nodiscard]] std::vector<std::array<Index, 3>> adjacency_of(const Triangulation& triangulation);

/// The same triangles, each rotated to start at its smallest corner, sorted: equal triangulations compare equal.
[[nodiscard]] std::vector<Triangle> canonical_triangles(const Triangulation& triangulation);

}  // namespace mwt
