#include "algorithms/exact/division/beta_skeleton.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "algorithms/common/beta_skeleton_edges.h"
#include "geometry/mesh/angle.h"
#include "geometry/mesh/planar_mesh.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

double squared_distance(const Box& box, const Point& p) {
  const double dx = std::max({box.min_x - p.x, p.x - box.max_x, 0.0});
  const double dy = std::max({box.min_y - p.y, p.y - box.max_y, 0.0});
  return dx * dx + dy * dy;
}

// Whether surely no point sees the edge between points a and b at a wide angle.
bool is_surely_in_beta_skeleton(const KdOrder& order, Index a, Index b) {
  const Point& p = order.points[a];
  const Point& q = order.points[b];
  const double square = squared_distance({q.x, q.y, q.x, q.y}, p);
  if (!is_trusted_product(square)) return false;
  const double reach = kMaxDistanceOfWitness * kMaxDistanceOfWitness * square;
  std::uint32_t stack[64] = {1};  // a path in the tree and its siblings
  std::size_t height = 1;
  while (height > 0) {
    const std::uint32_t node = stack[--height];
    const Box& box = order.boxes[node];
    if (squared_distance(box, p) > reach || squared_distance(box, q) > reach) continue;
    if (!order.is_leaf(node)) {
      stack[height++] = 2 * node + 1;
      stack[height++] = 2 * node;
      continue;
    }
    for (Index w = order.first_of(node); w < order.last_of(node); ++w) {
      if (w == a || w == b) continue;
      const Angle angle = angle_at(order.points[w], p, q);
      if (!is_surely_small({angle.real, std::abs(angle.imaginary)})) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Edge> beta_skeleton(Points points) {
  PlanarMesh delaunay = PlanarMesh::delaunay(points);
  mark_beta_skeleton(delaunay);
  std::vector<Edge> edges;
  for (MeshEdge e = 0; e < delaunay.edge_count(); ++e) {
    if ((delaunay.marks(e) & kBetaSkeletonMark) != 0) edges.push_back(delaunay.labelled_edge(e));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// An edge of the beta-skeleton of all points is one of the skeleton of any of them.
std::vector<Edge> beta_skeleton_between(const KdOrder& order, std::span<const Index> vertices) {
  std::vector<Point> points;
  points.reserve(vertices.size());
  for (const Index v : vertices) points.push_back(order.points[v]);
  std::vector<Edge> edges = beta_skeleton(points);
  std::vector<std::uint8_t> is_sure(edges.size());
  tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
    edges[i] = {vertices[edges[i].a], vertices[edges[i].b]};
    is_sure[i] = is_surely_in_beta_skeleton(order, edges[i].a, edges[i].b) ? 1 : 0;
  });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (is_sure[i] != 0) edges[kept++] = edges[i];
  }
  edges.resize(kept);
  return edges;
}

}  // namespace mwt
