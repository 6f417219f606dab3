#include "algorithms/greedy/ears/ear_insertion.h"

#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/greedy_marks.h"
#include "geometry/mesh/in_circle.h"
#include "geometry/predicates.h"

namespace mwt {

MeshEdge EarInsertion::insert(const Wedge& wedge) {
  begin();
  const MeshEdge inserted = flip_out(wedge);
  restore_delaunay();
  return inserted;
}

void EarInsertion::begin() {
  inner_.clear();
  unblocked_.clear();
}

// Nearest spokes first in the sense of Graham's scan; the last one to go becomes the third side.
MeshEdge EarInsertion::flip_out(const Wedge& wedge) {
  spokes_.assign(1, wedge.first);
  MeshEdge last_flipped = 0;
  Halfedge spoke = mesh_.rotate_left(wedge.first);
  while (true) {
    const Point& to = mesh_.point(mesh_.target(spoke));
    while (spokes_.size() > 1) {
      const Point& from = mesh_.point(mesh_.target(spokes_[spokes_.size() - 2]));
      if (orientation(from, to, mesh_.point(mesh_.target(spokes_.back()))) >= 0) break;
      last_flipped = edge_of(spokes_.back());
      spokes_.pop_back();
      flip(last_flipped);
      inner_.push_back(last_flipped);
    }
    if (spoke == wedge.last) break;
    spokes_.push_back(spoke);
    spoke = mesh_.rotate_left(spoke);
  }
  inner_.pop_back();
  return last_flipped;
}

// Lawson's flips on the edges in inner_, which are all that insertion can have disturbed.
void EarInsertion::restore_delaunay() {
  std::erase_if(inner_, [this](MeshEdge e) { return is_fixed_edge(mesh_, e); });
  if (inner_.empty()) return;
  for (const MeshEdge e : inner_) mesh_.marks(e) |= kInnerMark;
  suspects_ = inner_;
  while (!suspects_.empty()) {
    const MeshEdge e = suspects_.back();
    suspects_.pop_back();
    const Halfedge h = 2 * e;
    const Point& p = mesh_.point(mesh_.apex(h + 1));
    if (fast_in_circle(mesh_.point(mesh_.origin(h)), mesh_.point(mesh_.target(h)), mesh_.point(mesh_.apex(h)), p) <=
        0) {
      continue;
    }
    flip(e);
    for (const Halfedge side : {mesh_.next(h), mesh_.previous(h), mesh_.next(h + 1), mesh_.previous(h + 1)}) {
      if ((mesh_.marks(edge_of(side)) & kInnerMark) != 0) suspects_.push_back(edge_of(side));
    }
  }
  for (const MeshEdge e : inner_) mesh_.marks(e) &= ~kInnerMark;
}

void EarInsertion::flip(MeshEdge e) {
  for (const Halfedge h : {2 * e, 2 * e + 1}) {
    if ((mesh_.marks(e) & kWatchedMarks[h & 1]) != 0) unblocked_.push_back(stars_.right_of(h));
  }
  const std::uint32_t lasting = mesh_.marks(e) & (kFaceMark | kInnerMark | kDividedMark | kEarsTakenMark);
  mesh_.flip(e);
  mesh_.marks(e) = lasting | kFlippedMark;
  ++flips_;
}

}  // namespace mwt
