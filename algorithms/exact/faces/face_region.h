// Faces in general: with holes, isolated vertices, or without enough time to solve them.
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/exact/faces/face_walk.h"
#include "geometry/triangulation.h"
#include "geometry/weight.h"

namespace mwt {

/// A face as sets of edges. Unlike polygons, regions may have several boundary components.
struct FaceRegion {
  std::vector<Index> vertices;   ///< ascending
  std::vector<Edge> boundary;    ///< directed, the face on the left; slits and inner trees in both directions
  std::vector<Edge> candidates;  ///< inside the face, a < b, ascending
  std::size_t components = 0;    ///< of the boundary, every isolated vertex being one

  /// The position of one of the vertices in `vertices`.
  [[nodiscard]] Index place_of(Index vertex) const;

  /// The same edges by the positions of their ends, in their order and direction.
  [[nodiscard]] std::vector<Edge> in_places(const std::vector<Edge>& edges) const;

  /// The vertices' points, in their order.
  [[nodiscard]] std::vector<Point> points_among(Points points) const;

  /// By Euler's formula, of every triangulation of the face.
  [[nodiscard]] std::size_t triangle_count() const { return boundary.size() + 2 * components - 4; }
  [[nodiscard]] std::size_t diagonal_count() const { return (3 * triangle_count() - boundary.size()) / 2; }
};

/// The region of the face with these boundary walks and isolated vertices.
[[nodiscard]] FaceRegion make_region(const CandidateGraph& graph, const std::vector<const Walk*>& walks,
                                     const std::vector<Index>& isolated);

/// Groups walks and isolated vertices (ascending) by the faces they lie in: two belong together if a candidate joins
/// them. No geometry is needed, because some triangulation by candidates joins everything within a face and nothing
/// across faces. Regions are ordered by their first walk. Precondition: the walks of a face are all given, or none is.
[[nodiscard]] std::vector<FaceRegion> group_into_regions(const CandidateGraph& graph, const FaceWalker& walker,
                                                         const std::vector<Walk>& walks,
                                                         const std::vector<Index>& isolated);

/// Some triangulation of the region (constrained Delaunay), by candidates or not. O(m log m).
[[nodiscard]] std::vector<Triangle> fill_region(Points points, const FaceRegion& region);

/// The total length of the triangles' sides that are not the region's boundary, each once.
[[nodiscard]] LengthSum diagonals_length(Points points, const FaceRegion& region,
                                         const std::vector<Triangle>& triangles);

/// The total length of the `count` shortest of these edges, all of them if they are fewer. O(edges).
[[nodiscard]] Interval shortest_edges_length(Points points, std::vector<Edge> edges, std::size_t count);

/// A lower bound on the total length of the diagonals of any triangulation of the region by candidates: that of as many
/// of the shortest candidates as there must be diagonals.
[[nodiscard]] double lower_bound_of_diagonals(Points points, const FaceRegion& region);

}  // namespace mwt
