#include "algorithms/exact/candidate_graph.h"

#include <algorithm>
#include <numeric>

#include "algorithms/exact/by_direction.h"

namespace mwt {

CandidateGraph make_candidate_graph(Points points, std::span<const Edge> edges, std::span<const Edge> certain) {
  CandidateGraph graph;
  graph.points = points;
  graph.first.assign(points.size() + 1, 0);
  for (const Edge& edge : edges) {
    ++graph.first[edge.a + std::size_t{1}];
    ++graph.first[edge.b + std::size_t{1}];
  }
  std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
  graph.target.resize(2 * edges.size());
  std::vector<std::uint32_t> next(graph.first.begin(), graph.first.end() - 1);
  for (const Edge& edge : edges) {
    graph.target[next[edge.a]++] = edge.b;
    graph.target[next[edge.b]++] = edge.a;
  }
  for (Index v = 0; v < points.size(); ++v) {
    const auto begin = graph.target.begin() + graph.first[v],
               end = graph.target.begin() + graph.first[v + std::size_t{1}];
    std::sort(begin, end, ByDirection(points, v));
    for (auto it = begin; it != end; ++it) {
      graph.certain.push_back(std::binary_search(certain.begin(), certain.end(), make_edge(v, *it)) ? 1 : 0);
    }
  }
  return graph;
}

}  // namespace mwt
