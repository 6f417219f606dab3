#include "geometry/delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/cpu_clock.h"
#include "base/error.h"
#include "geometry/convex_hull.h"

namespace mwt {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;
using ConstrainedDelaunay = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Vertex, CGAL::Constrained_triangulation_face_base_2<Kernel>>,
    CGAL::No_constraint_intersection_tag>;

std::vector<Kernel::Point_2> to_cgal(Points points) {
  std::vector<Kernel::Point_2> result;
  result.reserve(points.size());
  for (const Point& p : points) result.emplace_back(p.x, p.y);
  return result;
}

void require_a_triangle(Points points) {
  if (all_collinear(points)) throw InputError("all points lie on one line: there is nothing to triangulate");
}

// Inserts all points in spatial order, remembering each one's index; returns the vertex of every point.
template <class AnyTriangulation>
std::vector<typename AnyTriangulation::Vertex_handle> insert_in_spatial_order(AnyTriangulation& triangulation,
                                                                              Points points) {
  using IndexedPoint = std::pair<Kernel::Point_2, Index>;
  using Position = CGAL::First_of_pair_property_map<IndexedPoint>;
  std::vector<IndexedPoint> order;
  order.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) order.push_back({{points[i].x, points[i].y}, i});
  CGAL::spatial_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, Position>());
  std::vector<typename AnyTriangulation::Vertex_handle> vertices(points.size());
  typename AnyTriangulation::Face_handle hint;
  for (const auto& [point, index] : order) {
    vertices[index] = triangulation.insert(point, hint);
    vertices[index]->info() = index;
    hint = vertices[index]->face();
  }
  return vertices;
}

template <class AnyTriangulation>
Triangulation triangles_of(const AnyTriangulation& triangulation, std::size_t point_count) {
  Triangulation result;
  result.point_count = static_cast<Index>(point_count);
  result.triangles.reserve(triangulation.number_of_faces());
  for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
    result.triangles.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
  }
  return result;
}

// CGAL splits a constraint at a point that it passes through, without a word.
void require_edges(const Triangulation& triangulation, std::span<const Edge> constraints) {
  const std::vector<Edge> edges = edges_of(triangulation);
  for (const Edge& edge : constraints) {
    if (!std::binary_search(edges.begin(), edges.end(), make_edge(edge.a, edge.b))) {
      throw std::logic_error("constrained_delaunay_triangulation: a constraint passes through a point");
    }
  }
}

}  // namespace

Triangulation delaunay_triangulation(Points points) {
  require_a_triangle(points);
  Delaunay triangulation;
  insert_in_spatial_order(triangulation, points);
  return triangles_of(triangulation, points.size());
}

Triangulation constrained_delaunay_triangulation(Points points, std::span<const Edge> constraints) {
  require_a_triangle(points);
  ConstrainedDelaunay triangulation;
  const auto vertices = insert_in_spatial_order(triangulation, points);
  try {
    for (const Edge& edge : constraints) triangulation.insert_constraint(vertices[edge.a], vertices[edge.b]);
  } catch (const ConstrainedDelaunay::Intersection_of_constraints_exception&) {
    throw std::logic_error("constrained_delaunay_triangulation: two constraints cross");
  }
  Triangulation result = triangles_of(triangulation, points.size());
  require_edges(result, constraints);
  return result;
}

double time_delaunay_once_s(Points points) {
  const std::vector<Kernel::Point_2> cgal_points = to_cgal(points);
  const double start = process_cpu_time_s();
  const CGAL::Delaunay_triangulation_2<Kernel> triangulation(cgal_points.begin(), cgal_points.end());
  const double time = process_cpu_time_s() - start;
  if (triangulation.dimension() < 0) throw std::logic_error("the Delaunay time needs points");
  return time;
}

double measure_delaunay_time_s(Points points) {
  constexpr double kReadable = 1e-3;  // the clock may tick in microseconds
  double total = 0;
  int repetitions = 0;
  for (; total < kReadable; ++repetitions) total += time_delaunay_once_s(points);
  return total / repetitions;
}

}  // namespace mwt
