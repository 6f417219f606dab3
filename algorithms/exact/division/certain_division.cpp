#include "algorithms/exact/division/certain_division.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "algorithms/exact/division/beta_skeleton.h"
#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/proof_trace.h"

namespace mwt {

namespace {

std::vector<Edge> difference(const std::vector<Edge>& all, std::vector<Edge> without) {
  std::sort(without.begin(), without.end());
  std::vector<Edge> rest;
  std::set_difference(all.begin(), all.end(), without.begin(), without.end(), std::back_inserter(rest));
  return rest;
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

bool is_connected(const CandidateGraph& graph) {
  DisjointSets components(graph.points.size());
  std::size_t count = graph.points.size();
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
      const Index w = graph.target[h];
      if (w < v || graph.certain[h] == 0 || components.find(v) == components.find(w)) continue;
      components.unite(v, w);
      --count;
    }
  }
  return count == 1;
}

std::size_t delete_what_crosses_beta_skeleton(const CandidateGraph& graph, const HullEdges& hull, StarTable& stars,
                                              const Context& context) {
  const std::vector<Edge> dividing = difference(beta_skeleton(graph.points), edges_marked(graph, 1));
  const CandidateGraph division = make_candidate_graph(graph.points, dividing, dividing);
  std::vector<Edge> crossed, deleted;
  auto crossing = find_crossing_candidates(division, edges_marked(graph, 0), context.deadline, &crossed);
  if (!crossing) throw SearchStopped(StopReason::deadline, "the deadline passed while dividing by the beta-skeleton");
  std::vector<CandidatePair> pairs;
  for (const Edge& edge : *crossing) pairs.push_back({edge.a, edge.b});
  delete_edges(stars, graph.points, hull, pairs, context, &deleted);
  if (context.proof != nullptr && !pairs.empty())
    note_division(*std::move(crossing), std::move(crossed), std::move(deleted), *context.proof);
  return pairs.size();
}

}  // namespace mwt
