#include "algorithms/exact/faces/face_solver.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "algorithms/exact/bounds/balanced_bound.h"
#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_traversal.h"
#include "algorithms/exact/faces/polygon_face.h"
#include "algorithms/exact/holes/cut_log.h"
#include "algorithms/exact/holes/region_solver.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/exact/usable_threads.h"
#include "algorithms/step_trace.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

struct SolvedPart : FacePart {
  FaceTriangles solved;
  std::uint64_t faces = 0;
  std::uint64_t max_face = 0;
};

class FaceSolver {
 public:
  FaceSolver(CandidateGraph graph, Context& context, const Deadline& bounds_deadline)
      : faces_(std::move(graph)),
        context_(context),
        bounds_deadline_(bounds_deadline),
        solvers_([this] { return PolygonFaceSolver(faces_.graph()); }) {
    if (context.progress) report_ = [&context](double done) { context.progress("faces", done); };
  }

  void solve_polygons();

  // Deletes what crosses certain edges among the candidates of faces that are no polygons, and tries those again.
  void repair();

  // Solves these faces and collects everything. Precondition: no open candidate crosses a certain edge.
  [[nodiscard]] FaceSolution finish();

 private:
  void solve_walk(const Walk& walk, SolvedPart& part);
  [[nodiscard]] RegionSolution solve(const FaceRegion& region, bool is_late) const;
  [[nodiscard]] double bound_before_repair() const;
  void solve_regions();
  void assemble(FaceSolution& solution);
  [[nodiscard]] Interval optimum() const;

  FaceTraversal<SolvedPart> faces_;
  Context& context_;
  Deadline bounds_deadline_;
  FaceProgress::Report report_;
  tbb::enumerable_thread_specific<PolygonFaceSolver> solvers_;
  std::vector<RegionSolution> regions_;
  mutable CutLog cuts_;
  std::size_t late_regions_ = 0;
};

void FaceSolver::solve_polygons() {
  faces_.run([this](const Walk& walk, SolvedPart& part) { solve_walk(walk, part); }, report_);
}

void FaceSolver::repair() {
  const auto crossing = find_crossing_candidates(faces_.graph(), faces_.open_candidates(), context_.deadline);
  if (!crossing) {
    throw SearchStopped(StopReason::deadline, "the deadline passed before the faces were known", bound_before_repair());
  }
  faces_.remove_candidates(*crossing, [this](const Walk& walk, SolvedPart& part) { solve_walk(walk, part); });
}

// Polygons that are solved, and what the others are bounded by, all at once: candidates may cross certain edges. At
// least the certain edges and as many of the shortest candidates as there must be others.
double FaceSolver::bound_before_repair() const {
  LengthSum certain, solved;
  std::vector<const Walk*> open;
  std::vector<Index> isolated;
  for (const SolvedPart& part : faces_.parts()) {
    certain.add(part.certain);
    solved.add(part.solved.diagonals);
    for (const auto* walks : {&part.composite_walks, &part.late_walks}) {
      for (const Walk& walk : *walks) open.push_back(&walk);
    }
    isolated.insert(isolated.end(), part.isolated.begin(), part.isolated.end());
  }
  const CandidateGraph& graph = faces_.graph();
  FaceRegion region = make_region(graph, open, isolated);
  const auto is_inside = [&](Index v) { return std::binary_search(region.vertices.begin(), region.vertices.end(), v); };
  std::erase_if(region.candidates, [&](const Edge& edge) { return !is_inside(edge.a) || !is_inside(edge.b); });
  const double others = next_down(solved.enclosure().lower + balanced_bound(graph.points, region, bounds_deadline_));
  const std::size_t edges = 3 * graph.points.size() - 3 - faces_.walker().outer_face_size();
  const std::size_t certain_edges = edges_marked(graph, 1).size();
  const Interval shortest = shortest_edges_length(graph.points, edges_marked(graph, 0), edges - certain_edges);
  return std::max(0.0, next_down(certain.enclosure().lower + std::max(others, shortest.lower)));
}

FaceSolution FaceSolver::finish() {
  FaceSolution solution;
  solve_regions();
  if (context_.steps != nullptr) context_.steps->cuts = cuts_.among(faces_.graph().points);
  assemble(solution);
  return solution;
}

