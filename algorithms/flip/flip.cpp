#include "algorithms/flip/flip.h"

#include <algorithm>
#include <array>
#include <functional>
#include <queue>
#include <utility>

#include "algorithms/mesh/distance.h"
#include "algorithms/start/start.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// The distance of two mesh points, for gains only; no decision depends on its rounding.
double distance(const PlanarMesh& mesh, Index v, Index w) { return rounded_distance(mesh.point(v), mesh.point(w)); }

double gain_of(const PlanarMesh& mesh, MeshEdge e) {
  return distance(mesh, mesh.origin(2 * e), mesh.target(2 * e)) -
         distance(mesh, mesh.apex(2 * e), mesh.apex(2 * e + 1));
}

// Whether flipping e shortens the triangulation. Lengths first: they decide most cases.
bool improves(const PlanarMesh& mesh, MeshEdge e) {
  if (mesh.is_hull(e)) return false;
  const Halfedge h = 2 * e;
  return compare_length(mesh.point(mesh.apex(h)), mesh.point(mesh.apex(h + 1)), mesh.point(mesh.origin(h)),
                        mesh.point(mesh.target(h))) < 0 &&
         mesh.is_flippable(e);
}

class FlipSearch {
 public:
  FlipSearch(PlanarMesh& mesh, const Context& context, bool with_trace)
      : mesh_(mesh), context_(context), with_trace_(with_trace) {}

  FlipResult any_first() {
    std::vector<MeshEdge> suspects;
    for (MeshEdge e = 0; e < mesh_.edge_count() && !result_.stopped_early; ++e) {
      suspects.push_back(e);
      while (!suspects.empty() && !out_of_time()) {
        const MeshEdge suspect = suspects.back();
        suspects.pop_back();
        if (!improves(mesh_, suspect)) continue;
        flip(suspect);
        for (const MeshEdge side : sides(suspect)) suspects.push_back(side);
      }
    }
    return std::move(result_);
  }

  // The flips possible at the start are sorted, so that it is known which mesh edges are needed soon; those that become
  // possible later go through a heap.
  FlipResult best_first() {
    std::vector<GainAt> first;
    for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
      if (improves(mesh_, e)) first.emplace_back(gain_of(mesh_, e), e);
    }
    std::sort(first.begin(), first.end(), std::greater<GainAt>());
    std::priority_queue<GainAt> later;
    std::size_t next = 0;
    while ((next < first.size() || !later.empty()) && !out_of_time()) {
      const bool is_first = later.empty() || (next < first.size() && later.top() < first[next]);
      const GainAt best = is_first ? first[next] : later.top();
      if (is_first) {
        fetch_ahead(first, next++);
      } else {
        later.pop();
      }
      const auto [gain, e] = best;
      // Flips nearby may have changed the quadrilateral; then a newer entry speaks for it.
      if (gain != gain_of(mesh_, e) || !improves(mesh_, e)) continue;
      flip(e);
      for (const MeshEdge side : sides(e)) {
        if (improves(mesh_, side)) later.push({gain_of(mesh_, side), side});
      }
    }
    return std::move(result_);
  }

 private:
  using GainAt = std::pair<double, MeshEdge>;

  // Asks for what the coming flips need: first the records, then the sides, then what lies beyond them.
  void fetch_ahead(const std::vector<GainAt>& coming, std::size_t next) const {
    constexpr std::size_t kFar = 24, kMiddle = 16, kNear = 8;
    if (next + kFar >= coming.size()) return;
    mesh_.prefetch(coming[next + kFar].second);
    const MeshEdge middle = coming[next + kMiddle].second;
    mesh_.prefetch_point(mesh_.origin(2 * middle));
    mesh_.prefetch_point(mesh_.target(2 * middle));
    for (const MeshEdge side : sides(middle)) mesh_.prefetch(side);
    const MeshEdge near = coming[next + kNear].second;
    for (const Halfedge h : {2 * near, 2 * near + 1}) {
      mesh_.prefetch_point(mesh_.apex(h));
      for (const Halfedge side : {twin(mesh_.next(h)), twin(mesh_.previous(h))}) {
        mesh_.prefetch(edge_of(mesh_.next(side)));
        mesh_.prefetch(edge_of(mesh_.previous(side)));
      }
    }
  }

  [[nodiscard]] std::array<MeshEdge, 4> sides(MeshEdge e) const {
    const Halfedge h = 2 * e;
    return {edge_of(mesh_.next(h)), edge_of(mesh_.previous(h)), edge_of(mesh_.next(h + 1)),
            edge_of(mesh_.previous(h + 1))};
  }

  bool out_of_time() {
    if (++result_.tests % 4096 == 0 && context_.deadline_passed()) result_.stopped_early = true;
    return result_.stopped_early;
  }

  void flip(MeshEdge e) {
    const Edge removed = mesh_.labelled_edge(e);
    const double gain = with_trace_ ? gain_of(mesh_, e) * mesh_.unit() : 0;
    mesh_.flip(e);
    ++result_.flips;
    if (with_trace_) result_.trace.push_back({removed, mesh_.labelled_edge(e), gain});
  }

  PlanarMesh& mesh_;
  const Context& context_;
  bool with_trace_;
  FlipResult result_;
};

}  // namespace

FlipResult flip_to_local_optimum(PlanarMesh& mesh, FlipOrder order, const Context& context, bool with_trace) {
  FlipSearch search(mesh, context, with_trace);
  return order == FlipOrder::stack ? search.any_first() : search.best_first();
}

bool is_flip_optimal(const PlanarMesh& mesh) {
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if (improves(mesh, e)) return false;
  }
  return true;
}

namespace {

Solution run_flip(Points points, Context& context) {
  const auto start = [&] {
    const ScopedPhase phase(context, "start");
    return start_mesh(points, context);
  };
  PlanarMesh mesh = start();
  const ScopedPhase phase(context, "flip");
  const FlipOrder order = context.parameters.text("order") == "best" ? FlipOrder::best : FlipOrder::stack;
  FlipResult result = flip_to_local_optimum(mesh, order, context, context.parameters.text("trace") == "on");
  Solution solution;
  solution.triangulation = mesh.triangulation();
  solution.flips = std::move(result.trace);
  solution.counters = {{"flips", static_cast<double>(result.flips)}, {"tests", static_cast<double>(result.tests)}};
  solution.stopped_early = result.stopped_early;
  return solution;
}

}  // namespace

AlgorithmInfo flip_entry() {
  AlgorithmInfo info;
  info.name = "flip";
  info.summary = "flips edges to shorter diagonals until no flip improves";
  info.source =
      "the report's flip heuristic; flips: C. L. Lawson, Software for C1 surface interpolation, in Mathematical "
      "Software III (1977)";
  info.guarantee = "none known; local optimum under flips, certified by exact comparison; never worse than its start";
  info.time = "O(n) plus O(1) per flip (stack) or O(log n) per flip (best)";
  info.space = "O(n)";
  info.largest_n = 10'000'000;
  info.parameters = {
      {"order", ParameterType::choice, "stack", "which improving flip comes next", {"stack", "best"}},
      start_parameter("delaunay"),
      {"trace", ParameterType::choice, "off", "whether to record every flip with its gain", {"off", "on"}},
  };
  info.function = run_flip;
  return info;
}

}  // namespace mwt
