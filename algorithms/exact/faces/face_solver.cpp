#include "algorithms/exact/faces/face_solver.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <iterator>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/polygon_face.h"
#include "algorithms/exact/holes/region_solver.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/exact/usable_threads.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// Vertices per parallel task.
constexpr std::size_t kBlock = 4096;

// Longer walks are collected one after the other, so that none is walked from each of its vertices.
constexpr std::size_t kLongWalk = 64;

// What one task found: in a fixed order, whatever thread ran it.
struct Part {
  FaceTriangles solved;
  LengthSum certain;
  std::vector<Corner> long_walks;     // where walks longer than kLongWalk may start
  std::vector<Walk> composite_walks;  // parts of the boundaries of faces with holes or isolated vertices
  std::vector<Walk> late_walks;       // polygons that the deadline left
  std::vector<Index> isolated;
  std::uint64_t faces = 0;
  std::uint64_t max_face = 0;
};

// Calls progress(done) now and then, from one thread at a time.
class Progress {
 public:
  Progress(Context& context, std::size_t total) : context_(context), total_(total) {}

  void advance() {
    if (!context_.progress) return;
    const std::lock_guard lock(mutex_);
    ++done_;
    const bool is_due = done_ * 50 / total_ != (done_ - 1) * 50 / total_;
    if (is_due) context_.progress("faces", static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  Context& context_;
  std::size_t total_;
  std::size_t done_ = 0;
  std::mutex mutex_;
};

class FaceSolver {
 public:
  FaceSolver(CandidateGraph graph, Context& context)
      : graph_(std::move(graph)),
        context_(context),
        walker_(graph_),
        solvers_([this] { return PolygonFaceSolver(graph_); }) {}

  void solve_polygons();

  // Deletes what crosses certain edges among the candidates of faces that are no polygons, and tries those again.
  void repair();

  // Solves these faces and collects everything. Precondition: no open candidate crosses a certain edge.
  [[nodiscard]] FaceSolution finish();

 private:
  void solve_blocks();
  void solve_block(Index begin, Index end, Part& part);
  void solve_long_walks();
  [[nodiscard]] std::vector<Walk> collect_long_walks() const;
  void solve_walk(const Walk& walk, PolygonFaceSolver& solver, Part& part);
  [[nodiscard]] std::vector<Edge> open_candidates() const;
  [[nodiscard]] double simple_lower_bound() const;
  [[nodiscard]] Walk walk_again(const Edge& start) const;
  void solve_regions();
  void assemble(FaceSolution& solution);
  [[nodiscard]] Interval optimum() const;

  CandidateGraph graph_;
  Context& context_;
  std::optional<FaceWalker> walker_;
  tbb::enumerable_thread_specific<PolygonFaceSolver> solvers_;
  std::uint32_t outer_face_ = 0;
  std::vector<Part> parts_;  // of the blocks, then of the long walks
  std::vector<RegionSolution> regions_;
  std::size_t late_regions_ = 0;
};

// Every part has its place, whichever thread fills it.
void FaceSolver::solve_polygons() {
  outer_face_ = walker_->owner_of_outer_face();
  solve_blocks();
  solve_long_walks();
}

std::vector<Edge> FaceSolver::open_candidates() const {
  std::vector<Edge> edges;
  for (const Part& part : parts_) {
    for (const Walk& walk : part.composite_walks) {
      for (const Corner& corner : walk) {
        for (std::uint32_t i = 0; i < corner.candidates; ++i) {
          edges.push_back({corner.vertex, candidate_of(graph_, corner, i)});
        }
      }
    }
    for (const Index vertex : part.isolated) {
      for (const Index target : graph_.star(vertex)) edges.push_back({vertex, target});
    }
  }
  return undirected_edges(std::move(edges));
}

// Walks name halfedges by numbers that change when edges go: their first edges find them again.
void FaceSolver::repair() {
  // A candidate that crosses a certain edge leads out of its face at both ends or breaks the face's polygon, so it is
  // found among the open ones.
  const auto crossing = find_crossing_candidates(graph_, open_candidates(), context_.deadline);
  if (!crossing) {
    throw SearchStopped(StopReason::deadline, "the deadline passed before the faces were known", simple_lower_bound());
  }
  if (crossing->empty()) return;
  const auto start_of = [&](const Walk& walk) { return Edge{walk.back().vertex, graph_.target[walk.back().halfedge]}; };
  std::vector<std::vector<Edge>> composite(parts_.size());
  std::vector<std::vector<Edge>> late(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (const Walk& walk : parts_[i].composite_walks) composite[i].push_back(start_of(walk));
    for (const Walk& walk : parts_[i].late_walks) late[i].push_back(start_of(walk));
  }
  remove_edges(graph_, *crossing);
  walker_.emplace(graph_);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i].composite_walks.clear();
    parts_[i].late_walks.clear();
    for (const Edge& start : composite[i]) solve_walk(walk_again(start), solvers_.local(), parts_[i]);
    for (const Edge& start : late[i]) parts_[i].late_walks.push_back(walk_again(start));
  }
}

