#include "geometry/triangulation.h"

#include <algorithm>

namespace mwt {

namespace {

// A triangle's side, filed under its smaller end.
struct Side {
  Index other_end;
  Index triangle;
  int corner;  // the corner opposite the side
};

// All sides in one array, those with smaller end v at [first[v], first[v + 1]), sorted there by the other end.
struct SidesByVertex {
  std::vector<std::size_t> first;
  std::vector<Side> sides;
};

SidesByVertex sides_by_vertex(const Triangulation& triangulation) {
  SidesByVertex result;
  result.first.assign(triangulation.point_count + std::size_t{2}, 0);
  for (const Triangle& triangle : triangulation.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangle, i);
      ++result.first[std::min(side.a, side.b) + std::size_t{2}];
    }
  }
  for (std::size_t v = 2; v < result.first.size(); ++v) result.first[v] += result.first[v - 1];
  result.sides.resize(3 * triangulation.triangles.size());
  for (Index t = 0; t < triangulation.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangulation.triangles[t], i);
      const auto [low, high] = std::minmax(side.a, side.b);
      result.sides[result.first[low + std::size_t{1}]++] = {high, t, i};
    }
  }
  for (std::size_t v = 0; v < triangulation.point_count; ++v) {
    std::sort(result.sides.begin() + static_cast<std::ptrdiff_t>(result.first[v]),
              result.sides.begin() + static_cast<std::ptrdiff_t>(result.first[v + 1]),
              [](const Side& a, const Side& b) { return a.other_end < b.other_end; });
  }
  return result;
}

}  // namespace

std::vector<Edge> edges_of(const Triangulation& triangulation) {
  const SidesByVertex by_vertex = sides_by_vertex(triangulation);
  std::vector<Edge> edges;
  edges.reserve(by_vertex.sides.size() / 2 + triangulation.point_count / 8);
  for (Index v = 0; v < triangulation.point_count; ++v) {
    for (std::size_t i = by_vertex.first[v]; i < by_vertex.first[v + 1]; ++i) {
      const Edge edge{v, by_vertex.sides[i].other_end};
      if (edges.empty() || edges.back() != edge) edges.push_back(edge);
    }
  }
  return edges;
}

std::vector<std::array<Index, 3>> adjacency_of(const Triangulation& triangulation) {
  const SidesByVertex by_vertex = sides_by_vertex(triangulation);
  std::vector<std::array<Index, 3>> adjacent(triangulation.triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
  for (std::size_t v = 0; v < triangulation.point_count; ++v) {
    for (std::size_t i = by_vertex.first[v]; i + 1 < by_vertex.first[v + 1]; ++i) {
      const Side& one = by_vertex.sides[i];
      const Side& two = by_vertex.sides[i + 1];
      if (one.other_end != two.other_end) continue;
      adjacent[one.triangle][static_cast<std::size_t>(one.corner)] = two.triangle;
      adjacent[two.triangle][static_cast<std::size_t>(two.corner)] = one.triangle;
    }
  }
  return adjacent;
}

std::vector<Triangle> canonical_triangles(const Triangulation& triangulation) {
  std::vector<Triangle> triangles = triangulation.triangles;
  for (Triangle& triangle : triangles) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace mwt
