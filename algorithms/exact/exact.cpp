#include "algorithms/exact/exact.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <new>
#include <optional>
#include <span>
#include <utility>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/common/solve_scaled.h"
#include "algorithms/exact/bounds/count_bound.h"
#include "algorithms/exact/bounds/simple_bound.h"
#include "algorithms/exact/bounds/star_bound.h"
#include "algorithms/exact/candidates/certain_edges.h"
#include "algorithms/exact/candidates/diamond_candidates.h"
#include "algorithms/exact/candidates/kd_order.h"
#include "algorithms/exact/candidates/lmt_skeleton.h"
#include "algorithms/exact/division/certain_division.h"
#include "algorithms/exact/faces/composite_vertices.h"
#include "algorithms/exact/faces/face_solver.h"
#include "algorithms/exact/proof/face_proof.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/exact/usable_threads.h"
#include "algorithms/interrupted.h"
#include "algorithms/polygon_dp/convex_polygon.h"
#include "algorithms/proof/convex_proof.h"
#include "algorithms/proof_trace.h"
#include "algorithms/step_trace.h"
#include "algorithms/two_chains/two_chains.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/interval.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// What the diamond test used lies in pieces between the stars: the next stages would take new memory.
void return_freed_memory() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

// Certified bounds that are closer together are not raised by what the points alone say.
constexpr double kWorthRaising = 1e-6;

class ExactSolver {
 public:
  ExactSolver(Points points, Context& context) : points_(points), context_(context) {}

  Solution run() {
    Solution solution = run_stages();
    if (solution.stop_reason) {
      raise_lower_bound(solution);
      improve_by_heuristics(points_, context_, solution);
    }
    solution.counters = std::move(counters_);
    return solution;
  }

 private:
  Solution run_stages() {
    bounds_deadline_ = deadline_before_heuristics(context_.deadline, points_.size());
    const OtherDeadline leaving_time(context_, deadline_before_bounds(bounds_deadline_, points_.size()));
    try {
      std::optional<CandidateGraph> graph = candidates();
      if (!graph) return corridor_ ? corridor_solution() : convex_solution();
      std::optional<CandidateGraph> noted;
      if (context_.proof != nullptr) noted = graph;
      const FaceSolution faces = solve(*std::move(graph));
      if (noted) note_proof(*std::move(noted), faces);
      return make_solution(faces);
    } catch (const SearchStopped& stopped) {
      return without_triangulation(stopped.reason, stopped.lower_bound);
    } catch (const std::bad_alloc&) {
      return without_triangulation(StopReason::memory, 0);
    }
  }

  // What stops at a face may know less of it than the points alone say.
  void raise_lower_bound(Solution& solution) {
    const ScopedPhase phase(context_, "bounds");
    const bool is_settled = !solution.optimum || !convex_polygon_.empty() || corridor_ ||
                            solution.optimum->relative_width() < kWorthRaising;
    if (is_settled) return;
    const double bound = bound_by_counts(points_, deadline_of_bounds(bounds_deadline_, points_.size()));
    solution.optimum->lower = std::max(solution.optimum->lower, std::min(bound, solution.optimum->upper));
  }

  // Nearly all pairs of points of two facing chains are candidates, but programs over the chains need none of them.
  void find_corridor() {
    constexpr std::size_t kMinCorridor = 1000;
    if (points_.size() >= kMinCorridor) corridor_ = find_chain_pair(points_, context_.deadline);
  }

  Solution corridor_solution() {
    report_stage("corridor", 0);
    if (context_.proof != nullptr) *context_.proof = {};
    Solution solution = solve_chain_pair(points_, *corridor_, context_);
    counters_ = std::move(solution.counters);
    if (solution.optimum->relative_width() > kProvedRelativeWidth && !solution.stop_reason)
      solution.stop_reason = StopReason::precision;
    return solution;
  }