// The certain edges and as many of the shortest candidates as there must be others.
double FaceSolver::simple_lower_bound() const {
  LengthSum certain;
  for (const Part& part : parts_) certain.add(part.certain);
  std::vector<Edge> candidates;
  std::size_t certain_edges = 0;
  for (Index v = 0; v < graph_.points.size(); ++v) {
    for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + std::size_t{1}]; ++h) {
      if (graph_.target[h] < v) continue;
      if (graph_.certain[h] == 0) candidates.push_back({v, graph_.target[h]});
      certain_edges += graph_.certain[h];
    }
  }
  const std::size_t edges = 3 * graph_.points.size() - 3 - walker_->outer_face_size();
  const Interval shortest = shortest_edges_length(graph_.points, candidates, edges - certain_edges);
  return std::max(0.0, next_down(certain.enclosure().lower + shortest.lower));
}

Walk FaceSolver::walk_again(const Edge& start) const {
  return walker_->corners_of_face(start.a, walker_->corner_towards(start.a, start.b).halfedge);
}

FaceSolution FaceSolver::finish() {
  FaceSolution solution;
  solve_regions();
  assemble(solution);
  return solution;
}

void FaceSolver::solve_blocks() {
  const std::size_t size = graph_.points.size();
  const std::size_t blocks = (size + kBlock - 1) / kBlock;
  parts_.resize(blocks);
  Progress progress(context_, blocks);
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    solve_block(static_cast<Index>(block * kBlock), static_cast<Index>(std::min(size, (block + 1) * kBlock)),
                parts_[block]);
    progress.advance();
  });
}

void FaceSolver::solve_block(Index begin, Index end, Part& part) {
  PolygonFaceSolver& solver = solvers_.local();
  Walk walk;
  part.solved.triangles.reserve(2 * std::size_t{end - begin});
  for (Index v = begin; v < end; ++v) {
    bool is_isolated = true;
    for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + 1]; ++h) {
      if (graph_.certain[h] == 0) continue;
      is_isolated = false;
      if (v < graph_.target[h]) part.certain.add(graph_.points[v], graph_.points[graph_.target[h]]);
      const WalkEnd walk_end = walker_->walk(v, h, kLongWalk, walk);
      if (walk_end == WalkEnd::too_long) part.long_walks.push_back({v, h, 0});
      if (walk_end == WalkEnd::closed && h != outer_face_) solve_walk(walk, solver, part);
    }
    if (is_isolated) part.isolated.push_back(v);
  }
}

void FaceSolver::solve_walk(const Walk& walk, PolygonFaceSolver& solver, Part& part) {
  const bool is_triangle =
      walk.size() == 3 && walk[0].candidates == 0 && walk[1].candidates == 0 && walk[2].candidates == 0;
  if (is_triangle) {
    part.solved.triangles.push_back({walk[0].vertex, walk[1].vertex, walk[2].vertex});
    return;
  }
  part.max_face = std::max<std::uint64_t>(part.max_face, walk.size());
  switch (solver.solve(walk, context_.deadline, part.solved)) {
    case PolygonFaceOutcome::solved: ++part.faces; break;
    case PolygonFaceOutcome::not_a_polygon: part.composite_walks.push_back(walk); break;
    case PolygonFaceOutcome::no_triangulation:
      throw std::logic_error("candidate graph: a face has no triangulation by candidates");
    case PolygonFaceOutcome::out_of_time: part.late_walks.push_back(walk); break;
  }
}

