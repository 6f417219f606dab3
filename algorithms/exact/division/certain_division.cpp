#include "algorithms/exact/division/certain_division.h"

#include <algorithm>
#include <utility>

#include "algorithms/exact/division/beta_skeleton.h"
#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/proof_trace.h"

namespace mwt {

namespace {

bool is_certain(const CandidateGraph& graph, const Edge& edge) {
  const auto star = graph.star(edge.a);
  const auto place = std::find(star.begin(), star.end(), edge.b);
  return place != star.end() &&
         graph.certain[graph.first[edge.a] + static_cast<std::size_t>(place - star.begin())] != 0;
}

// The candidates that are not certain and have an end among `vertices`: a < b.
std::vector<Edge> uncertain_candidates_at(std::span<const Index> vertices, const CandidateGraph& graph) {
  std::vector<Edge> edges;
  for (const Index v : vertices) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
      const Index w = graph.target[h];
      const bool is_listed_at_w = w < v && std::binary_search(vertices.begin(), vertices.end(), w);
      if (graph.certain[h] == 0 && !is_listed_at_w) edges.push_back(make_edge(v, w));
    }
  }
  return edges;
}

// The edges of the beta-skeleton that others cross, those others, and what LMT deleted without them.
void note_division(std::vector<Edge> crossing, std::vector<Edge> crossed, std::vector<Edge> deleted,
                   ProofTrace& trace) {
  std::vector<Edge> dividing;
  for (const Edge& edge : crossed) {
    if (edge.a != edge.b) dividing.push_back(edge);
  }
  std::sort(dividing.begin(), dividing.end());
  dividing.erase(std::unique(dividing.begin(), dividing.end()), dividing.end());
  trace.edges.push_back({EdgeReason::in_beta_skeleton, std::move(dividing), {}});
  trace.edges.push_back({EdgeReason::crosses_certain, std::move(crossing), std::move(crossed)});
  trace.edges.push_back({EdgeReason::not_locally_minimal, std::move(deleted), {}});
}

}  // namespace

std::size_t delete_what_crosses_beta_skeleton(const KdOrder& order, std::span<const Index> vertices,
                                              const CandidateGraph& graph, const HullEdges& hull, StarTable& stars,
                                              const Context& context) {
  std::vector<Edge> dividing = beta_skeleton_between(order, vertices);
  std::erase_if(dividing, [&](const Edge& edge) { return is_certain(graph, edge); });
  const CandidateGraph division = make_candidate_graph(graph.points, dividing, dividing);
  std::vector<Edge> crossed, deleted;
  auto crossing =
      find_crossing_candidates(division, uncertain_candidates_at(vertices, graph), context.deadline, &crossed);
  if (!crossing) throw SearchStopped(StopReason::deadline, "the deadline passed while dividing by the beta-skeleton");
  std::vector<CandidatePair> pairs;
  for (const Edge& edge : *crossing) pairs.push_back({edge.a, edge.b});
  delete_edges(stars, graph.points, hull, pairs, context, &deleted);
  if (context.proof != nullptr && !pairs.empty())
    note_division(*std::move(crossing), std::move(crossed), std::move(deleted), *context.proof);
  return pairs.size();
}

}  // namespace mwt
