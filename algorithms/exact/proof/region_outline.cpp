#include "algorithms/exact/proof/region_outline.h"

#include <algorithm>
#include <vector>

namespace mwt {

DualRegion outline_of(const LocalRegion& local) {
  using Place = std::uint32_t;
  DualRegion result;
  std::vector<Place> place_of(local.points.size(), 0);
  std::vector<bool> has_place(local.points.size(), false);
  std::vector<std::vector<Index>> next(local.points.size());
  for (const Edge& side : local.boundary) next[side.a].push_back(side.b);
  const auto add_place = [&](Index v) {
    place_of[v] = static_cast<Place>(result.places.size());
    has_place[v] = true;
    result.places.push_back(v);
  };
  for (Index v = 0; v < local.points.size(); ++v) {
    while (!next[v].empty()) {
      const std::size_t first = result.places.size();
      for (Index at = v; !next[at].empty();) {
        add_place(at);
        const Index to = next[at].back();
        next[at].pop_back();
        at = to;
      }
      result.walk_sizes.push_back(static_cast<std::uint32_t>(result.places.size() - first));
    }
  }
  for (Index v = 0; v < local.points.size(); ++v) {
    if (!has_place[v]) add_place(v);
  }
  for (std::size_t i = local.boundary.size(); i < local.sides.size(); i += 2) {  // each in both directions
    const Place a = place_of[local.sides[i].a], b = place_of[local.sides[i].b];
    result.open_edges.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(result.open_edges.begin(), result.open_edges.end());
  return result;
}

}  // namespace mwt
