#include "algorithms/greedy/greedy.h"

#include "algorithms/greedy/greedy_builder.h"
#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/step_trace.h"
#include "geometry/mesh/edge_order.h"

namespace mwt {

GreedyCounters make_greedy(PlanarMesh& mesh, const Context& context) {
  const GreedyCounters counters = build_greedy(mesh, context);
  mesh.clear_marks(kGreedyMarks);
  return counters;
}

Triangulation greedy_triangulation(Points points) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  make_greedy(mesh, Context{});
  return mesh.triangulation();
}

namespace {

// The order in which greedy takes its edges is that of their lengths, however they were found.
void note_steps(Points points, const Triangulation& triangulation, StepTrace& steps) {
  steps.kept = edges_of(triangulation);
  sort_by_length(points, steps.kept);
}

Solution run_greedy(Points points, Context& context) {
  const auto delaunay = [&] {
    const ScopedPhase phase(context, "delaunay");
    return PlanarMesh::delaunay(points);
  };
  PlanarMesh mesh = delaunay();
  const ScopedPhase phase(context, "greedy");
  const GreedyCounters counters = make_greedy(mesh, context);
  Solution solution;
  solution.triangulation = mesh.triangulation();
  solution.counters = {{"ears", static_cast<double>(counters.ears)}, {"flips", static_cast<double>(counters.flips)}};
  solution.stop_reason = deadline_if(counters.stopped_early);
  if (context.steps != nullptr && !counters.stopped_early) note_steps(points, solution.triangulation, *context.steps);
  return solution;
}

}  // namespace

AlgorithmInfo greedy_entry() {
  AlgorithmInfo info;
  info.name = "greedy";
  info.summary =
      "shortest edges first, each kept unless it crosses a kept one; from a constrained Delaunay triangulation";
  info.source =
      "C. A. Wang, Efficiently updating constrained Delaunay triangulations, BIT 33 (1993); C. Levcopoulos, D. "
      "Krznaric, The greedy triangulation can be computed from the Delaunay triangulation in linear time, "
      "Computational Geometry 14 (1999); faces of certified edges: this project, algorithms/greedy/README.md";
  info.guarantee =
      "Theta(sqrt n) in the worst case: C. Levcopoulos, An Omega(sqrt n) lower bound for the nonoptimality of the "
      "greedy triangulation, IPL 25 (1987); C. Levcopoulos, D. Krznaric, Quasi-greedy triangulations approximating "
      "the minimum weight triangulation, J. Algorithms 27 (1998)";
  info.time = "O(n log n) in practice; about one and a half of CGAL's Delaunay triangulations on uniform points";
  info.space = "O(n), less than 200 bytes per point";
  info.max_n = 10'000'000;
  info.version = 2;
  info.has_steps = true;
  info.function = run_greedy;
  return info;
}

}  // namespace mwt
