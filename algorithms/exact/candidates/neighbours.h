// The neighbours of a vertex in a candidate graph: their places in its star, and edges between them.
#pragma once

#include <algorithm>
#include <cstdint>

#include "algorithms/exact/candidates/by_direction.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "geometry/predicates.h"

namespace mwt {

/// The place of `neighbour` in the star of v, which must be in the order of ByDirection; the star's size if it is none.
[[nodiscard]] inline std::uint32_t place_in_star(const CandidateGraph& graph, Index v, Index neighbour) {
  constexpr std::size_t kLargeStar = 64;  // worth a bisection
  const auto star = graph.star(v);
  auto found = star.begin();
  if (star.size() <= kLargeStar) {
    found = std::find(star.begin(), star.end(), neighbour);
  } else {
    found = std::lower_bound(star.begin(), star.end(), neighbour, ByDirection(graph.points, v));
    if (found != star.end() && *found != neighbour) found = star.end();
  }
  return static_cast<std::uint32_t>(found - star.begin());
}

/// Whether an edge from y, a neighbour of s, to another neighbour of s crosses st. Seen from y it leaves between s and
/// t: of a short edge st these are few. `place`: of s in the star of y. `is_neighbour(w)`: whether sw is an edge.
///
/// If no neighbour y has such an edge, every triangulation by edges of the graph contains st: were st missing, it would
/// enter a triangle syw at s and leave it through yw.
template <class IsNeighbour>
[[nodiscard]] bool is_crossed_from(const CandidateGraph& graph, Index y, std::uint32_t place, Index s, Index t,
                                   const IsNeighbour& is_neighbour) {
  const Points points = graph.points;
  const int turn = orientation(points[y], points[s], points[t]);
  if (turn == 0) return false;
  const auto star = graph.star(y);
  const auto degree = static_cast<std::uint32_t>(star.size());
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
    if (turn * orientation(points[s], points[t], points[w]) < 0 && is_neighbour(w)) return true;
  }
}

}  // namespace mwt