  // Nothing for points in convex position, which are then convex_polygon_, and for two facing chains, then corridor_.
  std::optional<CandidateGraph> candidates() {
    report_stage("k-d order", 0);
    {
      const ScopedPhase phase(context_, "kd_order");
      order_ = make_kd_order(points_);
      if (context_.proof != nullptr) context_.proof->order = order_.original;
    }
    report_stage("diamond test", 0.05);
    HullEdges hull_edges;
    std::optional<DiamondTest> test;
    {
      const ScopedPhase phase(context_, "diamond_distances");
      test.emplace(order_);
      const std::vector<Index> hull = find_hull(test->possible_hull_points());
      if (hull.size() == points_.size()) {
        for (const Index p : hull) convex_polygon_.push_back(order_.original[p]);
        return {};
      }
      if (hull.size() == 4) find_corridor();
      if (corridor_) return {};
      hull_edges.next.assign(points_.size(), kNoIndex);
      for (std::size_t i = 0; i < hull.size(); ++i) hull_edges.next[hull[i]] = hull[(i + 1) % hull.size()];
    }
    report_stage("diamond test and LMT-skeleton", 0.15);
    LmtSkeleton skeleton = skeleton_of(hull_edges, *test);
    test.reset();
    return_freed_memory();
    CandidateGraph graph = candidates_of(hull_edges, skeleton);
    if (const std::vector<Index> composite = composite_vertices(graph); !composite.empty())
      divide_in_time(composite, hull_edges, skeleton, graph);
    count(graph);
    return graph;
  }

  // The candidates before it do as well, unless what was deleted is in the proof.
  void divide_in_time(std::span<const Index> composite, const HullEdges& hull_edges, LmtSkeleton& skeleton,
                      CandidateGraph& graph) {
    try {
      divide(composite, hull_edges, skeleton, graph);
    } catch (const SearchStopped&) {
      if (context_.proof != nullptr) throw;
    }
  }

  // Where points are left apart from others: faces with holes or isolated points cost more than looking for what ties
  // them together.
  void divide(std::span<const Index> composite, const HullEdges& hull_edges, LmtSkeleton& skeleton,
              CandidateGraph& graph) {
    report_stage("beta-skeleton", 0.85);
    {
      const ScopedPhase phase(context_, "beta_skeleton");
      const std::size_t crossing =
          delete_what_crosses_beta_skeleton(order_, composite, graph, hull_edges, skeleton.stars, context_);
      if (crossing > 0) graph = mark_certain_edges(order_.points, skeleton.stars, context_);
      counters_["edges_across_beta_skeleton"] = static_cast<double>(crossing);
      if (composite_vertices(graph).empty()) return;
    }
    const ScopedPhase phase(context_, "lmt_again");
    const std::uint64_t deleted = examine_between_large_stars(skeleton.stars, order_, hull_edges, context_);
    if (deleted > 0) graph = mark_certain_edges(order_.points, skeleton.stars, context_);
    counters_["edges_deleted_at_last"] = static_cast<double>(deleted);
  }

  LmtSkeleton skeleton_of(const HullEdges& hull_edges, DiamondTest& test) {
    const ScopedPhase phase(context_, "diamond_test_and_lmt");
    LmtSkeleton skeleton = find_lmt_skeleton(order_, hull_edges, test, context_);
    counters_["edges_after_diamond_test"] = static_cast<double>(test.count());
    counters_["lmt_checks"] = static_cast<double>(skeleton.counters.checks);
    return skeleton;
  }

  CandidateGraph candidates_of(const HullEdges& hull_edges, const LmtSkeleton& skeleton) {
    report_stage("certain edges", 0.8);
    const ScopedPhase phase(context_, "certain_edges");
    try {
      return mark_certain_edges(order_.points, skeleton.stars, context_);
    } catch (const SearchStopped& stopped) {
      throw_if_interrupted(context_.deadline);
      throw SearchStopped(stopped.reason, stopped.what(),
                          bound_by_stars(order_.points, hull_edges, skeleton.stars,
                                         deadline_of_bounds(bounds_deadline_, points_.size())));
    }
  }

  void count(const CandidateGraph& graph) {
    std::size_t certain = 0;
    for (const std::uint8_t mark : graph.certain) certain += mark;
    counters_["edges_after_lmt"] = static_cast<double>(graph.target.size() / 2);
    counters_["certain_edges"] = static_cast<double>(certain / 2);
    report_stage("faces", 0.9);
  }

  std::vector<Index> find_hull(const std::vector<Index>& possible) const {
    std::vector<Point> points;
    points.reserve(possible.size());
    for (const Index p : possible) points.push_back(order_.points[p]);
    std::vector<Index> hull = convex_hull(points);
    for (Index& p : hull) p = possible[p];
    return hull;
  }

  FaceSolution solve(CandidateGraph graph) {
    const ScopedPhase phase(context_, "faces");
    FaceSolution faces = solve_faces(std::move(graph), context_, bounds_deadline_);
    if (context_.steps != nullptr) {
      for (Edge& cut : context_.steps->cuts) cut = make_edge(order_.original[cut.a], order_.original[cut.b]);
    }
    count(faces);
    return faces;
  }

