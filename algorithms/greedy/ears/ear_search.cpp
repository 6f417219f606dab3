#include "algorithms/greedy/ears/ear_search.h"

#include <algorithm>

#include "algorithms/greedy/greedy_marks.h"
#include "geometry/mesh/distance.h"
#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"

namespace mwt {

bool EarSearch::is_certain(const EarSite& site, std::size_t max_steps) {
  site_ = site;
  last_step_ = steps_ + max_steps;
  gave_up_ = false;
  apex_ = mesh_.point(site.apex);
  a_ = mesh_.point(site.next);
  b_ = mesh_.point(site.previous);
  squared_length_ = rounded_squared_distance(a_, b_);
  if (!is_trusted_product(squared_length_) || !is_convex_and_not_acute()) return false;
  if (std::any_of(site.beyond.begin(), site.beyond.end(), [this](Index v) { return stands_against(v); })) return false;
  return is_certain_among_spokes() && open_at_apex() && search();
}

bool EarSearch::is_convex_and_not_acute() const {
  return dot_sign(a_, apex_, b_) <= 0 && orientation(apex_, a_, b_) > 0;
}

// Most wedges that are no certain ear are found out by this.
bool EarSearch::stands_against(Index v) const {
  return rounded_reach(mesh_.point(v)) != Reach::outside && side_of(mesh_.point(v)) == 0 &&
         exact_reach(v) == Reach::inside;
}

// Whether the points at the spokes lie beyond the ear and outside.
bool EarSearch::is_certain_among_spokes() {
  const Halfedge last = site_.wedge.last;
  for (Halfedge spoke = mesh_.rotate_left(site_.wedge.first); spoke != last; spoke = mesh_.rotate_left(spoke)) {
    ++steps_;
    const Index v = mesh_.target(spoke);
    if (exact_reach(v) == Reach::inside || orientation(a_, b_, mesh_.point(v)) >= 0) return false;
  }
  return true;
}

// Of the triangles at c, all but the first and the last one have both other corners outside.
bool EarSearch::open_at_apex() {
  count_ = 0;
  const Sight a{site_.next, -1, Reach::inside}, b{site_.previous, 1, Reach::inside};
  const auto spoke = [](Index v) { return Sight{v, 0, Reach::outside}; };
  const Halfedge at_a = mesh_.next(site_.wedge.first);
  const Halfedge at_b = mesh_.previous(twin(site_.wedge.last));
  if (at_a == at_b) return open({at_a, a, b}, Reach::inside);
  return open({at_a, a, spoke(mesh_.target(at_a))}, Reach::inside) &&
         open({at_b, spoke(mesh_.origin(at_b)), b}, Reach::inside);
}

bool EarSearch::search() {
  for (; count_ > 0; ++steps_) {
    if (steps_ >= last_step_) return give_up();
    const Window window = windows_[--count_];
    const Halfedge outer = twin(window.inner);
    const Sight third = sight(mesh_.apex(outer));
    if (third.side == 0 && third.reach == Reach::inside) return false;
    // The triangle beyond: outer goes from `to` to `from`, its next one from `from` to the apex.
    if (!open({mesh_.next(outer), window.from, third}, window.to.reach) ||
        !open({mesh_.previous(outer), third, window.to}, window.from.reach)) {
      return false;
    }
  }
  return true;
}

// Remembers the window if something that stands against the ear may be seen through it; false when there are too many.
bool EarSearch::open(const Window& window, Reach third) {
  const bool is_outside = window.from.side != 0 && window.from.side == window.to.side;
  if (is_outside || is_fixed(mesh_, window.inner)) return true;
  // Lemma 4: with the third corner of its triangle inside and these two outside, all beyond the window is outside.
  const bool both_outside = window.from.reach == Reach::outside && window.to.reach == Reach::outside;
  if (both_outside && third == Reach::inside) return true;
  const Point &from = mesh_.point(window.from.point), &to = mesh_.point(window.to.point);
  if (both_outside && is_surely_farther(apex_, from, to, squared_length_)) return true;
  if (count_ == kMaxWindows) return false;
  windows_[count_++] = window;
  return true;
}

bool EarSearch::give_up() {
  gave_up_ = true;
  return false;
}

EarSearch::Sight EarSearch::sight(Index v) const {
  const Point& p = mesh_.point(v);
  const int side = side_of(p);
  return {v, side, side == 0 ? exact_reach(v) : rounded_reach(p)};
}

int EarSearch::side_of(const Point& p) const {
  if (orientation(apex_, a_, p) <= 0) return -1;
  return orientation(apex_, p, b_) <= 0 ? 1 : 0;
}

EarSearch::Reach EarSearch::rounded_reach(const Point& p) const {
  const double squared = rounded_squared_distance(apex_, p);
  if (squared > squared_length_ * (1 + kSquareMargin)) return Reach::outside;
  return squared < squared_length_ * (1 - kSquareMargin) ? Reach::inside : Reach::unclear;
}

EarSearch::Reach EarSearch::exact_reach(Index v) const {
  if (const Reach reach = rounded_reach(mesh_.point(v)); reach != Reach::unclear) return reach;
  const EdgeKey ear = order_.key(site_.next, site_.previous), other = order_.key(site_.apex, v);
  return order_.precedes(ear, other) ? Reach::outside : Reach::inside;
}

}  // namespace mwt
