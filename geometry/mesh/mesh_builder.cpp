#include "geometry/mesh/mesh_builder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "geometry/mesh/spatial_order.h"
#include "geometry/numbers/scaling.h"

namespace mwt {

namespace {

constexpr std::uint32_t kNumbered = std::uint32_t{1} << 31;  // in place of a twin: the halfedge's number follows

}  // namespace

MeshBuilder::MeshBuilder(Points points) {
  mesh_.labels_ = spatial_order(points);
  mesh_.points_.reserve(points.size() + 1);  // and the point at infinity
  const int scale = exact_scale(points);
  mesh_.unit_ = std::scalbn(1.0, scale);
  for (const Index i : mesh_.labels_) {
    mesh_.points_.push_back(scale == 0 ? points[i] : scaled_down(points[i], scale));
  }
}

PlanarMesh MeshBuilder::delaunay() { return build(delaunay_triangles(mesh_.points_)); }

PlanarMesh MeshBuilder::given(const Triangulation& triangulation) { return build(linked(triangulation)); }

// The triangles in the mesh's numbering with their twins, and a ghost beyond every hull edge.
KeptVector<LinkedTriangle> MeshBuilder::linked(const Triangulation& triangulation) const {
  const auto ghost = static_cast<Index>(mesh_.points_.size());
  std::vector<Index> renumbered(ghost);
  for (Index v = 0; v < ghost; ++v) renumbered[mesh_.labels_[v]] = v;
  const std::vector<std::array<Index, 3>> adjacent = adjacency_of(triangulation);
  KeptVector<LinkedTriangle> result;
  result.reserve(2 * mesh_.points_.size());
  for (const auto& [a, b, c] : triangulation.triangles) {
    result.push_back({{renumbered[a], renumbered[b], renumbered[c]}, {}});
  }
  for (std::uint32_t t = 0; t < adjacent.size(); ++t) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      const std::uint32_t neighbour = adjacent[t][(i + 2) % 3];  // adjacency names the corner opposite a side
      if (neighbour == kNoIndex) {
        result[t].twins[i] = 4 * static_cast<Side>(result.size());
        result.push_back({{result[t].corners[(i + 1) % 3], result[t].corners[i], ghost}, {4 * t + i, 0, 0}});
        continue;
      }
      const auto& corners = result[neighbour].corners;
      const auto place = std::find(corners.begin(), corners.end(), result[t].corners[(i + 1) % 3]) - corners.begin();
      result[t].twins[i] = 4 * neighbour + static_cast<Side>(place);
    }
  }
  return result;
}

PlanarMesh MeshBuilder::build(KeptVector<LinkedTriangle> triangles) {
  if (mesh_.points_.size() >= std::size_t{1} << 28) throw std::length_error("PlanarMesh: at most 2^28 points");
  triangles_ = std::move(triangles);
  order_triangles();
  add_edges();
  link_outer_face();
  return std::move(mesh_);
}

void MeshBuilder::order_triangles() {
  const std::size_t point_count = mesh_.points_.size();
  KeptVector<std::uint32_t> place(point_count + 1, 0);
  const auto first_point = [](const LinkedTriangle& t) {
    return std::min(t.corners[0], std::min(t.corners[1], t.corners[2]));
  };
  const auto is_real = [&](const LinkedTriangle& t) {
    return std::max(t.corners[0], std::max(t.corners[1], t.corners[2])) < point_count;
  };
  for (const LinkedTriangle& t : triangles_) place[first_point(t) + 1] += is_real(t) ? 1 : 0;
  for (std::size_t v = 1; v <= point_count; ++v) place[v] += place[v - 1];
  order_.resize(place[point_count]);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (is_real(triangles_[t])) order_[place[first_point(triangles_[t])]++] = t;
  }
}

// Numbers the edges as the triangles come to them, and puts the halfedge's number in place of each twin. Real
// triangles come first to a hull edge, so that its side 1 is the outer one.
void MeshBuilder::add_edges() {
  mesh_.edges_.resize(mesh_.points_.size() + order_.size() - 1);  // Euler's formula
  Halfedge count = 0;
  for (const std::uint32_t t : order_) {
    LinkedTriangle& triangle = triangles_[t];
    std::array<Halfedge, 3> sides;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const Side beyond = triangle.twins[i];
      sides[i] = beyond & ~kNumbered;
      if ((beyond & kNumbered) != 0) continue;
      sides[i] = count;
      mesh_.set_edge(edge_of(count), triangle.corners[i], triangle.corners[i == 2 ? 0 : i + 1]);
      LinkedTriangle& neighbour = triangles_[beyond >> 2];
      neighbour.twins[beyond & 3] = kNumbered | twin(count);
      const bool hull = neighbour.corners[((beyond & 3) + 2) % 3] == mesh_.points_.size();
      if (hull) outer_.push_back(twin(count));
      count += 2;
    }
    mesh_.link_triangle(sides[0], sides[1], sides[2]);
  }
}

void MeshBuilder::link_outer_face() {
  std::vector<Halfedge> by_origin(mesh_.points_.size());
  for (const Halfedge h : outer_) {
    mesh_.edges_[edge_of(h)].marks = kHullMark;
    by_origin[mesh_.origin(h)] = h;
  }
  for (const Halfedge h : outer_) {
    const Halfedge following = by_origin[mesh_.target(h)];
    mesh_.edges_[edge_of(h)].next[h & 1] = following;
    mesh_.edges_[edge_of(following)].previous[following & 1] = h;
  }
}

}  // namespace mwt
