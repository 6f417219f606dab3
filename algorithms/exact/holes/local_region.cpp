#include "algorithms/exact/holes/local_region.h"

#include <algorithm>

#include "geometry/predicates.h"

namespace mwt {

std::vector<Triangle> LocalRegion::in_instance(std::vector<Triangle> triangles) const {
  for (Triangle& triangle : triangles) {
    for (Index& corner : triangle) corner = vertices[corner];
  }
  return triangles;
}

LocalRegion make_local(Points points, const FaceRegion& region) {
  LocalRegion local;
  local.vertices = region.vertices;
  std::sort(local.vertices.begin(), local.vertices.end(),
            [&](Index v, Index w) { return lexicographically_less(points[v], points[w]); });
  std::vector<Index> position(region.vertices.size());  // of the region's i-th vertex
  for (Index i = 0; i < local.vertices.size(); ++i) {
    position[region.place_of(local.vertices[i])] = i;
    local.points.push_back(points[local.vertices[i]]);
  }
  for (const Edge& edge : region.boundary)
    local.boundary.push_back({position[region.place_of(edge.a)], position[region.place_of(edge.b)]});
  local.sides = local.boundary;
  for (const Edge& edge : region.candidates) {
    const Index a = position[region.place_of(edge.a)], b = position[region.place_of(edge.b)];
    local.sides.insert(local.sides.end(), {{a, b}, {b, a}});
  }
  return local;
}

}  // namespace mwt
