#include "algorithms/exact/faces/composite_vertices.h"

#include <algorithm>
#include <cstdint>

#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/face_walk.h"

namespace mwt {

namespace {

DisjointSets certain_components(const CandidateGraph& graph) {
  DisjointSets components(graph.points.size());
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
      if (graph.certain[h] != 0 && v < graph.target[h]) components.unite(v, graph.target[h]);
    }
  }
  return components;
}

bool has_certain_edge(const CandidateGraph& graph, Index vertex) {
  const auto begin = graph.certain.begin();
  return std::any_of(begin + graph.first[vertex], begin + graph.first[vertex + std::size_t{1}],
                     [](std::uint8_t mark) { return mark != 0; });
}

}  // namespace

std::vector<Index> composite_vertices(const CandidateGraph& graph) {
  DisjointSets components = certain_components(graph);
  const FaceWalker walker(graph);
  std::vector<Index> vertices;
  std::vector<bool> is_visited;  // halfedges whose corners are in the walks
  const auto add_boundary_at = [&](Index vertex, Index neighbour) {
    if (!has_certain_edge(graph, vertex)) return vertices.push_back(vertex);
    const Corner corner = walker.corner_towards(vertex, neighbour);
    is_visited.resize(graph.target.size());
    if (is_visited[corner.halfedge]) return;
    for (const Corner& other : walker.corners_of_face(vertex, corner.halfedge)) {
      is_visited[other.halfedge] = true;
      vertices.push_back(other.vertex);
    }
  };
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (const Index w : graph.star(v)) {
      if (components.find(v) != components.find(w)) add_boundary_at(v, w);
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

}  // namespace mwt
