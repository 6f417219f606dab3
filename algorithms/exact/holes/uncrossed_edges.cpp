#include "algorithms/exact/holes/uncrossed_edges.h"

#include <cstdint>
#include <vector>

#include "algorithms/exact/candidates/neighbours.h"

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
      graph_.certain[graph_.first[graph_.target[h]] + place_in_star(graph_, graph_.target[h], s)] = 1;
    }
    return uncrossed.size();
  }

 private:
  [[nodiscard]] bool is_crossed(Index s, Index t) const {
    const auto star = graph_.star(s);
    // Neighbours next to t in the star are the likeliest.
    const std::uint32_t place = place_in_star(graph_, s, t);
    const auto degree = static_cast<std::uint32_t>(star.size());
    const auto is_neighbour = [&](Index w) { return place_in_star(graph_, w, s) < graph_.star(w).size(); };
    for (std::uint32_t step = 1; step < degree; ++step) {
      const Index y = star[(place + step) % degree];
      if (is_crossed_from(graph_, y, place_in_star(graph_, y, s), s, t, is_neighbour)) return true;
    }
    return false;
  }

  CandidateGraph& graph_;
};

}  // namespace

std::size_t mark_uncrossed_edges(CandidateGraph& graph) { return Marking(graph).run(); }

}  // namespace mwt
