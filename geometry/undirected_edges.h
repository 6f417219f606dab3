// From sides of triangles, each in its direction, to edges.
#pragma once

#include <algorithm>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// The same edges with a < b, ascending, each once. O(m log m).
[[nodiscard]] inline std::vector<Edge> undirected_edges(std::vector<Edge> edges) {
  for (Edge& edge : edges) edge = make_edge(edge.a, edge.b);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace mwt
