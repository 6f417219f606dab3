#include "algorithms/greedy/faces/face_boundary.h"

#include <limits>
#include <utility>

#include "algorithms/greedy/greedy_marks.h"
#include "geometry/predicates.h"

namespace mwt {

FaceBoundary::FaceBoundary(const PlanarMesh& mesh, std::span<const MeshEdge> face) : mesh_(mesh) {
  const Cycles cycles = cycles_of(face);
  corners_.reserve(cycles.sides.size());
  for (const Halfedge side : cycles.sides) {
    const auto corner = static_cast<Corner>(corners_.size());
    corners_.push_back({mesh_.origin(side), side, corner - 1, corner + 1});
  }
  Corner first = 0;
  for (const Corner end : cycles.ends) {
    corners_[end - 1].next = first;
    corners_[first].previous = end - 1;
    first = end;
  }
}

// Every fixed halfedge with the face on its left, once or twice.
template <typename Visit>
void FaceBoundary::for_each_side(std::span<const MeshEdge> face, Visit visit) const {
  for (const MeshEdge e : face) {
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      if (const Halfedge right = mesh_.rotate_right(h); is_fixed(mesh_, right)) visit(right);
      const bool is_wedge_of_triangle = is_fixed(mesh_, mesh_.next(h)) && is_fixed(mesh_, mesh_.previous(h));
      if (is_wedge_of_triangle) visit(mesh_.previous(h));
    }
  }
}

Halfedge FaceBoundary::side_after(Halfedge side) const {
  Halfedge h = mesh_.next(side);
  while (!is_fixed(mesh_, h)) h = mesh_.rotate_right(h);
  return h;
}

// First the side after each, in the order of memory, so that no step depends on the one before; then cycle by cycle.
FaceBoundary::Cycles FaceBoundary::cycles_of(std::span<const MeshEdge> face) const {
  constexpr Halfedge kKnown = std::numeric_limits<Halfedge>::max();
  Cycles cycles;
  // As many as a polygon has with so many diagonals; more edges lie around holes. Allocated first: `following` leaves
  // its memory to the corners.
  cycles.sides.reserve(face.size() + 3);
  KeptVector<Halfedge> following(2 * mesh_.edge_count());
  for_each_side(face, [&](Halfedge side) { following[side] = side_after(side); });
  for_each_side(face, [&](Halfedge first) {
    if (following[first] == kKnown) return;
    for (Halfedge side = first; following[side] != kKnown; side = std::exchange(following[side], kKnown)) {
      cycles.sides.push_back(side);
    }
    cycles.ends.push_back(static_cast<Corner>(cycles.sides.size()));
  });
  return cycles;
}

bool FaceBoundary::is_possible_ear(Corner c) const {
  const Point &at = mesh_.point(point(c)), &to = mesh_.point(point(next(c))), &from = mesh_.point(point(previous(c)));
  return orientation(from, at, to) > 0 && dot_sign(from, at, to) <= 0;
}

Corner FaceBoundary::back_from(Corner c, int corners, std::size_t farthest) const {
  Corner back = c;
  for (int i = 0; i < corners && back > 0; ++i) {
    Corner before = back - 1;
    while (before > 0 && is_cut(before)) --before;
    if (c - before > farthest) break;
    back = before;
  }
  return back;
}

Corner FaceBoundary::on_from(Corner c, int corners, std::size_t farthest) const {
  Corner on = c;
  for (int i = 0; i < corners && on < corners_.size(); ++i) {
    Corner after = on + 1;
    while (after < corners_.size() && is_cut(after)) ++after;
    if (after - c > farthest) break;
    on = after;
  }
  return on;
}

void FaceBoundary::unlink(Corner c) {
  const Link removed = corners_[c];
  corners_[removed.previous].next = removed.next;
  corners_[removed.next].previous = removed.previous;
}

}  // namespace mwt
