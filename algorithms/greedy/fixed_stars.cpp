#include "algorithms/greedy/fixed_stars.h"

#include "geometry/predicates.h"

namespace mwt {

namespace {

// Counter-clockwise about a centre, from the direction of the positive x-axis, included.
bool turns_before(const Point& centre, const Point& p, const Point& q) {
  const auto in_upper_half = [&](const Point& a) { return a.y > centre.y || (a.y == centre.y && a.x > centre.x); };
  const bool p_upper = in_upper_half(p), q_upper = in_upper_half(q);
  if (p_upper != q_upper) return p_upper;
  return orientation(centre, p, q) > 0;
}

}  // namespace

FixedStars::Star& FixedStars::star_of(Halfedge h) {
  const Index centre = mesh_.origin(h);
  if (const auto star = stars_.find(centre); star != stars_.end()) return star->second;
  const auto by_direction = [this, centre](Halfedge a, Halfedge b) {
    return turns_before(mesh_.point(centre), mesh_.point(mesh_.target(a)), mesh_.point(mesh_.target(b)));
  };
  Star& star = stars_.emplace(centre, Star(by_direction)).first->second;
  Halfedge spoke = h;
  do {
    if (is_fixed(spoke)) star.insert(spoke);
    spoke = mesh_.rotate_left(spoke);
  } while (spoke != h);
  return star;
}

Halfedge FixedStars::left_in_set(Halfedge h) {
  const Star& star = star_of(h);
  const auto next = star.upper_bound(h);
  return next == star.end() ? *star.begin() : *next;
}

Halfedge FixedStars::right_in_set(Halfedge h) {
  const Star& star = star_of(h);
  const auto at = star.lower_bound(h);
  return at == star.begin() ? *star.rbegin() : *std::prev(at);
}

}  // namespace mwt
