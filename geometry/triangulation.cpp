#include "geometry/triangulation.h"

#include <algorithm>

#include "geometry/triangle_sides.h"

namespace mwt {

std::vector<Edge> edges_of(const Triangulation& triangulation) {
  const TriangleSides sides(triangulation);
  std::vector<Edge> edges;
  edges.reserve(3 * std::size_t{triangulation.point_count});
  for (Index v = 0; v < triangulation.point_count; ++v) {
    for (const TriangleSide& side : sides.row(v)) {
      const Edge edge{v, side.other_end};
      if (edges.empty() || edges.back() != edge) edges.push_back(edge);
    }
  }
  return edges;
}

std::vector<std::array<Index, 3>> adjacency_of(const Triangulation& triangulation) {
  const TriangleSides sides(triangulation);
  std::vector<std::array<Index, 3>> adjacent(triangulation.triangles.size(), {kNoIndex, kNoIndex, kNoIndex});
  for (Index v = 0; v < triangulation.point_count; ++v) {
    const auto row = sides.row(v);
    for (std::size_t i = 0; i + 1 < row.size(); ++i) {
      const TriangleSide& one = row[i];
      const TriangleSide& two = row[i + 1];
      if (one.other_end != two.other_end) continue;
      adjacent[one.triangle][one.corner] = two.triangle;
      adjacent[two.triangle][two.corner] = one.triangle;
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
