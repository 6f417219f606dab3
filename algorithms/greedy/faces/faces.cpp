#include "algorithms/greedy/faces/faces.h"

#include <algorithm>

#include "algorithms/greedy/greedy_marks.h"

namespace mwt {

bool Faces::reduce_all() {
  while (!stopped_ && are_large()) {
    collect_all();
    if (!reduce(mesh_.marks(edges_.front()))) return true;
  }
  return false;
}

bool Faces::reduce_face(MeshEdge e) {
  collect(e);
  return edges_.size() > large_face_ && reduce(mesh_.marks(e));
}

// A guess, from samples.
bool Faces::are_large() {
  if (mesh_.edge_count() <= large_face_) return false;
  constexpr std::size_t kSamples = 16, kMany = 1000;  // whether there are more yet would take long to find out
  const std::size_t many = std::min(large_face_, kMany);
  const std::size_t distance = mesh_.edge_count() / kSamples + 1;
  std::size_t inside = 0, in_large = 0;
  for (std::size_t e = distance / 2; e < mesh_.edge_count(); e += distance) {
    if (is_fixed_edge(mesh_, static_cast<MeshEdge>(e))) continue;
    collect(static_cast<MeshEdge>(e), many + 1);
    ++inside;
    in_large += edges_.size() > many ? 1 : 0;
    leave(0);
  }
  return inside >= kSamples / 4 && in_large == inside;
}

void Faces::collect_all() {
  edges_.clear();
  for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
    if (is_fixed_edge(mesh_, e)) continue;
    std::uint32_t& marks = mesh_.marks(e);
    marks = (marks & ~kFlippedMark) | kFaceMark;
    edges_.push_back(e);
  }
}

// Leaves less of large faces to be done in the order of length, by the next promising means that was not tried yet.
// False if there is none; otherwise the faces are to be collected again.
bool Faces::reduce(std::uint32_t tried) {
  if ((tried & (kDividedMark | kEarsTakenMark)) == 0 && crossing_bounds_.is_promising(edges_)) {
    divide();
  } else if ((tried & kEarsTakenMark) == 0) {
    take_certain_ears();
  } else if ((tried & kCutMark) == 0 && cuts_.is_promising(edges_)) {
    cut();
  } else {
    return false;
  }
  return true;
}

// Fixes those edges that nothing can cross.
void Faces::divide() {
  sort();
  const bool found = crossing_bounds_.find(edges_);
  for (const MeshEdge e : edges_) {
    if (found && crossing_bounds_.is_certain(e)) stars_.fix(e);
  }
  crossing_bounds_.forget();
  leave(kDividedMark);
}

void Faces::take_certain_ears() {
  sort();
  stopped_ = !certain_ears_.take(edges_);
  leave(kEarsTakenMark);
}

// Fixes the shortest ways between boundaries.
void Faces::cut() {
  for (const MeshEdge e : cuts_.find(edges_)) stars_.fix(e);
  leave(kCutMark);
}

void Faces::leave(std::uint32_t tried) {
  for (const MeshEdge e : edges_) mesh_.marks(e) = (mesh_.marks(e) & ~kFaceMark) | tried;
}

// All edges that can be reached from e through triangles without crossing a fixed edge; or `most` of them and few more.
void Faces::collect(MeshEdge e, std::size_t most) {
  edges_.assign(1, e);
  mesh_.marks(e) = (mesh_.marks(e) & ~kFlippedMark) | kFaceMark;
  for (std::size_t i = 0; i < edges_.size() && edges_.size() < most; ++i) {
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
