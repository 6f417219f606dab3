#include "algorithms/greedy/face_boundary.h"

#include <bit>

#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/mesh/radix_sort.h"

namespace mwt {

FaceBoundary::FaceBoundary(PlanarMesh& mesh, std::span<const MeshEdge> face) : mesh_(mesh) {
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

std::vector<Corner> FaceBoundary::in_order_of_points() const {
  HugeVector<std::uint64_t> keys, buffer;
  keys.reserve(corners_.size());
  for (Corner c = 0; c < corners_.size(); ++c) keys.push_back((std::uint64_t{corners_[c].point} << 32) | c);
  radix_sort(keys, 32, 32 + static_cast<int>(std::bit_width(mesh_.point_count())), buffer);
  return std::vector<Corner>(keys.begin(), keys.end());
}

void FaceBoundary::cut(Corner c, Halfedge side) {
  const Link removed = corners_[c];
  corners_[removed.previous].first = side;
  corners_[removed.previous].next = removed.next;
  corners_[removed.next].previous = removed.previous;
}

}  // namespace mwt
