#include "algorithms/exact/faces/region_solver.h"

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <utility>

#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/certain_sides.h"
#include "algorithms/exact/faces/consistent_triangles.h"
#include "algorithms/exact/faces/cut_region.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/local_region.h"
#include "algorithms/exact/faces/polygon_face.h"
#include "algorithms/exact/faces/region_triangles.h"
#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

Interval boundary_length(Points points, const FaceRegion& region) {
  LengthSum sum;
  for (const Edge& edge : undirected_edges(region.boundary)) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

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
      best->stop_reason = StopReason::deadline;
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

RegionSolution solve_by_program(Points points, const FaceRegion& region, const LocalRegion& local,
                                const std::vector<Triangle>& triangles, const Deadline& deadline) {
  const TriangleCover cover =
      lightest_triangle_cover({local.points, triangles, local.boundary, region.triangle_count(), deadline});
  RegionSolution result;
  result.triangles = cover.triangles.empty() ? fill_region(points, region) : local.in_instance(cover.triangles);
  result.diagonals = diagonals_length(points, region, result.triangles);
  const double lower_bound = next_down(cover.optimum.lower - boundary_length(points, region).upper);
  result.lower_bound = std::max(lower_bound, lower_bound_of_diagonals(points, region));
  result.solved = cover.proved;
  result.stop_reason = cover.stop_reason;
  result.programs = cover.programs;
  result.branchings = cover.branchings;
  return result;
}

// A region whose candidates are the sides of given triangles, divided along those that are certain.
class DividedRegion {
 public:
  DividedRegion(const LocalRegion& local, std::span<const Triangle> triangles, const Deadline& deadline)
      : boundary_(local.boundary),
        deadline_(deadline),
        graph_(graph_of_sides(local.points, triangles, local.boundary)),
        polygons_(graph_) {
    std::sort(boundary_.begin(), boundary_.end());
    result_.solved = true;
  }

  // Nothing if no edge divides it or the deadline passes at once.
  std::optional<RegionSolution> solve() {
    if (!collect_dividing_edges() || !remove_crossing_sides()) return {};
    solve_polygons();
    for (const FaceRegion& region : group_into_regions(graph_, FaceWalker(graph_), composite_, isolated_)) {
      add(solve_region(graph_.points, region, deadline_));
    }
    result_.diagonals.add(exact_);
    result_.lower_bound = next_down(result_.lower_bound + exact_.enclosure().lower);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool on_boundary(const Edge& directed) const {
    return std::binary_search(boundary_.begin(), boundary_.end(), directed);
  }

  // Left of the halfedge: left of the boundary or on both sides of every other edge.
  [[nodiscard]] bool is_inside(const Edge& directed) const {
    return on_boundary(directed) || !on_boundary({directed.b, directed.a});
  }

  template <class Visit>  // visit(v, halfedge)
  void for_each_halfedge(Visit visit) const {
    for (Index v = 0; v < graph_.points.size(); ++v) {
      for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + std::size_t{1}]; ++h) visit(v, h);
    }
  }

  // Whether there are any. They are diagonals of the solution.
  bool collect_dividing_edges() {
    bool divides = false;
    for_each_halfedge([&](Index v, std::uint32_t h) {
      const Edge edge{v, graph_.target[h]};
      const bool is_inner = !on_boundary(edge) && !on_boundary({edge.b, edge.a});
      if (graph_.certain[h] == 0 || edge.a > edge.b || !is_inner) return;
      exact_.add(graph_.points[edge.a], graph_.points[edge.b]);
      divides = true;
    });
    return divides;
  }

  // Whether the deadline allowed it. Triangles with sides that cross a certain edge are none of a triangulation.
  bool remove_crossing_sides() {
    std::vector<Edge> uncertain;
    for_each_halfedge([&](Index v, std::uint32_t h) {
      if (graph_.certain[h] == 0 && v < graph_.target[h]) uncertain.push_back({v, graph_.target[h]});
    });
    const auto crossing = find_crossing_candidates(graph_, uncertain, deadline_);
    if (crossing) remove_edges(graph_, *crossing);
    return crossing.has_value();
  }

  void solve_polygons() {
    const FaceWalker walker(graph_);
    std::vector<bool> has_certain_edge(graph_.points.size());
    std::vector<bool> is_walked(graph_.target.size());
    for_each_halfedge([&](Index v, std::uint32_t h) {
      if (graph_.certain[h] == 0) return;
      has_certain_edge[v] = true;
      if (is_walked[h] || !is_inside({v, graph_.target[h]})) return;
      const Walk walk = walker.corners_of_face(v, h);
      for (const Corner& corner : walk) is_walked[corner.halfedge] = true;
      solve_walk(walk);
    });
    for (Index v = 0; v < graph_.points.size(); ++v) {
      if (!has_certain_edge[v]) isolated_.push_back(v);
    }
  }

  void solve_walk(const Walk& walk) {
    FaceTriangles found;
    switch (polygons_.solve(walk, deadline_, found)) {
      case PolygonFaceOutcome::solved:
        exact_.add(found.diagonals);
        result_.triangles.insert(result_.triangles.end(), found.triangles.begin(), found.triangles.end());
        break;
      case PolygonFaceOutcome::not_a_polygon: composite_.push_back(walk); break;
      case PolygonFaceOutcome::out_of_time:
        add(leave_unsolved(graph_.points, make_region(graph_, {&walk}, {}), StopReason::deadline));
        break;
      case PolygonFaceOutcome::no_triangulation:
        throw std::logic_error("face region: a part has no triangulation by consistent triangles");
    }
  }

  void add(const RegionSolution& part) {
    result_.triangles.insert(result_.triangles.end(), part.triangles.begin(), part.triangles.end());
    result_.diagonals.add(part.diagonals);
    result_.lower_bound = next_down(result_.lower_bound + part.lower_bound);
    result_.solved = result_.solved && part.solved;
    result_.stop_reason = combined(result_.stop_reason, part.stop_reason);
    result_.programs += part.programs;
    result_.branchings += part.branchings;
  }

  std::vector<Edge> boundary_;  // sorted
  const Deadline& deadline_;
  CandidateGraph graph_;
  PolygonFaceSolver polygons_;
  LengthSum exact_;  // of the dividing edges and the polygons' diagonals
  std::vector<Walk> composite_;
  std::vector<Index> isolated_;
  RegionSolution result_;
};

}  // namespace

RegionSolution leave_unsolved(Points points, const FaceRegion& region, StopReason reason) {
  RegionSolution result;
  result.triangles = fill_region(points, region);
  result.diagonals = diagonals_length(points, region, result.triangles);
  result.lower_bound = lower_bound_of_diagonals(points, region);
  result.stop_reason = reason;
  return result;
}

RegionSolution solve_region(Points points, const FaceRegion& region, const Deadline& deadline) {
  if (region.components == 2) {
    if (const auto solution = solve_by_cutting(points, region, deadline)) return *solution;
  }
  const LocalRegion local = make_local(points, region);
  const auto triangles = region_triangles(local.points, local.sides, kMaximumProgramTriangles, deadline);
  if (!triangles) {
    return leave_unsolved(points, region, has_passed(deadline) ? StopReason::deadline : StopReason::size);
  }
  const std::vector<Triangle> consistent = consistent_triangles(local.points, *triangles, local.boundary);
  if (auto solution = DividedRegion(local, consistent, deadline).solve()) {
    solution->triangles = local.in_instance(std::move(solution->triangles));
    return *std::move(solution);
  }
  return solve_by_program(points, region, local, consistent, deadline);
}

}  // namespace mwt
