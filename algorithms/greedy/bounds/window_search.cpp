#include "algorithms/greedy/bounds/window_search.h"

#include "geometry/mesh/distance.h"
#include "geometry/mesh/margins.h"
#include "geometry/predicates.h"

namespace mwt {

bool WindowSearch::shows_nothing_near(Halfedge window, double squared, std::size_t max_steps) {
  squared_ = squared;
  c_ = mesh_.point(mesh_.apex(window));
  from_ = mesh_.point(mesh_.origin(window));
  to_ = mesh_.point(mesh_.target(window));
  count_ = 0;
  const std::size_t last_step = steps_ + max_steps;
  if (!open(window)) return false;
  while (count_ > 0) {
    if (++steps_ > last_step) return false;
    const Halfedge outer = twin(windows_[--count_]);
    const Index third = mesh_.apex(outer);
    if (side_of(third) == 0 && squared_distance(third) <= squared_ * (1 + kSquareMargin)) return false;
    if (!open(mesh_.next(outer)) || !open(mesh_.previous(outer))) return false;
  }
  return true;
}

// Remembers the window if something near may be seen through it; false when there are too many.
bool WindowSearch::open(Halfedge window) {
  if (is_fixed(mesh_, window)) return true;
  const Index from = mesh_.origin(window), to = mesh_.target(window);
  const int side = side_of(from);
  if (side != 0 && side == side_of(to)) return true;
  const double nearest = squared_ * (1 + kSquareMargin);
  if (squared_distance(from) > nearest && squared_distance(to) > nearest) {
    // Lemma 4: with the third corner of its triangle inside and these two outside, all beyond the window is outside.
    if (squared_distance(mesh_.apex(window)) < squared_ * (1 - kSquareMargin)) return true;
    if (is_surely_farther(c_, mesh_.point(from), mesh_.point(to), squared_)) return true;
  }
  if (count_ == kMaxWindows) return false;
  windows_[count_++] = window;
  return true;
}

// As seen from c: 0 strictly between the ends of the first window, -1 on or beyond its origin, +1 its target.
int WindowSearch::side_of(Index v) const {
  const Point& p = mesh_.point(v);
  if (orientation(c_, from_, p) <= 0) return -1;
  return orientation(c_, p, to_) <= 0 ? 1 : 0;
}

double WindowSearch::squared_distance(Index v) const { return rounded_squared_distance(c_, mesh_.point(v)); }

}  // namespace mwt
