#include "algorithms/greedy/pockets/boundary_stretch.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace mwt {

void BoundaryStretch::enter(FaceBoundary& boundary, Corner first, Corner last) {
  constexpr float kUnknown = -1;
  boundary_ = &boundary;
  first_ = first;
  rooms_.clear();
  for (Corner c = first; c < last; ++c) {
    rooms_.push_back({kUnknown, kFar, kNone, kNone, boundary.previous(c), boundary.next(c), kNone, false});
  }
}

float BoundaryStretch::clearance(Corner c) {
  Room& here = room(c);
  if (here.clearance >= 0) return here.clearance;
  here.clearance = kFar;
  const Halfedge last = last_side(c);
  for (Halfedge spoke = mesh_.rotate_left(first_side(c)); spoke != last; spoke = mesh_.rotate_left(spoke)) {
    here.clearance = std::min(here.clearance, mesh_.record(edge_of(spoke)).squared_length);
  }
  return here.clearance;
}

bool BoundaryStretch::faces(Corner c, const Point& p) const {
  const Point &at = point(c), &from = point(room(c).before), &to = point(room(c).after);
  const bool is_left_of_first = orientation(at, to, p) > 0, is_left_of_last = orientation(from, at, p) > 0;
  const bool is_convex = orientation(from, at, to) > 0;
  return is_convex ? is_left_of_first && is_left_of_last : is_left_of_first || is_left_of_last;
}

void BoundaryStretch::cut(Corner c, float next, float previous, float pocket) {
  Room &here = room(c), &before = room(boundary_->previous(c));
  here.left = before.apex;
  before.apex = c;
  before.pocket = pocket;
  before.clearance = previous;
  room(boundary_->next(c)).clearance = next;
  boundary_->unlink(c);
}

}  // namespace mwt