void FaceSolver::solve_walk(const Walk& walk, SolvedPart& part) {
  if (is_triangle(walk)) {
    part.solved.triangles.push_back({walk[0].vertex, walk[1].vertex, walk[2].vertex});
    return;
  }
  part.max_face = std::max<std::uint64_t>(part.max_face, walk.size());
  switch (solvers_.local().solve(walk, context_.deadline, part.solved)) {
    case PolygonFaceOutcome::solved: ++part.faces; break;
    case PolygonFaceOutcome::not_a_polygon: part.composite_walks.push_back(walk); break;
    case PolygonFaceOutcome::no_triangulation:
      throw std::logic_error("candidate graph: a face has no triangulation by candidates");
    case PolygonFaceOutcome::out_of_time: part.late_walks.push_back(walk); break;
  }
}

void FaceSolver::solve_regions() {
  std::vector<FaceRegion> regions;
  for (const Walk& walk : faces_.take_late_walks()) regions.push_back(make_region(faces_.graph(), {&walk}, {}));
  late_regions_ = regions.size();
  for (FaceRegion& region : faces_.take_composite_faces()) regions.push_back(std::move(region));
  regions_.resize(regions.size());
  FaceProgress progress(report_, regions.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, regions.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          regions_[i] = solve(regions[i], i < late_regions_ || context_.deadline_passed());
          if (!regions_[i].is_feasible())
            throw std::logic_error("candidate graph: a face has no triangulation by candidates");
          progress.advance();
        }
      },
      tbb::simple_partitioner());
}

RegionSolution FaceSolver::solve(const FaceRegion& region, bool is_late) const {
  const Points points = faces_.graph().points;
  if (is_late) return leave_unsolved(points, region, StopReason::deadline, bounds_deadline_);
  RegionSearch search{context_.deadline};
  search.bounds_deadline = bounds_deadline_;
  if (context_.steps != nullptr) search.cuts = &cuts_;
  RegionSolution solution = solve_region(points, region, search);
  const bool is_open = !solution.solved && solution.is_feasible();
  if (is_open) {
    const double bound = balanced_bound(points, region, bounds_deadline_);
    solution.lower_bound = std::max(solution.lower_bound, std::min(bound, solution.diagonals.enclosure().upper));
  }
  return solution;
}

// Certain edges and polygons' diagonals are exact up to rounding; regions have lower bounds of their own. The upper end
// is the weight of the triangulation.
Interval FaceSolver::optimum() const {
  LengthSum exact;
  for (const SolvedPart& part : faces_.parts()) {
    exact.add(part.certain);
    exact.add(part.solved.diagonals);
  }
  if (regions_.empty()) return exact.enclosure();
  DoubleDouble lower = exact.enclosure().lower;
  for (const RegionSolution& region : regions_) {
    lower += region.lower_bound;
    exact.add(region.diagonals);
  }
  const double error = static_cast<double>(regions_.size() + 8) * kDoubleDoubleError;
  const Interval weight = exact.enclosure();
  return {std::min(enclose(lower, error).lower, weight.lower), weight.upper};
}

void FaceSolver::assemble(FaceSolution& solution) {
  solution.optimum = optimum();
  std::vector<SolvedPart>& parts = faces_.parts();
  std::vector<std::size_t> first{0};
  for (const SolvedPart& part : parts) {
    first.push_back(first.back() + part.solved.triangles.size());
    solution.faces += part.faces;
    solution.max_face = std::max(solution.max_face, part.max_face);
  }
  solution.triangles.resize(first.back());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    const auto& triangles = parts[i].solved.triangles;
    std::copy(triangles.begin(), triangles.end(), solution.triangles.begin() + static_cast<std::ptrdiff_t>(first[i]));
    parts[i] = {};
  });
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    const RegionSolution& region = regions_[i];
    solution.triangles.insert(solution.triangles.end(), region.triangles.begin(), region.triangles.end());
    solution.reductions += region.counters.reductions;
    solution.programs += region.counters.programs;
    solution.branchings += region.counters.branchings;
    solution.unsolved_faces += region.solved ? 0 : 1;
    solution.stop_reason = combined(solution.stop_reason, region.stop_reason);
  }
  solution.faces += regions_.size();
  solution.faces_with_holes = regions_.size() - late_regions_;
  for (const PolygonFaceSolver& solver : solvers_) {
    solution.dp_cells += solver.counters().cells;
    solution.precise_comparisons += solver.counters().precise_comparisons;
    solution.undecided_ties += solver.counters().undecided_ties;
  }
  solution.proved = solution.unsolved_faces == 0 && solution.optimum.relative_width() <= kProvedRelativeWidth;
}

}  // namespace

FaceSolution solve_faces(CandidateGraph graph, Context& context, const Deadline& bounds_deadline) {
  tbb::task_arena arena(usable_threads(context));
  return arena.execute([&] {
    FaceSolver solver(std::move(graph), context, bounds_deadline);
    solver.solve_polygons();
    solver.repair();
    return solver.finish();
  });
}

}  // namespace mwt
