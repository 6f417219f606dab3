#include "algorithms/exact/proof/hole_cuts.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/predicates.h"

namespace mwt {

HoleCuts::HoleCuts(Points points, std::span<const Index> hole, std::span<const Edge> edges) : points_(points) {
  int best_turns = 0;
  std::optional<std::vector<std::uint32_t>> fewest;
  for (const int turns : {0, 1, 2, 3}) {
    turns_ = turns;
    const Index last = *std::max_element(
        hole.begin(), hole.end(), [&](Index v, Index w) { return lexicographically_less(turned(v), turned(w)); });
    std::vector<std::uint32_t> cuts;
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      const auto [a, b] = edges[e];
      if (a != last && b != last) continue;
      if (lexicographically_less(turned(last), turned(a == last ? b : a))) cuts.push_back(e);
    }
    if (fewest && fewest->size() <= cuts.size()) continue;
    fewest = std::move(cuts);
    best_turns = turns;
    from_ = last;
  }
  turns_ = best_turns;
  cuts_ = *std::move(fewest);
}

// By a quarter of a circle several times; which side of a line a point is on does not change.
Point HoleCuts::turned(Index v) const {
  const Point& p = points_[v];
  switch (turns_) {
    case 0: return p;
    case 1: return {p.y, -p.x};
    case 2: return {-p.x, -p.y};
    default: return {-p.y, p.x};
  }
}

int HoleCuts::crossing_of_ray(Index first, Index second) const {
  if (first == from_ || second == from_) return 0;
  const Point a = turned(first), b = turned(second), u = turned(from_);
  if (a.y <= u.y && u.y < b.y && orientation(a, b, u) > 0) return 1;
  if (b.y <= u.y && u.y < a.y && orientation(b, a, u) > 0) return -1;
  return 0;
}

}  // namespace mwt
