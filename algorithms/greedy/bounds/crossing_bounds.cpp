#include "algorithms/greedy/bounds/crossing_bounds.h"

#include <algorithm>
#include <cmath>

#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr std::size_t kLargeStar = 64;

template <class Vector>
double dot(const Vector& p, const Vector& q) {
  return p.x * q.x + p.y * q.y;
}

template <class Vector>
double cross(const Vector& p, const Vector& q) {
  return p.x * q.y - p.y * q.x;
}

// Each bound's error is smaller than this margin, also where the products underflow.
template <class Vector>
double error(const Vector& p, const Vector& q) {
  return kProductMargin * (p.squared_length + q.squared_length) + kMinTrustedProduct;
}

// Of the angle counter-clockwise from p to q, below a full turn. In doubt no.
template <class Vector>
bool is_acute(const Vector& p, const Vector& q) {
  return dot(p, q) > error(p, q) && cross(p, q) > error(p, q);
}
template <class Vector>
bool is_reflex(const Vector& p, const Vector& q) {
  return cross(p, q) < -error(p, q);
}

}  // namespace

bool CrossingBounds::is_promising(std::span<const MeshEdge> face) {
  constexpr std::size_t kSamples = 1000;
  std::size_t samples = 0, certain = 0;
  for (std::size_t i = 0; i < face.size(); i += face.size() / kSamples + 1) {
    ++samples;
    certain += seems_certain(face[i]) ? 1 : 0;
  }
  return 4 * certain >= 3 * samples;
}

// Whether no pair of spokes at either end rules e out; spokes of a large star are not examined.
bool CrossingBounds::seems_certain(MeshEdge e) {
  for (const Halfedge h : {2 * e, 2 * e + 1}) {
    std::size_t degree = 1;
    for (Halfedge s = mesh_.rotate_left(h); s != h && degree <= kLargeStar; s = mesh_.rotate_left(s)) ++degree;
    if (degree > kLargeStar) return false;
    collect_wedge(first_of_wedge(h));
    judge_wedge();
    const auto stands_against = [h](const Spoke& s) { return s.halfedge == h && s.bound != kInfinite; };
    if (std::any_of(spokes_.begin(), spokes_.end(), stands_against)) return false;
  }
  return true;
}

bool CrossingBounds::find(std::span<const MeshEdge> face, std::size_t max_steps_per_edge) {
  bounds_ = std::make_unique_for_overwrite<float[]>(mesh_.edge_count());
  is_judged_.resize(mesh_.point_count());
  for (const MeshEdge e : face) {
    bounds_[e] = kNeverCrossed;
    for (const Halfedge h : {2 * e, 2 * e + 1}) is_judged_[mesh_.origin(h)] = false;
  }
  for (const MeshEdge e : face) {
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      if (!is_judged_[mesh_.origin(h)]) judge_star(h);
    }
  }
  const bool found = spread(max_steps_per_edge * face.size());
  forget_lowered();
  return found;
}

void CrossingBounds::forget_lowered() {
  for (const MeshEdge e : lowered_) mesh_.marks(e) &= ~kLoweredMark;
  lowered_.clear();
}

CrossingBounds::Spoke CrossingBounds::spoke(Halfedge h, Turn turn) const {
  Spoke result = spoke_to(mesh_.origin(h), mesh_.target(h), turn);
  result.halfedge = h;
  return result;
}

CrossingBounds::Spoke CrossingBounds::spoke_to(Index apex, Index v, Turn turn) const {
  const Point &c = mesh_.point(apex), &p = mesh_.point(v);
  const double x = p.x - c.x, y = turn == Turn::left ? p.y - c.y : c.y - p.y;
  return {0, x, y, x * x + y * y, kInfinite};
}

// The nearest fixed halfedge clockwise from h; h if there is none.
Halfedge CrossingBounds::first_of_wedge(Halfedge h) const {
  Halfedge first = h;
  while (!is_fixed(mesh_, first)) {
    first = mesh_.rotate_right(first);
    if (first == h) break;
  }
  return first;
}

// The spokes from `first` to the next fixed one; twice around where nothing is fixed.
void CrossingBounds::collect_wedge(Halfedge first) {
  spokes_.assign(1, spoke(first));
  Halfedge h = first;
  do {
    h = mesh_.rotate_left(h);
    spokes_.push_back(spoke(h));
  } while (!is_fixed(mesh_, h) && h != first);
  if (is_fixed(mesh_, h)) return;
  const std::size_t degree = spokes_.size() - 1;
  for (std::size_t i = 1; i <= degree; ++i) {
    const Spoke again = spokes_[i];
    spokes_.push_back(again);
  }
}

