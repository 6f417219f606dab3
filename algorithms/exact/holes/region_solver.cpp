#include "algorithms/exact/holes/region_solver.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "algorithms/exact/bounds/balanced_bound.h"
#include "algorithms/exact/bounds/side_bound.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/polygon_face.h"
#include "algorithms/exact/holes/annulus_face.h"
#include "algorithms/exact/holes/certain_sides.h"
#include "algorithms/exact/holes/consistent_triangles.h"
#include "algorithms/exact/holes/cut_log.h"
#include "algorithms/exact/holes/divided_region.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/exact/holes/region_branching.h"
#include "algorithms/exact/holes/region_reduction.h"
#include "algorithms/exact/holes/region_triangles.h"
#include "algorithms/exact/holes/uncrossed_edges.h"
#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// Regions with more empty triangles are branched on first; the linear program comes later.
constexpr std::size_t kMaxProgramTriangles = 20'000;

// Fewer candidates by this factor are worth cutting the region open again.
constexpr double kWorthCuttingAgain = 0.9;

double simple_bound(Points points, const FaceRegion& region) {
  return std::max(lower_bound_of_diagonals(points, region), bound_by_sides(points, region));
}

Interval boundary_length(Points points, const FaceRegion& region) {
  LengthSum sum;
  for (const Edge& edge : undirected_edges(region.boundary)) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

class RegionSolver {
 public:
  RegionSolver(Points points, const FaceRegion& region, const RegionSearch& search)
      : points_(points), region_(region), search_(search) {}

  RegionSolution run() {
    if (region_.components == 1) return solve_polygon();
    if (has_passed(search_.deadline)) return left_unsolved(StopReason::deadline);
    if (region_.components == 2 && search_.methods.annuli) {
      if (auto solution = solve_with_one_hole()) return *std::move(solution);
    }
    if (search_.methods.reductions) {
      if (auto solution = solve_by_reduction()) return *std::move(solution);
    }
    if (auto solution = solve_by_triangles()) return *std::move(solution);
    return branch();
  }

 private:
  RegionSolution solve_polygon() {
    const LocalRegion local = make_local(points_, region_);
    const CandidateGraph graph =
        make_candidate_graph(local.points, undirected_edges(local.sides), undirected_edges(local.boundary));
    const FaceWalker walker(graph);
    const Walk walk = walker.corners_of_face(local.boundary.front());
    RegionSolution result;
    if (walk.size() == 3 && region_.triangle_count() == 1) {
      result.triangles = local.in_instance({{walk[0].vertex, walk[1].vertex, walk[2].vertex}});
      result.solved = true;
      return result;
    }
    FaceTriangles found;
    switch (PolygonFaceSolver(graph).solve(walk, search_.deadline, found)) {
      case PolygonFaceOutcome::solved:
        result.triangles = local.in_instance(std::move(found.triangles));
        result.diagonals = found.diagonals;
        result.lower_bound = found.diagonals.enclosure().lower;
        result.solved = true;
        return result;
      case PolygonFaceOutcome::no_triangulation: return RegionSolution::infeasible();
      case PolygonFaceOutcome::out_of_time: return left_unsolved(StopReason::deadline);
      case PolygonFaceOutcome::not_a_polygon: break;
    }
    auto by_triangles = solve_by_triangles();
    return by_triangles ? *std::move(by_triangles) : left_unsolved(StopReason::size);
  }

  std::optional<RegionSolution> solve_with_one_hole() {
    std::optional<AnnulusSolution> annulus = solve_annulus(points_, region_, search_.limit, search_.deadline);
    if (!annulus) return {};
    RegionSolution result;
    result.triangles = std::move(annulus->triangles);
    result.diagonals = annulus->diagonals;
    result.lower_bound = annulus->lower_bound;
    result.solved = !annulus->is_late;
    if (annulus->is_late) {
      result.lower_bound = std::max({result.lower_bound, simple_bound(points_, region_),
                                     balanced_bound(points_, region_, search_.bounds_deadline)});
      result.stop_reason = StopReason::deadline;
      if (result.triangles.empty()) fill(result);
    }
    return result;
  }

  void fill(RegionSolution& result) const {
    result.triangles = fill_region(points_, region_);
    result.diagonals = diagonals_length(points_, region_, result.triangles);
  }

  [[nodiscard]] RegionSolution left_unsolved(StopReason reason) const {
    return leave_unsolved(points_, region_, reason, search_.bounds_deadline);
  }

  // Nothing if the region stays as it is; then a bound is kept.
  std::optional<RegionSolution> solve_by_reduction() {
    auto reduced = reduce_region(points_, region_, search_.limit, search_.deadline);
    if (!reduced) return {};
    if (search_.cuts != nullptr) search_.cuts->note(points_, region_);
    best_.triangles = std::move(reduced->triangles);
    best_.diagonals = reduced->diagonals;
    best_.lower_bound = reduced->lower_bound;
    best_.counters.reductions = 1;
    if (reduced->is_closed()) {
      best_.solved = true;
      return std::move(best_);
    }
    best_.stop_reason = StopReason::deadline;  // unless what follows solves it
    if (has_passed(search_.deadline)) return std::move(best_);
    std::optional<RegionSolution> rest = solve_reduced(*reduced);
    if (!rest) return {};
    return better_of(*std::move(rest), reduced->reach);
  }

  // The known triangulation or what was found among those of at most length `reach`.
  RegionSolution better_of(RegionSolution rest, double reach) {
    best_.counters.add(rest.counters);
    best_.lower_bound = std::max(best_.lower_bound, std::min(rest.lower_bound, reach));
    best_.solved = rest.solved || rest.lower_bound >= reach;
    best_.stop_reason = best_.solved ? std::nullopt : rest.stop_reason;
    const bool is_better =
        !rest.triangles.empty() && rest.diagonals.enclosure().upper < best_.diagonals.enclosure().upper;
    if (is_better) {
      best_.triangles = std::move(rest.triangles);
      best_.diagonals = rest.diagonals;
    }
    best_.lower_bound = std::min(best_.lower_bound, best_.diagonals.enclosure().upper);
    return std::move(best_);
  }

  std::optional<RegionSolution> solve_reduced(const ReducedRegion& reduced) {
    RegionSearch search = search_;
    search.limit = next_up(reduced.reach);
    if (auto divided = divide(reduced, search)) return divided;
    const bool is_smaller = static_cast<double>(reduced.candidates.size()) <
                            kWorthCuttingAgain * static_cast<double>(region_.candidates.size());
    if (!is_smaller) return {};
    FaceRegion smaller = region_;
    smaller.candidates = reduced.candidates;
    return solve_region(points_, smaller, search);
  }

  // Along the certain ones and those that no other candidate crosses.
  std::optional<RegionSolution> divide(const ReducedRegion& reduced, const RegionSearch& search) {
    const std::vector<Point> own = region_.points_among(points_);
    const std::vector<Edge> boundary = region_.in_places(region_.boundary);
    std::vector<Edge> certain = undirected_edges(boundary);
    std::vector<Edge> edges = region_.in_places(reduced.candidates);
    edges.insert(edges.end(), certain.begin(), certain.end());
    for (const Edge& edge : region_.in_places(reduced.certain)) certain.push_back(edge);
    std::sort(certain.begin(), certain.end());
    CandidateGraph graph = make_candidate_graph(own, undirected_edges(std::move(edges)), certain);
    if (mark_uncrossed_edges(graph) == 0 && reduced.certain.empty()) return {};
    auto solution = solve_divided_region(std::move(graph), boundary, search);
    if (!solution) return {};
    for (Triangle& triangle : solution->triangles) {
      for (Index& corner : triangle) corner = region_.vertices[corner];
    }
    return solution;
  }

  // Where they are few: divided along the sides that all consistent triangles leave uncrossed, or by a linear program.
  std::optional<RegionSolution> solve_by_triangles() {
    if (!search_.methods.programs || region_.candidates.size() > kMaxProgramTriangles) return {};
    const LocalRegion local = make_local(points_, region_);
    const auto triangles = region_triangles(local.points, local.sides, kMaxProgramTriangles, search_.deadline);
    if (!triangles) return {};
    const std::vector<Triangle> consistent = consistent_triangles(local.points, *triangles, local.boundary);
    if (consistent.size() < region_.triangle_count()) return RegionSolution::infeasible();
    auto solution =
        solve_divided_region(graph_of_sides(local.points, consistent, local.boundary), local.boundary, search_);
    if (solution) {
      solution->triangles = local.in_instance(std::move(solution->triangles));
      return with_known_bound(*std::move(solution));
    }
    return with_known_bound(solve_by_program(local, consistent));
  }

  RegionSolution solve_by_program(const LocalRegion& local, const std::vector<Triangle>& triangles) {
    const TriangleCover cover =
        lightest_triangle_cover({local.points, triangles, local.boundary, region_.triangle_count(), search_.deadline});
    RegionSolution result;
    result.counters.programs = cover.programs;
    result.counters.branchings = cover.branchings;
    result.triangles = cover.triangles.empty() ? fill_region(points_, region_) : local.in_instance(cover.triangles);
    result.diagonals = diagonals_length(points_, region_, result.triangles);
    const double lower_bound = next_down(cover.optimum.lower - boundary_length(points_, region_).upper);
    result.lower_bound = std::max(lower_bound, simple_bound(points_, region_));
    result.solved = cover.proved;
    result.stop_reason = cover.stop_reason;
    return result;
  }

  // Together with what the reduction found.
  RegionSolution with_known_bound(RegionSolution solution) {
    if (best_.triangles.empty()) return solution;
    return better_of(std::move(solution), std::numeric_limits<double>::infinity());
  }

  RegionSolution branch() {
    if (has_passed(search_.deadline))
      return best_.triangles.empty() ? left_unsolved(StopReason::deadline) : std::move(best_);
    RegionSearch search = search_;
    if (!best_.triangles.empty()) search.limit = std::min(search.limit, best_.diagonals.enclosure().upper);
    return with_known_bound(solve_by_branching(points_, region_, search));
  }

  Points points_;
  const FaceRegion& region_;
  const RegionSearch& search_;
  RegionSolution best_;  // of the reduction
};

}  // namespace

RegionSolution leave_unsolved(Points points, const FaceRegion& region, StopReason reason,
                              const Deadline& bounds_deadline) {
  RegionSolution result;
  result.triangles = fill_region(points, region);
  result.diagonals = diagonals_length(points, region, result.triangles);
  result.lower_bound = std::max(simple_bound(points, region), balanced_bound(points, region, bounds_deadline));
  result.stop_reason = reason;
  return result;
}

RegionSolution solve_region(Points points, const FaceRegion& region, const RegionSearch& search) {
  return RegionSolver(points, region, search).run();
}

}  // namespace mwt
