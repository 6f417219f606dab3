#include "geometry/weight.h"

namespace mwt {

Interval weight(Points points, const Triangulation& triangulation) {
  LengthSum sum;
  for (const Edge& edge : edges_of(triangulation)) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

Interval perimeter_sum(Points points, const Triangulation& triangulation) {
  LengthSum sum;
  for (const Triangle& triangle : triangulation.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangle, i);
      sum.add(points[side.a], points[side.b]);
    }
  }
  return sum.enclosure();
}

Interval cycle_length(Points points, std::span<const Index> cycle) {
  LengthSum sum;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    sum.add(points[cycle[i]], points[cycle[(i + 1) % cycle.size()]]);
  }
  return sum.enclosure();
}

}  // namespace mwt
