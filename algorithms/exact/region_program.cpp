#include "algorithms/exact/region_program.h"

#include <algorithm>
#include <numeric>
#include <span>

#include "algorithms/exact/consistent_triangles.h"
#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using Deadline = std::optional<std::chrono::steady_clock::time_point>;

bool has_passed(const Deadline& deadline) { return deadline && std::chrono::steady_clock::now() >= *deadline; }

// The region's vertices numbered 0, 1, ... in lexicographic order of their points, and the directed edges that may be
// sides of triangles on their left.
struct LocalRegion {
  std::vector<Index> vertices;  // in the whole instance
  std::vector<Point> points;
  std::vector<Edge> boundary;
  std::vector<Edge> sides;         // sorted
  std::vector<std::size_t> first;  // sides of vertex v: [first[v], first[v + 1])

  [[nodiscard]] std::span<const Edge> sides_of(Index v) const {
    return std::span(sides).subspan(first[v], first[v + 1] - first[v]);
  }
  [[nodiscard]] bool has_side(const Edge& side) const {
    const auto star = sides_of(side.a);
    return std::binary_search(star.begin(), star.end(), side);
  }
};

LocalRegion localise(Points points, const FaceRegion& region) {
  LocalRegion local;
  local.vertices = region.vertices;
  std::sort(local.vertices.begin(), local.vertices.end(),
            [&](Index v, Index w) { return lexicographically_less(points[v], points[w]); });
  std::vector<Index> position(region.vertices.size());  // of the region's i-th vertex
  const auto rank = [&](Index v) {
    return static_cast<std::size_t>(std::lower_bound(region.vertices.begin(), region.vertices.end(), v) -
                                    region.vertices.begin());
  };
  for (Index i = 0; i < local.vertices.size(); ++i) {
    position[rank(local.vertices[i])] = i;
    local.points.push_back(points[local.vertices[i]]);
  }
  for (const Edge& edge : region.boundary) local.boundary.push_back({position[rank(edge.a)], position[rank(edge.b)]});
  local.sides = local.boundary;
  for (const Edge& edge : region.candidates) {
    const Index a = position[rank(edge.a)], b = position[rank(edge.b)];
    local.sides.insert(local.sides.end(), {{a, b}, {b, a}});
  }
  std::sort(local.sides.begin(), local.sides.end());
  local.first.assign(local.vertices.size() + 1, 0);
  for (const Edge& side : local.sides) ++local.first[side.a + 1];
  std::partial_sum(local.first.begin(), local.first.end(), local.first.begin());
  return local;
}

// Points are in lexicographic order, `triangle` begins with its smallest index.
bool is_empty(const std::vector<Point>& points, const Triangle& triangle) {
  const auto [a, b, c] = triangle;
  for (Index p = a + 1; p < std::max(b, c); ++p) {
    if (p != b && p != c && in_closed_triangle(points[p], points[a], points[b], points[c])) return false;
  }
  return true;
}

// Adds the triangles with smallest corner a.
void add_empty_triangles(const LocalRegion& local, Index a, std::vector<Triangle>& triangles) {
  const auto& points = local.points;
  for (const Edge& ab : local.sides_of(a)) {
    if (ab.b < a) continue;
    for (const Edge& bc : local.sides_of(ab.b)) {
      const Triangle triangle{a, ab.b, bc.b};
      const bool is_candidate = bc.b > a && orientation(points[a], points[ab.b], points[bc.b]) > 0 &&
                                local.has_side({bc.b, a}) && is_empty(points, triangle);
      if (is_candidate) triangles.push_back(triangle);
    }
  }
}

std::optional<std::vector<Triangle>> empty_triangles_of(const LocalRegion& local, std::size_t limit,
                                                        const Deadline& deadline) {
  std::vector<Triangle> triangles;
  for (Index a = 0; a < local.vertices.size(); ++a) {
    add_empty_triangles(local, a, triangles);
    if (triangles.size() > limit || has_passed(deadline)) return {};
  }
  return triangles;
}

std::vector<Triangle> in_instance(const LocalRegion& local, const std::vector<Triangle>& triangles) {
  std::vector<Triangle> result;
  for (const auto& [a, b, c] : triangles) result.push_back({local.vertices[a], local.vertices[b], local.vertices[c]});
  return result;
}

Interval boundary_length(Points points, const FaceRegion& region) {
  std::vector<Edge> edges;
  for (const Edge& edge : region.boundary) edges.push_back(make_edge(edge.a, edge.b));
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

}  // namespace

RegionSolution leave_unsolved(Points points, const FaceRegion& region) {
  RegionSolution result;
  result.triangles = fill_region(points, region);
  result.diagonals = diagonals_length(points, region, result.triangles);
  result.lower_bound = lower_bound_of_diagonals(points, region);
  return result;
}

RegionSolution solve_region(Points points, const FaceRegion& region, const Deadline& deadline) {
  const LocalRegion local = localise(points, region);
  const auto triangles = empty_triangles_of(local, kMaximumProgramTriangles, deadline);
  if (!triangles) return leave_unsolved(points, region);
  const std::vector<Triangle> consistent = consistent_triangles(local.points, *triangles, local.boundary);
  const TriangleCover cover =
      lightest_triangle_cover({local.points, consistent, local.boundary, region.triangle_count(), deadline});
  RegionSolution result;
  result.triangles = cover.triangles.empty() ? fill_region(points, region) : in_instance(local, cover.triangles);
  result.diagonals = diagonals_length(points, region, result.triangles);
  const double lower_bound = next_down(cover.optimum.lower - boundary_length(points, region).upper);
  result.lower_bound = std::max(lower_bound, lower_bound_of_diagonals(points, region));
  result.solved = cover.proved;
  result.programs = cover.programs;
  result.branchings = cover.branchings;
  return result;
}

}  // namespace mwt
