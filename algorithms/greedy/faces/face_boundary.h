// The boundary of a face between fixed edges, as corners in a row: what certain ears are cut from.
#pragma once

#include <span>

#include "algorithms/greedy/faces/wedge.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// The corners of a face, linked in cycles: one outer cycle, and one around each hole and each loose tree of fixed
/// edges. Along a cycle the face is to the left, so that its numbers run along the boundary at first, and memory does
/// too.
class FaceBoundary {
 public:
  /// `face`: all edges inside the face, none of them fixed. O(length of `face`) time, 16 bytes per corner, and on the
  /// way at most 4 per halfedge of the mesh.
  FaceBoundary(const PlanarMesh& mesh, std::span<const MeshEdge> face);

  [[nodiscard]] std::size_t size() const { return corners_.size(); }

  /// Whether the corner is convex and not acute, so that it may be cut off.
  [[nodiscard]] bool is_possible_ear(Corner c) const;

  [[nodiscard]] Corner next(Corner c) const { return corners_[c].next; }
  [[nodiscard]] Corner previous(Corner c) const { return corners_[c].previous; }
  [[nodiscard]] Index point(Corner c) const { return corners_[c].point; }

  /// The corner that is so many corners before this one or after it, those that are cut not counted, or the last on the
  /// way whose number is less (greater) by at most `farthest`.
  [[nodiscard]] Corner back_from(Corner c, int corners, std::size_t farthest) const;
  [[nodiscard]] Corner on_from(Corner c, int corners, std::size_t farthest) const;

  /// The edge to the next corner.
  [[nodiscard]] Halfedge side(Corner c) const { return corners_[c].first; }

  /// Between the edge to the next corner and the one to the corner before.
  [[nodiscard]] Wedge wedge(Corner c) const { return {corners_[c].first, twin(corners_[previous(c)].first)}; }

  /// Takes the corner off: `side` goes from the corner before it to the one after.
  /// Its own links stay.
  void cut(Corner c, Halfedge side) {
    unlink(c);
    set_side(previous(c), side);
  }

  /// The same in two steps. In between the corner before has the side that it had.
  void unlink(Corner c);
  void set_side(Corner c, Halfedge side) { corners_[c].first = side; }

  [[nodiscard]] bool is_cut(Corner c) const { return corners_[corners_[c].next].previous != c; }

  /// Whether the corner's cycle has three corners: a triangle that is done, or full of points, or a hole.
  [[nodiscard]] bool is_of_triangle(Corner c) const { return next(next(c)) == previous(c); }

 private:
  struct Link {
    Index point;
    Halfedge first;  // to the next corner
    Corner previous;
    Corner next;
  };

  struct Cycles {
    KeptVector<Halfedge> sides;  // one cycle after the other
    KeptVector<Corner> ends;     // how many sides come up to the end of each
  };

  template <typename Visit>
  void for_each_side(std::span<const MeshEdge> face, Visit visit) const;
  [[nodiscard]] Halfedge side_after(Halfedge side) const;
  [[nodiscard]] Cycles cycles_of(std::span<const MeshEdge> face) const;

  const PlanarMesh& mesh_;
  KeptVector<Link> corners_;
};

}  // namespace mwt
