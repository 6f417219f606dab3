#include "algorithms/exact/region_program.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

#include "algorithms/exact/consistent_triangles.h"
#include "algorithms/exact/cut_region.h"
#include "algorithms/exact/region_triangles.h"
#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using Deadline = std::optional<std::chrono::steady_clock::time_point>;

// The region's vertices numbered 0, 1, ... in lexicographic order of their points, and the directed edges that may be
// sides of triangles on their left.
struct LocalRegion {
  std::vector<Index> vertices;  // in the whole instance
  std::vector<Point> points;
  std::vector<Edge> boundary;
  std::vector<Edge> sides;
};

LocalRegion localise(Points points, const FaceRegion& region) {
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

namespace {

// With two boundary components: every triangulation contains one of a few cuts, and with each cut the region is a
// polygon. Nothing if that does not decide it.
std::optional<RegionSolution> solve_by_cutting(Points points, const FaceRegion& region, const Deadline& deadline) {
  CutRegion cutter(points, region);
  std::optional<RegionSolution> best;
  double lower_bound = std::numeric_limits<double>::infinity();
  for (const Edge& cut : cutter.unavoidable_cuts()) {
    FaceTriangles found;
    const PolygonFaceOutcome outcome = cutter.solve(std::span(&cut, 1), deadline, found);
    if (outcome == PolygonFaceOutcome::no_triangulation) continue;
    if (outcome == PolygonFaceOutcome::out_of_time && best) {
      best->lower_bound = lower_bound_of_diagonals(points, region);
      return best;
    }
    if (outcome != PolygonFaceOutcome::solved) return {};
    const Interval weight = found.diagonals.enclosure();
    lower_bound = std::min(lower_bound, weight.lower);
    if (best && best->diagonals.enclosure().upper <= weight.upper) continue;
    best.emplace();
    best->triangles = std::move(found.triangles);
    best->diagonals = found.diagonals;
  }
  if (!best) return {};
  best->lower_bound = lower_bound;
  best->solved = true;
  return best;
}

RegionSolution solve_by_program(Points points, const FaceRegion& region, const Deadline& deadline) {
  const LocalRegion local = localise(points, region);
  const auto triangles = region_triangles(local.points, local.sides, kMaximumProgramTriangles, deadline);
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

}  // namespace

RegionSolution solve_region(Points points, const FaceRegion& region, const Deadline& deadline) {
  if (region.components == 2) {
    if (const auto solution = solve_by_cutting(points, region, deadline)) return *solution;
  }
  return solve_by_program(points, region, deadline);
}

}  // namespace mwt
