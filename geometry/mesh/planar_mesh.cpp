#include "geometry/mesh/planar_mesh.h"

#include <algorithm>

#include "geometry/mesh/mesh_builder.h"
#include "geometry/predicates.h"

namespace mwt {

PlanarMesh PlanarMesh::delaunay(Points points) { return MeshBuilder(points).delaunay(); }

PlanarMesh::PlanarMesh(Points points, const Triangulation& triangulation) {
  *this = MeshBuilder(points).given(triangulation);
}

Edge PlanarMesh::labelled_edge(MeshEdge e) const {
  return make_edge(labels_[edges_[e].origins[0]], labels_[edges_[e].origins[1]]);
}

void PlanarMesh::set_edge(MeshEdge e, Index from, Index to) {
  const Point& p = points_[from];
  const Point& q = points_[to];
  const double dx = p.x - q.x, dy = p.y - q.y;
  EdgeRecord& edge = edges_[e];
  edge.origins = {from, to};
  edge.squared_length = static_cast<float>(dx * dx + dy * dy);
  edge.marks = 0;
}

void PlanarMesh::link_triangle(Halfedge a, Halfedge b, Halfedge c) {
  edges_[a >> 1].next[a & 1] = b;
  edges_[a >> 1].previous[a & 1] = c;
  edges_[b >> 1].next[b & 1] = c;
  edges_[b >> 1].previous[b & 1] = a;
  edges_[c >> 1].next[c & 1] = a;
  edges_[c >> 1].previous[c & 1] = b;
}

void PlanarMesh::flip(MeshEdge e) {
  const Halfedge h = 2 * e, t = h + 1;
  const Halfedge h_next = next(h), h_previous = previous(h), t_next = next(t), t_previous = previous(t);
  set_edge(e, origin(t_previous), origin(h_previous));
  link_triangle(h, h_previous, t_next);
  link_triangle(t, t_previous, h_next);
}

bool PlanarMesh::is_flippable(MeshEdge e) const {
  const Point& a = point(origin(2 * e));
  const Point& b = point(target(2 * e));
  const Point& left = point(apex(2 * e));
  const Point& right = point(apex(2 * e + 1));
  return orientation(right, b, left) > 0 && orientation(left, a, right) > 0;
}

void PlanarMesh::clear_marks(std::uint32_t marks) {
  for (EdgeRecord& edge : edges_) edge.marks &= ~marks;
}

Triangulation PlanarMesh::triangulation() const {
  Triangulation result;
  result.point_count = static_cast<Index>(points_.size());
  vacate_kept_blocks(2 * points_.size() * sizeof(Triangle));  // for this list
  result.triangles.reserve(2 * points_.size());
  for (Halfedge h = 0; h < 2 * edges_.size(); ++h) {
    const Halfedge second = next(h), third = previous(h);
    // Every triangle is met at its smallest halfedge; the outer face has kHullMark on side 1 of its edges.
    const bool outer = (h & 1) == 1 && is_hull(edge_of(h));
    if (outer || second < h || third < h) continue;
    result.triangles.push_back({labels_[origin(h)], labels_[target(h)], labels_[origin(third)]});
  }
  return result;
}

}  // namespace mwt
