// A triangulation that can be changed: the structure under all local methods (greedy, flips, patches, annealing).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/mesh/kept_memory.h"
#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// Half of a mesh edge: 2 * edge + side. It goes from its origin along the face on its left.
using Halfedge = std::uint32_t;
/// Position of a mesh edge, the same for both of its halves. It names a place in the mesh, not a pair of points: a flip
/// changes the points of one edge and the place of none.
using MeshEdge = std::uint32_t;

[[nodiscard]] constexpr Halfedge twin(Halfedge h) { return h ^ 1; }
[[nodiscard]] constexpr MeshEdge edge_of(Halfedge h) { return h >> 1; }

/// Everything about one edge, in half a cache line.
struct alignas(32) EdgeRecord {
  std::array<Index, 2> origins;
  std::array<Halfedge, 2> next;      ///< the following halfedge of the same face
  std::array<Halfedge, 2> previous;  ///< the one before
  float squared_length;              ///< rounded; may be 0 or infinite for extreme coordinates
  std::uint32_t marks;               ///< bits: kHullMark, kLastingMarks, others free for the algorithm at work
};

inline constexpr std::uint32_t kHullMark = 1;
/// Marks that outlive an algorithm, such as beta-skeleton edges: no algorithm uses these bits for its own purposes.
inline constexpr std::uint32_t kLastingMarks = 0xFFFF0000;

/// A triangulation of the convex hull of its points, with links from each halfedge to its neighbours.
///
/// Points are renumbered along a space-filling curve and edges along the points, so that what is near in the plane is
/// near in memory; label() leads back to the caller's numbers. The outer face is linked like a triangle's, clockwise
/// around the hull, so that rotating about a vertex needs no special case; its edges carry kHullMark.
/// Coordinates of extreme size are divided by a power of two (geometry/numbers/scaling.h): unit() leads back.
///
/// Properties, kept by every member:
///   (1) faces left of halfedges are counter-clockwise triangles, except the outer one;
///   (2) next and previous are inverse to each other and stay within one face;
///   (3) squared_length belongs to the edge's present ends.
/// 96 bytes per point for the edges, 20 for points and labels.
class PlanarMesh {
 public:
  /// The Delaunay triangulation. Preconditions: as delaunay_triangles(). Expected O(n log n).
  [[nodiscard]] static PlanarMesh delaunay(Points points);

  /// A given triangulation of `points` that the checker accepts. O(n).
  PlanarMesh(Points points, const Triangulation& triangulation);

  [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }
  [[nodiscard]] std::size_t point_count() const { return points_.size(); }
  [[nodiscard]] const EdgeRecord& record(MeshEdge e) const { return edges_[e]; }
  [[nodiscard]] std::uint32_t& marks(MeshEdge e) { return edges_[e].marks; }
  [[nodiscard]] std::uint32_t marks(MeshEdge e) const { return edges_[e].marks; }
  [[nodiscard]] bool is_hull(MeshEdge e) const { return (edges_[e].marks & kHullMark) != 0; }

  [[nodiscard]] Index origin(Halfedge h) const { return edges_[h >> 1].origins[h & 1]; }
  [[nodiscard]] Index target(Halfedge h) const { return edges_[h >> 1].origins[(h & 1) ^ 1]; }
  [[nodiscard]] Halfedge next(Halfedge h) const { return edges_[h >> 1].next[h & 1]; }
  [[nodiscard]] Halfedge previous(Halfedge h) const { return edges_[h >> 1].previous[h & 1]; }
  /// The corner opposite h in the triangle on its left.
  [[nodiscard]] Index apex(Halfedge h) const { return origin(previous(h)); }
  /// The next halfedge with the same origin, counter-clockwise and clockwise.
  [[nodiscard]] Halfedge rotate_left(Halfedge h) const { return twin(previous(h)); }
  [[nodiscard]] Halfedge rotate_right(Halfedge h) const { return next(twin(h)); }

  /// The points in the mesh's numbering and the caller's number of each.
  [[nodiscard]] const Point& point(Index v) const { return points_[v]; }
  [[nodiscard]] Index label(Index v) const { return labels_[v]; }
  [[nodiscard]] Points points() const { return points_; }
  [[nodiscard]] std::span<const Index> labels() const { return labels_; }
  /// The length in the caller's coordinates of what has length 1 in the mesh: 1 except for extreme coordinates.
  [[nodiscard]] double unit() const { return unit_; }
  [[nodiscard]] Edge labelled_edge(MeshEdge e) const;

  /// Replaces e by the other diagonal of the quadrilateral formed by its two triangles, turning it counter-clockwise,
  /// and clears its marks: it is another edge now. Precondition: not a hull edge, the quadrilateral is strictly convex.
  void flip(MeshEdge e);

  /// Whether the two triangles at e form a strictly convex quadrilateral. Exact. Precondition: not a hull edge.
  [[nodiscard]] bool is_flippable(MeshEdge e) const;

  /// For rebuilding a region: makes e an edge between these points, without marks, and a face of three halfedges.
  void set_edge(MeshEdge e, Index from, Index to);
  void link_triangle(Halfedge a, Halfedge b, Halfedge c);

  /// Clears these marks on all edges.
  void clear_marks(std::uint32_t marks);

  /// The triangles, in the caller's numbers. O(n).
  [[nodiscard]] Triangulation triangulation() const;

  /// Asks the processor to have the edge's record ready soon. No effect on results.
  void prefetch(MeshEdge e) const { __builtin_prefetch(&edges_[e]); }
  void prefetch_point(Index v) const { __builtin_prefetch(&points_[v]); }

 private:
  friend class MeshBuilder;
  PlanarMesh() = default;

  KeptVector<Point> points_;
  std::vector<Index> labels_;
  KeptVector<EdgeRecord> edges_;
  double unit_ = 1;
};

}  // namespace mwt
