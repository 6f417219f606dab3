#include "algorithms/greedy/pockets/distant_ears.h"

#include <algorithm>

#include "algorithms/greedy/pockets/boundary_stretch.h"
#include "geometry/mesh/distance.h"
#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"

namespace mwt {

void DistantEars::begin(std::size_t corners) {
  last_step_ = steps_ + kStepsPerCorner * corners;
  runs_ = 0;
  certain_ = 0;
}

bool DistantEars::is_promising(FaceBoundary& boundary) {
  constexpr std::size_t kSample = 1000;
  const std::size_t step = boundary.size() / kSample + 3;
  std::size_t possible = 0, distant = 0;
  for (std::size_t c = 1; c + 1 < boundary.size(); c += step) {
    if (!boundary.is_possible_ear(static_cast<Corner>(c))) continue;
    ++possible;
    distant += seems_distant(boundary, static_cast<Corner>(c)) ? 1 : 0;
  }
  return 10 * distant > 9 * possible;
}

// Whether no spoke of the corner or of those beside it is as short as its ear.
bool DistantEars::seems_distant(FaceBoundary& boundary, Corner c) {
  stretch_.enter(boundary, c - 1, c + 2);
  const double squared_length =
      rounded_squared_distance(stretch_.point(stretch_.next(c)), stretch_.point(stretch_.previous(c)));
  return stretch_.clearance(c - 1) > squared_length && stretch_.clearance(c) > squared_length &&
         stretch_.clearance(c + 1) > squared_length;
}

bool DistantEars::is_certain(DistantEar& ear) {
  if (!stretch_.is_inside(ear.c) || !stretch_.is_inside(ear.a) || !stretch_.is_inside(ear.b)) return false;
  const Point &a = stretch_.point(ear.a), &b = stretch_.point(ear.b), &c = stretch_.point(ear.c);
  ear.squared_length = rounded_squared_distance(a, b);
  ear.enough = ear.squared_length * (1 + kFloatMargin);
  if (!is_trusted_float(ear.squared_length) || orientation(c, a, b) <= 0) return false;
  const auto next = [this](Corner x) { return stretch_.next(x); };
  const auto previous = [this](Corner x) { return stretch_.previous(x); };
  if (!is_far_along(ear, ear.a, next) || !is_far_along(ear, ear.b, previous)) return false;
  if (dot_sign(a, c, b) > 0 || !is_clear_around(ear)) return false;
  ++certain_;
  return true;
}

// Whether the boundary beyond an end of the ear leaves the circle about c with radius |ab| before it comes into view.
template <typename Step>
bool DistantEars::is_far_along(const DistantEar& ear, Corner end, Step step) {
  for (Corner x = step(end); steps_ < last_step_; ++steps_, x = step(x)) {
    if (precedes(ear, x)) return true;
    if (!stretch_.is_inside(x) || is_in_view(ear, x) || !is_clear(ear, x)) return false;
  }
  return false;
}

bool DistantEars::is_in_view(const DistantEar& ear, Corner x) const {
  const Point &c = stretch_.point(ear.c), &p = stretch_.point(x);
  return orientation(c, stretch_.point(ear.a), p) > 0 && orientation(c, p, stretch_.point(ear.b)) > 0 &&
         stretch_.faces(x, c);
}

// Whether the ear precedes the edge from its apex to another corner. Exact.
bool DistantEars::precedes(const DistantEar& ear, Corner x) const {
  const double squared = rounded_squared_distance(stretch_.point(ear.c), stretch_.point(x));
  if (ear.squared_length * (1 + kSquareMargin) < squared) return true;
  if (ear.squared_length > squared * (1 + kSquareMargin)) return false;
  const FaceBoundary& boundary = stretch_.boundary();
  return order_.precedes(order_.key(boundary.point(ear.a), boundary.point(ear.b)),
                         order_.key(boundary.point(ear.c), boundary.point(x)));
}

// Whether all spokes of x and of the pockets on either side are longer than the ear.
bool DistantEars::is_clear(const DistantEar& ear, Corner x) {
  return stretch_.pocket(x) > ear.enough && stretch_.pocket(stretch_.previous(x)) > ear.enough &&
         stretch_.clearance(x) > ear.enough;
}

// Whether the spokes of the ear's corners, hidden ones included, and of the pockets beside it are harmless.
bool DistantEars::is_clear_around(DistantEar& ear) {
  ear.at_a = stretch_.clearance(ear.a);
  ear.at_b = stretch_.clearance(ear.b);
  ear.hidden = std::min({stretch_.pocket(ear.b), stretch_.pocket(ear.c), stretch_.clearance(ear.c)});
  const float beside = std::min(stretch_.pocket(ear.a), stretch_.pocket(stretch_.previous(ear.b)));
  if (std::min({ear.at_a, ear.at_b, ear.hidden, beside}) > ear.enough) return true;
  return !is_hopeless() && is_clear_along_run(ear);
}

// The same where there are short spokes: which of them stay within the run or end far from c?
bool DistantEars::is_clear_along_run(DistantEar& ear) {
  ++runs_;
  collect_run(ear);
  ear.hidden = BoundaryStretch::kFar;
  for (const RunCorner& x : run_) {
    float least = stretch_.clearance(x.corner);
    if (!leads_only_within(ear, x.corner, least)) return false;
    if (x.corner == ear.a) {
      ear.at_a = least;
    } else if (x.corner == ear.b) {
      ear.at_b = least;
    } else if (x.is_of_ear) {
      ear.hidden = std::min(ear.hidden, least);
    }
  }
  return true;
}

void DistantEars::collect_run(const DistantEar& ear) {
  run_.clear();
  add_to_run(ear.a, stretch_.room(ear.b).before, true);
  const Corner beyond_b = stretch_.previous(ear.b);
  if (stretch_.pocket(ear.a) < BoundaryStretch::kFar) {
    add_to_run(stretch_.room(stretch_.next(ear.a)).before, ear.a, false);
  }
  if (stretch_.pocket(beyond_b) < BoundaryStretch::kFar) add_to_run(stretch_.room(ear.b).before, beyond_b, false);
  std::sort(run_.begin(), run_.end(), [](const RunCorner& x, const RunCorner& y) { return x.point < y.point; });
  steps_ += run_.size();
}

// The corners before the first cut: `from`, the one before it and so on, as far as `back_to`, which is left out.
void DistantEars::add_to_run(Corner from, Corner back_to, bool is_of_ear) {
  for (Corner x = from; x != back_to; x = stretch_.room(x).before) {
    run_.push_back({stretch_.boundary().point(x), x, is_of_ear});
  }
}

// Whether the spokes of one corner of the run are harmless. Sets `least` to the least squared length of one that leaves
// the ear or is longer.
bool DistantEars::leads_only_within(DistantEar& ear, Corner x, float& least) {
  if (least > ear.enough) return true;
  least = BoundaryStretch::kFar;
  const Halfedge last = stretch_.last_side(x);
  for (Halfedge spoke = mesh_.rotate_left(stretch_.first_side(x)); spoke != last; spoke = mesh_.rotate_left(spoke)) {
    ++steps_;
    const float squared_length = mesh_.record(edge_of(spoke)).squared_length;
    if (squared_length <= ear.enough) {
      const Index target = mesh_.target(spoke);
      const RunCorner* end = find_in_run(x, target);
      if (end != nullptr && end->is_of_ear) {
        ear.is_in_mesh |= x == ear.a && end->corner == ear.b;
        continue;
      }
      if (end == nullptr && rounded_squared_distance(stretch_.point(ear.c), mesh_.point(target)) <= ear.enough)
        return false;
    }
    least = std::min(least, squared_length);
  }
  return true;
}

// The corner of the run at which a spoke from x ends, if any.
const DistantEars::RunCorner* DistantEars::find_in_run(Corner x, Index target) const {
  const auto is_before = [](const RunCorner& corner, Index point) { return corner.point < point; };
  auto place = std::lower_bound(run_.begin(), run_.end(), target, is_before);
  for (; place != run_.end() && place->point == target; ++place) {
    if (stretch_.faces(place->corner, stretch_.point(x))) return &*place;
  }
  return nullptr;
}

}  // namespace mwt