  // A proof for which there is too little memory is no reason to lose the solution.
  void note_proof(CandidateGraph graph, const FaceSolution& faces) {
    const ScopedPhase phase(context_, "proof");
    try {
      note_faces(std::move(graph), faces.triangles, context_);
    } catch (const std::bad_alloc&) {
      note_simple_bound(simple_lower_bound(points_));
    }
  }

  void note_simple_bound(double bound) {
    if (context_.proof != nullptr) *context_.proof = trace_of_bound(bound);
  }

  void count(const FaceSolution& faces) {
    counters_["faces"] = static_cast<double>(faces.faces);
    counters_["max_face"] = static_cast<double>(faces.max_face);
    counters_["dp_cells"] = static_cast<double>(faces.dp_cells);
    counters_["precise_comparisons"] = static_cast<double>(faces.precise_comparisons);
    counters_["undecided_ties"] = static_cast<double>(faces.undecided_ties);
    counters_["faces_with_holes"] = static_cast<double>(faces.faces_with_holes);
    counters_["reductions"] = static_cast<double>(faces.reductions);
    counters_["linear_programs"] = static_cast<double>(faces.programs);
    counters_["branchings"] = static_cast<double>(faces.branchings);
    counters_["unsolved_faces"] = static_cast<double>(faces.unsolved_faces);
  }

  Solution make_solution(const FaceSolution& faces) const {
    Solution solution;
    solution.triangulation.point_count = static_cast<Index>(points_.size());
    solution.triangulation.triangles = faces.triangles;
    for (Triangle& triangle : solution.triangulation.triangles) {
      for (Index& corner : triangle) corner = order_.original[corner];
    }
    solution.optimum = faces.optimum;
    solution.stop_reason = faces.stop_reason;
    return solution;
  }

  Solution convex_solution() {
    order_ = {};
    ConvexPolygonSolution polygon =
        triangulate_convex_polygon(points_, convex_polygon_, PolygonObjective::edges, context_);
    Solution solution;
    solution.triangulation = {static_cast<Index>(points_.size()), std::move(polygon.triangles)};
    solution.optimum = {polygon.weight_of_optimum.lower, weight(points_, solution.triangulation).upper};
    solution.stop_reason = polygon.stop_reason;
    if (context_.proof != nullptr) note_convex_polygon(points_, convex_polygon_, solution.stop_reason, context_);
    return solution;
  }

  Solution without_triangulation(StopReason reason, double lower_bound) {
    throw_if_interrupted(context_.deadline);
    order_ = {};
    Solution solution;
    if (context_.proof != nullptr) note_simple_bound(simple_lower_bound(points_));
    solution.optimum = {lower_bound, std::numeric_limits<double>::infinity()};
    solution.stop_reason = reason;
    return solution;
  }

  void report_stage(const char* stage, double done) const {
    throw_if_interrupted(context_.deadline);
    if (context_.progress) context_.progress(stage, done);
  }

  Points points_;
  Context& context_;
  Deadline bounds_deadline_;
  KdOrder order_;
  std::vector<Index> convex_polygon_;
  std::optional<ChainPair> corridor_;
  std::map<std::string, double> counters_;
};

Solution solve(Points points, Context& context) {
  tbb::task_arena arena(usable_threads(context));
  return arena.execute([&] { return ExactSolver(points, context).run(); });
}

}  // namespace

Solution exact(Points points, Context& context) { return solve_scaled(points, context, solve); }

AlgorithmInfo exact_entry() {
  AlgorithmInfo info;
  info.name = "exact";
  info.summary = "proved optimum at scale: diamond test, LMT-skeleton, dynamic and linear programs per face";
  info.source =
      "after A. Haas, SoCG 2018 (arXiv:1802.06415); Das and Joseph 1989; Drysdale, McElfresh, Snoeyink 2001; "
      "Dickerson and Montague 1996; Beirouti and Snoeyink 1998";
  info.guarantee = "optimal, with a certified interval";
  info.time = "about O(n log n) on random input; exponential in the worst case (NP-hard)";
  info.space = "about 320 bytes per point; 380 if certain edges do not connect all points";
  info.exactness = Exactness::exact;
  info.has_proofs = true;
  info.has_steps = true;
  info.max_n = 10'000'000;
  info.version = 3;
  info.function = exact;
  return info;
}

}  // namespace mwt