// All wedges of the face at the origin of h.
void CrossingBounds::judge_star(Halfedge h) {
  is_judged_[mesh_.origin(h)] = true;
  const Halfedge start = first_of_wedge(h);
  Halfedge first = start;
  do {
    if (is_inside_face(mesh_, edge_of(mesh_.rotate_left(first)))) {
      collect_wedge(first);
      judge_wedge();
      for (const Spoke& s : spokes_) lower(s.halfedge, s.bound);
      first = spokes_.back().halfedge;
    } else {
      do first = mesh_.rotate_left(first);
      while (!is_fixed(mesh_, first));
    }
  } while (first != start);
}

void CrossingBounds::judge_wedge() {
  const bool trusted =
      std::all_of(spokes_.begin(), spokes_.end(), [](const Spoke& s) { return is_trusted_product(s.squared_length); });
  if (trusted && judge_pairs()) return;
  for (Spoke& s : spokes_) s.bound = 0;
}

// Bounds for the spokes that may be crossed by an edge between two others. False if that takes too long, as it
// may in large stars.
bool CrossingBounds::judge_pairs() {
  by_length_.clear();
  for (std::size_t i = 1; i + 1 < spokes_.size(); ++i) by_length_.push_back(i);
  if (by_length_.empty()) return true;
  std::sort(by_length_.begin(), by_length_.end(),
            [this](std::size_t i, std::size_t j) { return spokes_[i].squared_length > spokes_[j].squared_length; });
  const double longest = spokes_[by_length_.front()].squared_length * (1 + kProductMargin);
  std::size_t pairs_left = 16 * spokes_.size();
  std::size_t first_last = 2;
  for (std::size_t i = 0; i + 2 < spokes_.size(); ++i) {
    first_last = std::max(first_last, i + 2);
    while (first_last < spokes_.size() && is_acute(spokes_[i], spokes_[first_last])) ++first_last;
    for (std::size_t j = first_last; j < spokes_.size() && !is_reflex(spokes_[i], spokes_[j]); ++j) {
      if (spokes_[j].halfedge == spokes_[i].halfedge) break;
      if (pairs_left-- == 0) return false;
      if (spokes_[i].squared_length + spokes_[j].squared_length <= longest) judge_pair(i, j);
    }
  }
  return true;
}

void CrossingBounds::judge_pair(std::size_t first, std::size_t last) {
  const double dx = spokes_[first].x - spokes_[last].x, dy = spokes_[first].y - spokes_[last].y;
  const double squared = (dx * dx + dy * dy) * (1 - kProductMargin);
  for (const std::size_t i : by_length_) {
    if (spokes_[i].squared_length < squared) return;
    if (first < i && i < last) spokes_[i].bound = std::min(spokes_[i].bound, squared);
  }
}

// What has become crossable lets more be seen: from the apexes of its own triangles, and, as the far side of a
// triangle, from those of the triangles next to these.
bool CrossingBounds::spread(std::size_t max_steps) {
  steps_ = 0;
  for (std::size_t i = 0; i < lowered_.size(); ++i) {
    if (steps_ > max_steps) return false;
    const MeshEdge e = lowered_[i];
    mesh_.marks(e) &= ~kLoweredMark;
    for (const Halfedge h : {2 * e, 2 * e + 1}) {
      for (const Halfedge window : {h, twin(mesh_.next(h)), twin(mesh_.previous(h))}) {
        if (!may_be_crossed(window)) continue;
        look_through(window, Turn::left);
        look_through(window, Turn::right);
      }
    }
  }
  return true;
}

