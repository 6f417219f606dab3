#include "algorithms/exact/holes/region_branching.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/length_sum_comparison.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// By position in region.vertices.
std::vector<std::size_t> components_of(const FaceRegion& region) {
  DisjointSets sets(region.vertices.size());
  for (const Edge& edge : region.boundary) sets.unite(region.place_of(edge.a), region.place_of(edge.b));
  std::vector<std::size_t> component;
  for (std::size_t v = 0; v < region.vertices.size(); ++v) component.push_back(sets.find(v));
  return component;
}

// The region in which the edge is one of the boundary, in both directions.
FaceRegion with_slit(Points points, const FaceRegion& region, const Edge& edge) {
  FaceRegion slit{region.vertices, region.boundary, {}, region.components - 1};
  slit.boundary.push_back(edge);
  slit.boundary.push_back({edge.b, edge.a});
  std::copy_if(
      region.candidates.begin(), region.candidates.end(), std::back_inserter(slit.candidates), [&](const Edge& other) {
        return other != edge && !segments_cross(points[edge.a], points[edge.b], points[other.a], points[other.b]);
      });
  return slit;
}

// The branches that have not been begun, all at once: what they have in common is that they lack the edges of the
// others. Each of them by itself would cost the time that there is no more.
void leave_rest(Points points, const FaceRegion& rest, const RegionSearch& search, RegionSolution& best) {
  RegionSolution left = leave_unsolved(points, rest, StopReason::deadline, search.bounds_deadline);
  best.lower_bound = std::min(best.lower_bound, left.lower_bound);
  best.solved = false;
  best.stop_reason = combined(best.stop_reason, left.stop_reason);
  if (!best.triangles.empty()) return;
  best.triangles = std::move(left.triangles);
  best.diagonals = left.diagonals;
}

}  // namespace

std::vector<Edge> unavoidable_candidates(Points points, const FaceRegion& region) {
  const std::vector<std::size_t> component = components_of(region);
  const auto first = std::min_element(region.vertices.begin(), region.vertices.end(),
                                      [&](Index v, Index w) { return lexicographically_less(points[v], points[w]); });
  const std::size_t outer = component[static_cast<std::size_t>(first - region.vertices.begin())];
  std::optional<std::vector<Edge>> fewest;
  for (const auto is_before : {lexicographically_less, colexicographically_less}) {
    for (const bool last : {false, true}) {
      const auto is_beyond = [&](Index v, Index w) {
        return last ? is_before(points[w], points[v]) : is_before(points[v], points[w]);
      };
      std::vector<Index> extreme(component.size(), kNoIndex);  // of each component, by its representative
      for (std::size_t v = 0; v < component.size(); ++v) {
        Index& known = extreme[component[v]];
        if (known == kNoIndex || is_beyond(region.vertices[v], known)) known = region.vertices[v];
      }
      std::vector<std::vector<Edge>> edges(component.size());  // likewise
      for (const Edge& edge : region.candidates) {
        for (const auto& [u, v] : {std::pair(edge.a, edge.b), std::pair(edge.b, edge.a)}) {
          const std::size_t own = component[region.place_of(u)];
          if (extreme[own] == u && is_beyond(v, u)) edges[own].push_back(edge);
        }
      }
      for (std::size_t c = 0; c < component.size(); ++c) {
        const bool is_hole = component[c] == c && c != outer;
        if (is_hole && (!fewest || edges[c].size() < fewest->size())) fewest = std::move(edges[c]);
      }
    }
  }
  return fewest.value_or(std::vector<Edge>{});
}

RegionSolution solve_by_branching(Points points, const FaceRegion& region, const RegionSearch& search) {
  std::vector<Edge> edges = unavoidable_candidates(points, region);
  std::stable_sort(edges.begin(), edges.end(),
                   [&](const Edge& e, const Edge& f) { return compare_edge_lengths(points, e, f) < 0; });
  RegionSolution best = RegionSolution::infeasible();
  best.counters.branchings = 1;
  FaceRegion rest = region;
  RegionSearch branch = search;
  double limit = search.limit;
  for (const Edge& edge : edges) {
    LengthSum own;
    own.add(points[edge.a], points[edge.b]);
    if (own.enclosure().lower >= limit) {  // as are the others
      best.lower_bound = std::min(best.lower_bound, limit);
      break;
    }
    if (has_passed(search.deadline)) {
      leave_rest(points, rest, search, best);
      break;
    }
    branch.limit = next_up(limit - own.enclosure().lower);
    RegionSolution found = solve_region(points, with_slit(points, rest, edge), branch);
    best.counters.add(found.counters);
    std::erase(rest.candidates, edge);
    if (!found.is_feasible()) continue;
    best.lower_bound = std::min(best.lower_bound, next_down(found.lower_bound + own.enclosure().lower));
    const bool is_settled = found.solved || found.lower_bound >= branch.limit;
    best.solved = best.solved && is_settled;
    if (!is_settled) best.stop_reason = combined(best.stop_reason, found.stop_reason);
    if (found.triangles.empty()) continue;  // nothing below the limit
    found.diagonals.add(own);
    const double weight = found.diagonals.enclosure().upper;
    limit = std::min(limit, weight);
    if (!best.triangles.empty() && best.diagonals.enclosure().upper <= weight) continue;
    best.triangles = std::move(found.triangles);
    best.diagonals = found.diagonals;
  }
  return best;
}

}  // namespace mwt
