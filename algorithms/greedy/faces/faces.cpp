#include "algorithms/greedy/faces/faces.h"

#include <algorithm>

#include "algorithms/greedy/bounds/crossing_bounds.h"
#include "algorithms/greedy/ears/certain_ears.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/greedy_marks.h"

namespace mwt {

bool Faces::reduce_face(MeshEdge e) {
  collect(e);
  const std::uint32_t tried = mesh_.marks(e);
  if (edges_.size() <= large_face_ || (tried & kEarsTakenMark) != 0) return false;
  if ((tried & kDividedMark) == 0 && are_bounds_promising()) {
    fix_uncrossed();
  } else {
    take_certain_ears();
  }
  return true;
}

// All edges that can be reached from e through triangles without crossing a fixed edge.
void Faces::collect(MeshEdge e) {
  edges_.assign(1, e);
  mesh_.marks(e) = (mesh_.marks(e) & ~kFlippedMark) | kFaceMark;
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    for (const Halfedge h : {2 * edges_[i], 2 * edges_[i] + 1}) {
      for (const Halfedge side : {mesh_.next(h), mesh_.previous(h)}) {
        std::uint32_t& marks = mesh_.marks(edge_of(side));
        if ((marks & (kFixedMark | kFaceMark)) != 0) continue;
        marks = (marks & ~kFlippedMark) | kFaceMark;
        edges_.push_back(edge_of(side));
      }
    }
  }
}

bool Faces::are_bounds_promising() const { return CrossingBounds(mesh_).is_promising(edges_); }

// Fixes those edges that nothing can cross.
void Faces::fix_uncrossed() {
  sort();
  CrossingBounds bounds(mesh_);
  const bool found = bounds.find(edges_);
  for (const MeshEdge e : edges_) {
    if (found && bounds.is_certain(e)) parts_.stars.fix(e);
  }
  leave(kDividedMark);
}

void Faces::take_certain_ears() {
  sort();
  CertainEars ears(parts_);
  stopped_ = !ears.take(edges_);
  inserted_ears_ += ears.inserted();
  leave(kEarsTakenMark);
}

// The face is to be collected again.
void Faces::leave(std::uint32_t tried) {
  for (const MeshEdge e : edges_) mesh_.marks(e) = (mesh_.marks(e) & ~kFaceMark) | tried;
}

// Into the order of memory. All faces before this one are done: their edges are fixed.
void Faces::sort() {
  if (std::is_sorted(edges_.begin(), edges_.end())) return;
  const bool is_small = 16 * edges_.size() < mesh_.edge_count();
  if (is_small) return std::sort(edges_.begin(), edges_.end());
  edges_.clear();
  for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
    if (is_inside_face(mesh_, e)) edges_.push_back(e);
  }
}

}  // namespace mwt
