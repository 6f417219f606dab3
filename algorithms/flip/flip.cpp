#include "algorithms/flip/flip.h"

#include <utility>

#include "algorithms/common/start.h"
#include "algorithms/flip/best_first.h"
#include "algorithms/flip/counted_flips.h"
#include "algorithms/flip/improving_flip.h"

namespace mwt {

namespace {

FlipResult flip_any_first(PlanarMesh& mesh, const Context& context, bool with_trace) {
  CountedFlips flips(mesh, context, with_trace);
  std::vector<MeshEdge> suspects;
  for (MeshEdge e = 0; e < mesh.edge_count() && !flips.stopped_early(); ++e) {
    suspects.push_back(e);
    while (!suspects.empty() && !flips.out_of_time()) {
      const MeshEdge suspect = suspects.back();
      suspects.pop_back();
      if (!improves(mesh, suspect)) continue;
      flips.flip(suspect);
      for (const MeshEdge side : sides_of(mesh, suspect)) suspects.push_back(side);
    }
  }
  return flips.take_result();
}

}  // namespace

FlipResult flip_to_local_optimum(PlanarMesh& mesh, FlipOrder order, const Context& context, bool with_trace) {
  return order == FlipOrder::stack ? flip_any_first(mesh, context, with_trace)
                                   : flip_best_first(mesh, context, with_trace);
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
  solution.stop_reason = deadline_if(result.stopped_early);
  return solution;
}

}  // namespace

AlgorithmInfo flip_entry() {
  AlgorithmInfo info;
  info.name = "flip";
  info.summary = "flips edges to shorter diagonals until no flip improves";
  info.source =
      "the source report's flip heuristic; flips: C. L. Lawson, Software for C1 surface interpolation, in Mathematical "
      "Software III (1977)";
  info.guarantee = "none known; local optimum under flips, certified by exact comparison; never worse than its start";
  info.time = "O(n) plus O(1) per flip (stack) or O(log n) per flip (best)";
  info.space = "O(n) (stack) or O(n + flips) (best)";
  info.max_n = 10'000'000;
  info.version = 2;
  info.parameters = {
      {"order", ParameterType::choice, "stack", "which improving flip comes next", {"stack", "best"}},
      start_parameter("delaunay"),
      {"trace", ParameterType::choice, "off", "whether to record every flip with its gain", {"off", "on"}},
  };
  info.function = run_flip;
  return info;
}

}  // namespace mwt