// From the apex on the left of the window, together with what lies to the left, or to the right, of its triangle.
void CrossingBounds::look_through(Halfedge window, Turn turn) {
  const Halfedge right = mesh_.previous(window), left = twin(mesh_.next(window)), outer = twin(window);
  const Halfedge first = turn == Turn::left ? left : right;
  if (is_fixed(mesh_, first)) return;
  if (!is_judged_[mesh_.origin(first)]) return;
  const Spoke near = spoke(first, turn), far = spoke(turn == Turn::left ? right : left, turn);
  const Halfedge near_side = turn == Turn::left ? mesh_.previous(outer) : mesh_.next(outer);
  const Halfedge far_side = turn == Turn::left ? mesh_.next(outer) : mesh_.previous(outer);
  const Spoke third = spoke_to(mesh_.origin(first), mesh_.apex(outer), turn);
  const double least = std::max(std::min(near.squared_length, far.squared_length) * (1 - kProductMargin),
                                static_cast<double>(bounds_[edge_of(window)]));
  const bool hides_far_side = is_reflex(far, third), hides_near_side = is_reflex(third, near);
  const double hidden = std::min(hides_far_side ? kInfinite : beyond(far_side, least),
                                 hides_near_side ? kInfinite : beyond(near_side, least));
  if (hidden != kInfinite) look_past({far, near, hidden}, first, turn);
  if (hides_far_side || hides_near_side) return;
  look_past({third, third, std::max(least, third.squared_length * (1 - kProductMargin))}, first, turn);
}

// How far at least the points beyond a side are that are `squared` away at least.
double CrossingBounds::beyond(Halfedge side, double squared) const {
  return may_be_crossed(side) ? std::max(squared, static_cast<double>(bounds_[edge_of(side)])) : kInfinite;
}

// Lowers the bounds of spokes, from `first` on, between what is in sight and something farther around.
void CrossingBounds::look_past(const Sight& sight, Halfedge first, Turn turn) {
  collect_half_turn(sight, first, turn);
  const bool trusted =
      is_trusted_product(sight.near.squared_length) &&
      std::all_of(spokes_.begin(), spokes_.end(), [](const Spoke& s) { return is_trusted_product(s.squared_length); });
  if (spokes_.size() > kLargeStar || !trusted) return give_up_star(first);
  double squared = kInfinite;
  for (std::size_t i = spokes_.size() - 1; i > 0; --i) {
    squared = std::min(squared, min_squared(sight, i, turn));
    const Spoke& between = spokes_[i - 1];
    if (squared <= between.squared_length * (1 + kProductMargin))
      lower(between.halfedge, squared * (1 - kProductMargin));
  }
}

// Counts all edges at the origin of h as crossed, once and for all: looking through each of many windows takes too
// long.
void CrossingBounds::give_up_star(Halfedge h) {
  is_judged_[mesh_.origin(h)] = false;
  Halfedge s = h;
  do {
    lower(s, 0);
    s = mesh_.rotate_left(s);
    ++steps_;
  } while (s != h);
}

// The spokes from `first` on, but not too many of them, up to a fixed one or to the first that is more than half a turn
// away.
void CrossingBounds::collect_half_turn(const Sight& sight, Halfedge first, Turn turn) {
  spokes_.clear();
  Halfedge h = first;
  do {
    spokes_.push_back(spoke(h, turn));
    if (is_fixed(mesh_, h) || is_reflex(sight.near, spokes_.back())) break;
    h = turn == Turn::left ? mesh_.rotate_left(h) : mesh_.rotate_right(h);
  } while (h != first && spokes_.size() <= kLargeStar);
  steps_ += spokes_.size();
}

// For edges between what is in sight and spoke i or what is seen between it and the one before.
double CrossingBounds::min_squared(const Sight& sight, std::size_t i, Turn turn) const {
  const Spoke &last = spokes_[i], &before = spokes_[i - 1];
  if (is_acute(sight.far, last)) return kInfinite;
  double result = kInfinite;
  if (!is_reflex(sight.near, last)) {
    const double product = std::min(0.0, dot(sight.near, last));
    const double cosine = product / std::sqrt(sight.near.squared_length);  // times the length of last
    result = sight.squared + last.squared_length - 2 * cosine * std::sqrt(sight.squared);
  }
  const Halfedge window = mesh_.next(turn == Turn::left ? before.halfedge : last.halfedge);
  const double shorter = std::min(before.squared_length, last.squared_length);
  return std::min(result, sight.squared + beyond(window, shorter));
}

void CrossingBounds::lower(Halfedge h, double bound) {
  constexpr double kMin = kMinTrustedFloat, kMax = kMaxTrustedFloat;
  if (bound == kInfinite) return;
  const MeshEdge e = edge_of(h);
  if (!is_inside_face(mesh_, e)) return;
  const float rounded = bound < kMin ? 0 : static_cast<float>(std::min(bound, kMax) * (1 - kFloatMargin));
  if (rounded >= bounds_[e]) return;
  bounds_[e] = rounded;
  if ((mesh_.marks(e) & kLoweredMark) != 0) return;
  mesh_.marks(e) |= kLoweredMark;
  lowered_.push_back(e);
}

}  // namespace mwt
