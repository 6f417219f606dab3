#include "algorithms/exact/candidates/candidate_graph.h"

#include <algorithm>
#include <utility>

#include "algorithms/common/rows.h"
#include "algorithms/exact/candidates/by_direction.h"

namespace mwt {

CandidateGraph make_candidate_graph(Points points, std::span<const Edge> edges, std::span<const Edge> certain) {
  Rows<Index> stars = file_in_rows<Index>(points.size(), [&](const auto& file) {
    for (const Edge& edge : edges) {
      file(edge.a, edge.b);
      file(edge.b, edge.a);
    }
  });
  std::vector<std::uint8_t> marks;
  for (Index v = 0; v < points.size(); ++v) {
    const std::span<Index> star = stars[v];
    std::sort(star.begin(), star.end(), ByDirection(points, v));
    for (const Index w : star) {
      marks.push_back(std::binary_search(certain.begin(), certain.end(), make_edge(v, w)) ? 1 : 0);
    }
  }
  return {points, std::move(stars.first), std::move(stars.values), std::move(marks)};
}

std::vector<Edge> edges_marked(const CandidateGraph& graph, std::uint8_t certain) {
  std::vector<Edge> edges;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
      if (v < graph.target[h] && graph.certain[h] == certain) edges.push_back({v, graph.target[h]});
    }
  }
  return edges;
}

}  // namespace mwt