// Starts come in ascending order, so that a walk's first one is its owner; the others find it visited.
std::vector<Walk> FaceSolver::collect_long_walks() const {
  std::vector<Walk> walks;
  std::vector<bool> is_visited;
  for (const Part& part : parts_) {
    for (const Corner& start : part.long_walks) {
      is_visited.resize(graph_.target.size());
      if (is_visited[start.halfedge]) continue;
      Walk walk;
      walker_->walk(start.vertex, start.halfedge, graph_.target.size(), walk);
      for (const Corner& corner : walk) is_visited[corner.halfedge] = true;
      if (start.halfedge != outer_face_) walks.push_back(std::move(walk));
    }
  }
  return walks;
}

void FaceSolver::solve_long_walks() {
  const std::vector<Walk> walks = collect_long_walks();
  const std::size_t blocks = parts_.size();
  parts_.resize(blocks + walks.size());
  Progress progress(context_, walks.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, walks.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          solve_walk(walks[i], solvers_.local(), parts_[blocks + i]);
          progress.advance();
        }
      },
      tbb::simple_partitioner());
}

void FaceSolver::solve_regions() {
  std::vector<Walk> composite;
  std::vector<Walk> late;
  std::vector<Index> isolated;
  for (Part& part : parts_) {
    std::move(part.composite_walks.begin(), part.composite_walks.end(), std::back_inserter(composite));
    std::move(part.late_walks.begin(), part.late_walks.end(), std::back_inserter(late));
    isolated.insert(isolated.end(), part.isolated.begin(), part.isolated.end());
  }
  std::vector<FaceRegion> regions;
  for (const Walk& walk : late) regions.push_back(make_region(graph_, {&walk}, {}));
  late_regions_ = regions.size();
  for (FaceRegion& region : group_into_regions(graph_, *walker_, composite, isolated)) {
    regions.push_back(std::move(region));
  }
  regions_.resize(regions.size());
  Progress progress(context_, regions.size());
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, regions.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
          const bool is_late = i < late_regions_ || context_.deadline_passed();
          regions_[i] = is_late ? leave_unsolved(graph_.points, regions[i], StopReason::deadline)
                                : solve_region(graph_.points, regions[i], {context_.deadline});
          if (!regions_[i].is_feasible())
            throw std::logic_error("candidate graph: a face has no triangulation by candidates");
          progress.advance();
        }
      },
      tbb::simple_partitioner());
}

// Certain edges and polygons' diagonals are exact up to rounding; regions have lower bounds of their own. The upper end
// is the weight of the triangulation.
Interval FaceSolver::optimum() const {
  LengthSum exact;
  for (const Part& part : parts_) {
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
  std::vector<std::size_t> first{0};
  for (const Part& part : parts_) {
    first.push_back(first.back() + part.solved.triangles.size());
    solution.faces += part.faces;
    solution.max_face = std::max(solution.max_face, part.max_face);
  }
  solution.triangles.resize(first.back());
  tbb::parallel_for(std::size_t{0}, parts_.size(), [&](std::size_t i) {
    const auto& triangles = parts_[i].solved.triangles;
    std::copy(triangles.begin(), triangles.end(), solution.triangles.begin() + static_cast<std::ptrdiff_t>(first[i]));
    parts_[i] = {};
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

FaceSolution solve_faces(CandidateGraph graph, Context& context) {
  tbb::task_arena arena(usable_threads(context));
  return arena.execute([&] {
    FaceSolver solver(std::move(graph), context);
    solver.solve_polygons();
    solver.repair();
    return solver.finish();
  });
}

}  // namespace mwt
