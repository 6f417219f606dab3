#include "algorithms/exact/faces/walk_diagonals.h"

#include <algorithm>
#include <utility>

namespace mwt {

std::optional<Diagonals> diagonals_of_walk(const CandidateGraph& graph, const Walk& walk) {
  std::vector<std::pair<Index, std::uint32_t>> places;
  std::size_t halfedges = 0;
  for (std::uint32_t p = 0; p < walk.size(); ++p) {
    places.emplace_back(walk[p].vertex, p);
    halfedges += walk[p].candidates;
  }
  std::sort(places.begin(), places.end());
  Diagonals diagonals;
  for (std::uint32_t p = 0; p < walk.size(); ++p) {
    const std::size_t before = diagonals.size();
    for (std::uint32_t i = 0; i < walk[p].candidates; ++i) {
      const Index target = candidate_of(graph, walk[p], i);
      auto it = std::lower_bound(places.begin(), places.end(), std::pair(target, p + 1));
      while (it != places.end() && it->first == target && !leads_to(graph, walk[it->second], walk[p].vertex)) ++it;
      if (it != places.end() && it->first == target) diagonals.push_back({p, it->second});
    }
    std::sort(diagonals.begin() + static_cast<std::ptrdiff_t>(before), diagonals.end());
  }
  if (2 * diagonals.size() != halfedges) return {};
  return diagonals;
}

}  // namespace mwt
