#include "algorithms/greedy/face_boundary.h"

#include "algorithms/greedy/greedy_marks.h"
#include "geometry/predicates.h"

namespace mwt {

FaceBoundary::FaceBoundary(PlanarMesh& mesh, std::span<const MeshEdge> face) : mesh_(mesh) {
  corners_.reserve(face.size() + 3);  // as many as a polygon has with so many diagonals; more edges lie around holes
  for (const MeshEdge e : face) {
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      walk_from(mesh_.rotate_right(h));
      if (is_fixed(mesh_.next(h))) walk_from(mesh_.previous(h));  // a wedge that is a triangle of the mesh
    }
  }
}

bool FaceBoundary::is_fixed(Halfedge h) const { return (mesh_.marks(edge_of(h)) & kFixedMark) != 0; }

// Adds the cycle through this halfedge, which has the face on its left, unless it is known or not of the boundary.
void FaceBoundary::walk_from(Halfedge first) {
  const auto is_new = [this](Halfedge h) { return (mesh_.marks(edge_of(h)) & kCornerMarks[h & 1]) == 0; };
  if (!is_fixed(first) || !is_new(first)) return;
  const auto start = static_cast<Corner>(corners_.size());
  Halfedge h = first;
  do {
    mesh_.marks(edge_of(h)) |= kCornerMarks[h & 1];
    const auto corner = static_cast<Corner>(corners_.size());
    corners_.push_back({mesh_.origin(h), h, corner - 1, corner + 1});
    h = mesh_.next(h);
    while (!is_fixed(h)) h = mesh_.rotate_right(h);
  } while (h != first);
  corners_.back().next = start;
  corners_[start].previous = static_cast<Corner>(corners_.size()) - 1;
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
