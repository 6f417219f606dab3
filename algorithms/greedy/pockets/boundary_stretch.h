// A stretch of a face's boundary on which ears are cut off before they enter the mesh.
#pragma once

#include <limits>
#include <vector>

#include "algorithms/greedy/faces/face_boundary.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// The corners first .. last - 1 of a boundary. Those that are cut off hide in a *pocket* between two corners that
/// stay. Until the pockets come into the mesh, it is as it was before the first cut, and so are the sides and spokes of
/// all corners: a *spoke* is an edge of the mesh inside the face that ends at a corner, between its sides.
class BoundaryStretch {
 public:
  static constexpr Corner kNone = std::numeric_limits<Corner>::max();
  static constexpr float kFar = std::numeric_limits<float>::infinity();

  struct Room {
    float clearance;  ///< least squared length of a spoke; less than 0 until it is computed
    float pocket;     ///< the least such length for the corners hidden between this one and the next; kFar if none
    Corner apex;      ///< of the longest ear of that pocket; kNone if it is empty
    Corner left;      ///< once cut: the same for the pocket on the side of the previous corner
    Corner before;    ///< the previous corner before the first cut
    Corner after;     ///< the next corner before the first cut
    Halfedge side;    ///< of its ear, from the previous corner to the next; kNone until it is in the mesh
    bool is_waiting;
  };

  explicit BoundaryStretch(const PlanarMesh& mesh) : mesh_(mesh) {}

  /// O(last - first).
  void enter(FaceBoundary& boundary, Corner first, Corner last);

  [[nodiscard]] bool is_inside(Corner c) const { return c - first_ < rooms_.size(); }
  [[nodiscard]] Room& room(Corner c) { return rooms_[c - first_]; }
  [[nodiscard]] const Room& room(Corner c) const { return rooms_[c - first_]; }
  [[nodiscard]] FaceBoundary& boundary() { return *boundary_; }
  [[nodiscard]] const FaceBoundary& boundary() const { return *boundary_; }
  [[nodiscard]] Corner next(Corner c) const { return boundary_->next(c); }
  [[nodiscard]] Corner previous(Corner c) const { return boundary_->previous(c); }
  [[nodiscard]] const Point& point(Corner c) const { return mesh_.point(boundary_->point(c)); }

  /// The first and the last spoke of a corner of the stretch, both sides included, counter-clockwise.
  [[nodiscard]] Halfedge first_side(Corner c) const { return boundary_->side(c); }
  [[nodiscard]] Halfedge last_side(Corner c) const { return twin(boundary_->side(room(c).before)); }

  /// The least squared length of a spoke at c or in the pocket after c, in floats. O(spokes) once, then O(1).
  [[nodiscard]] float clearance(Corner c);
  [[nodiscard]] float pocket(Corner c) const { return is_inside(c) ? room(c).pocket : kFar; }

  /// Whether a point lies between the sides of c, strictly. Exact.
  [[nodiscard]] bool faces(Corner c, const Point& p) const;

  /// Cuts off c between its neighbours, whose clearances change to `next` and `previous`, as that of their pocket does
  /// to `pocket`: edges between the three and what hides there are no longer spokes.
  void cut(Corner c, float next, float previous, float pocket);

 private:
  const PlanarMesh& mesh_;
  FaceBoundary* boundary_ = nullptr;
  Corner first_ = 0;
  KeptVector<Room> rooms_;
};

}  // namespace mwt
