#include "algorithms/exact/faces/face_region.h"

#include <algorithm>
#include <array>
#include <span>
#include <stdexcept>
#include <unordered_map>

#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/length_sum_comparison.h"
#include "geometry/delaunay.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

void sort_and_remove_duplicates(auto& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Of walks and isolated vertices: the walks first.
DisjointSets unite_by_candidates(const CandidateGraph& graph, const FaceWalker& walker, const std::vector<Walk>& walks,
                                 const std::vector<Index>& isolated) {
  std::unordered_map<std::uint32_t, std::size_t> walk_of_corner;
  for (std::size_t w = 0; w < walks.size(); ++w) {
    for (const Corner& corner : walks[w]) walk_of_corner.emplace(corner.halfedge, w);
  }
  const auto component_at = [&](Index vertex, Index seen_from) {
    const auto place = std::lower_bound(isolated.begin(), isolated.end(), vertex);
    const bool is_isolated = place != isolated.end() && *place == vertex;
    if (is_isolated) return walks.size() + static_cast<std::size_t>(place - isolated.begin());
    const auto walk = walk_of_corner.find(walker.corner_towards(vertex, seen_from).halfedge);
    if (walk == walk_of_corner.end()) throw std::logic_error("candidate graph: a candidate leaves its face");
    return walk->second;
  };
  DisjointSets components(walks.size() + isolated.size());
  for (std::size_t w = 0; w < walks.size(); ++w) {
    for (const Corner& corner : walks[w]) {
      for (std::uint32_t i = 0; i < corner.candidates; ++i) {
        components.unite(w, component_at(candidate_of(graph, corner, i), corner.vertex));
      }
    }
  }
  for (std::size_t i = 0; i < isolated.size(); ++i) {
    for (const Index target : graph.star(isolated[i])) {
      components.unite(walks.size() + i, component_at(target, isolated[i]));
    }
  }
  return components;
}

// Directed edges, sorted, to look up which side of which edge the region lies on.
std::vector<Edge> sorted_boundary(const FaceRegion& region) {
  std::vector<Edge> boundary = region.boundary;
  std::sort(boundary.begin(), boundary.end());
  return boundary;
}

bool contains(const std::vector<Edge>& sorted, const Edge& edge) {
  return std::binary_search(sorted.begin(), sorted.end(), edge);
}

// The triangles of a constrained triangulation that lie in the region: those left of a boundary edge, and all that can
// be reached from them without crossing the boundary.
std::vector<std::uint8_t> find_inner_triangles(const Triangulation& triangulation, const std::vector<Edge>& boundary) {
  const auto adjacent = adjacency_of(triangulation);
  std::vector<std::uint8_t> is_inner(triangulation.triangles.size(), 0);
  std::vector<Index> stack;
  const auto mark = [&](Index t) {
    if (is_inner[t] == 0) stack.push_back(t);
    is_inner[t] = 1;
  };
  for (Index t = 0; t < triangulation.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      if (contains(boundary, directed_edge(triangulation.triangles[t], i))) mark(t);
    }
  }
  while (!stack.empty()) {
    const Index t = stack.back();
    stack.pop_back();
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangulation.triangles[t], i);
      const bool is_boundary = contains(boundary, side) || contains(boundary, {side.b, side.a});
      if (!is_boundary) mark(adjacent[t][static_cast<std::size_t>(i)]);
    }
  }
  return is_inner;
}

}  // namespace

Index FaceRegion::place_of(Index vertex) const {
  return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
}

std::vector<Edge> FaceRegion::in_places(const std::vector<Edge>& edges) const {
  std::vector<Edge> places;
  places.reserve(edges.size());
  for (const Edge& edge : edges) places.push_back({place_of(edge.a), place_of(edge.b)});
  return places;
}

std::vector<Point> FaceRegion::points_among(Points points) const {
  std::vector<Point> own;
  own.reserve(vertices.size());
  for (const Index vertex : vertices) own.push_back(points[vertex]);
  return own;
}

FaceRegion make_region(const CandidateGraph& graph, const std::vector<const Walk*>& walks,
                       const std::vector<Index>& isolated) {
  FaceRegion region;
  region.components = walks.size() + isolated.size();
  region.vertices = isolated;
  for (const Walk* walk : walks) {
    for (const Corner& corner : *walk) {
      region.vertices.push_back(corner.vertex);
      region.boundary.push_back({corner.vertex, graph.target[corner.halfedge]});
      for (std::uint32_t i = 0; i < corner.candidates; ++i) {
        region.candidates.push_back(make_edge(corner.vertex, candidate_of(graph, corner, i)));
      }
    }
  }
  for (const Index vertex : isolated) {
    for (const Index target : graph.star(vertex)) region.candidates.push_back(make_edge(vertex, target));
  }
  sort_and_remove_duplicates(region.vertices);
  sort_and_remove_duplicates(region.candidates);
  return region;
}

std::vector<FaceRegion> group_into_regions(const CandidateGraph& graph, const FaceWalker& walker,
                                           const std::vector<Walk>& walks, const std::vector<Index>& isolated) {
  DisjointSets components = unite_by_candidates(graph, walker, walks, isolated);
  struct Members {
    std::vector<const Walk*> walks;
    std::vector<Index> isolated;
  };
  std::vector<Members> members(walks.size() + isolated.size());
  for (std::size_t w = 0; w < walks.size(); ++w) members[components.find(w)].walks.push_back(&walks[w]);
  for (std::size_t i = 0; i < isolated.size(); ++i) {
    members[components.find(walks.size() + i)].isolated.push_back(isolated[i]);
  }
  std::vector<FaceRegion> regions;
  for (const Members& one : members) {
    if (one.walks.empty() && one.isolated.empty()) continue;
    if (one.walks.empty()) throw std::logic_error("candidate graph: isolated vertices without candidates to a face");
    regions.push_back(make_region(graph, one.walks, one.isolated));
  }
  return regions;
}

std::vector<Triangle> fill_region(Points points, const FaceRegion& region) {
  // Vertices ascend, so that edges by places are in order as well.
  const std::vector<Edge> boundary = region.in_places(sorted_boundary(region));
  const std::vector<Edge> constraints = undirected_edges(boundary);
  const Triangulation filling = constrained_delaunay_triangulation(region.points_among(points), constraints);
  const std::vector<std::uint8_t> is_inner = find_inner_triangles(filling, boundary);
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < filling.triangles.size(); ++t) {
    const auto [a, b, c] = filling.triangles[t];
    if (is_inner[t] != 0) triangles.push_back({region.vertices[a], region.vertices[b], region.vertices[c]});
  }
  return triangles;
}

LengthSum diagonals_length(Points points, const FaceRegion& region, const std::vector<Triangle>& triangles) {
  const std::vector<Edge> boundary = sorted_boundary(region);
  LengthSum sum;
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangle, i);
      const bool is_diagonal = side.a < side.b && !contains(boundary, side);  // its other side has a > b
      if (is_diagonal) sum.add(points[side.a], points[side.b]);
    }
  }
  return sum;
}

Interval shortest_edges_length(Points points, std::vector<Edge> edges, std::size_t count) {
  count = std::min(count, edges.size());
  const auto is_shorter = [&](const Edge& e, const Edge& f) { return compare_edge_lengths(points, e, f) < 0; };
  std::nth_element(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count), edges.end(), is_shorter);
  LengthSum sum;
  for (const Edge& edge : std::span(edges).first(count)) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

double lower_bound_of_diagonals(Points points, const FaceRegion& region) {
  return shortest_edges_length(points, region.candidates, region.diagonal_count()).lower;
}

}  // namespace mwt
