#include "algorithms/exact/holes/uncrossed_edges.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "algorithms/exact/candidates/by_direction.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

class Marking {
 public:
  explicit Marking(CandidateGraph& graph) : graph_(graph) {}

  std::size_t run() {
    std::vector<std::uint32_t> uncrossed;  // halfedges from the smaller end
    for (Index s = 0; s < graph_.points.size(); ++s) {
      for (std::uint32_t h = graph_.first[s]; h < graph_.first[s + std::size_t{1}]; ++h) {
        if (s < graph_.target[h] && graph_.certain[h] == 0 && !is_crossed(s, graph_.target[h])) uncrossed.push_back(h);
      }
    }
    Index s = 0;
    for (const std::uint32_t h : uncrossed) {
      while (graph_.first[s + std::size_t{1}] <= h) ++s;
      graph_.certain[h] = 1;
      graph_.certain[graph_.first[graph_.target[h]] + place_of(s, graph_.target[h])] = 1;
    }
    return uncrossed.size();
  }

 private:
  // Of neighbour t in the star of s; the star's size if it is none.
  [[nodiscard]] std::uint32_t place_of(Index t, Index s) const {
    constexpr std::size_t kLargeStar = 32;
    const auto star = graph_.star(s);
    if (star.size() <= kLargeStar)
      return static_cast<std::uint32_t>(std::find(star.begin(), star.end(), t) - star.begin());
    const auto found = std::lower_bound(star.begin(), star.end(), t, ByDirection(graph_.points, s));
    const bool exists = found != star.end() && *found == t;
    return static_cast<std::uint32_t>((exists ? found : star.end()) - star.begin());
  }

  [[nodiscard]] bool are_joined(Index v, Index w) const { return place_of(v, w) < graph_.star(w).size(); }

  [[nodiscard]] bool is_crossed(Index s, Index t) const {
    const auto star = graph_.star(s);
    // Neighbours next to t in the star are the likeliest.
    const std::uint32_t place = place_of(t, s);
    const auto degree = static_cast<std::uint32_t>(star.size());
    for (std::uint32_t step = 1; step < degree; ++step) {
      if (is_crossed_from(star[(place + step) % degree], s, t)) return true;
    }
    return false;
  }

  // Whether an edge from y, a neighbour of s, to another neighbour of s crosses st.
  [[nodiscard]] bool is_crossed_from(Index y, Index s, Index t) const {
    const Points points = graph_.points;
    const int turn = orientation(points[y], points[s], points[t]);
    if (turn == 0) return false;
    const auto star = graph_.star(y);
    const auto degree = static_cast<std::uint32_t>(star.size());
    std::uint32_t place = place_of(s, y);
    for (;;) {
      if (turn > 0) {
        place = place + 1 < degree ? place + 1 : 0;
      } else {
        place = (place > 0 ? place : degree) - 1;
      }
      const Index w = star[place];
      const bool leaves_between = turn * orientation(points[y], points[s], points[w]) > 0 &&
                                  turn * orientation(points[y], points[w], points[t]) > 0;
      if (!leaves_between) return false;
      if (turn * orientation(points[s], points[t], points[w]) < 0 && are_joined(s, w)) return true;
    }
  }

  CandidateGraph& graph_;
};

}  // namespace

std::size_t mark_uncrossed_edges(CandidateGraph& graph) { return Marking(graph).run(); }

}  // namespace mwt
