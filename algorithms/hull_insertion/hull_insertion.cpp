#include "algorithms/hull_insertion/hull_insertion.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include <utility>

#include "algorithms/hull_insertion/split_distribution.h"
#include "algorithms/hull_insertion/split_history.h"
#include "algorithms/polygon_dp/convex_polygon.h"
#include "algorithms/step_trace.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/scaling.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

void shuffle(std::vector<Index>& sequence, std::uint64_t seed) {
  boost::random::mt19937_64 engine(seed);
  for (std::size_t left = sequence.size(); left > 1; --left) {
    boost::random::uniform_int_distribution<std::size_t> position(0, left - 1);
    std::swap(sequence[left - 1], sequence[position(engine)]);
  }
}

std::vector<Index> interior_points_in_order(Points points, const std::vector<Index>& hull, InsertionOrder order,
                                            std::uint64_t seed) {
  std::vector<bool> on_hull(points.size(), false);
  for (const Index p : hull) on_hull[p] = true;
  std::vector<Index> sequence;
  sequence.reserve(points.size() - hull.size());
  if (order == InsertionOrder::x) {
    for (const Index p : lexicographic_order(points)) {
      if (!on_hull[p]) sequence.push_back(p);
    }
    return sequence;
  }
  for (Index p = 0; p < points.size(); ++p) {
    if (!on_hull[p]) sequence.push_back(p);
  }
  if (order == InsertionOrder::random) shuffle(sequence, seed);
  return sequence;
}

InsertionOrder order_named(const std::string& name) {
  if (name == "random") return InsertionOrder::random;
  return name == "x" ? InsertionOrder::x : InsertionOrder::index;
}

// The same insertions one by one.
void note_steps(Points points, const std::vector<Index>& hull, const std::vector<Triangle>& hull_triangles,
                const std::vector<Index>& interior, StepTrace& steps) {
  steps.start = hull_triangles;
  SplitHistory history(points, hull, hull_triangles, interior.size());
  history.note_splits_in(&steps.splits);
  for (const Index p : interior) history.insert(p);
}

Solution solve(Points points, Context& context) {
  HullInsertion result = hull_insertion(points, order_named(context.parameters.text("order")), context.seed, context);
  Solution solution;
  solution.counters = {{"hull_size", result.hull_size},
                       {"hull_weight", result.hull_weight.lower},
                       {"interior_points", static_cast<double>(points.size() - result.hull_size)},
                       {"points_on_edges", static_cast<double>(result.points_on_edges)},
                       {"depth", static_cast<double>(result.depth)}};
  solution.triangulation = std::move(result.triangulation);
  solution.stop_reason = result.stop_reason;
  return solution;
}

}  // namespace

HullInsertion hull_insertion(Points points, InsertionOrder order, std::uint64_t seed, Context& context) {
  if (const int e = exact_scale(points); e != 0) {
    HullInsertion result = hull_insertion(exactly_scaled(points), order, seed, context);
    result.hull_weight = scaled_up(result.hull_weight, e);
    return result;
  }
  const std::vector<Index> hull = convex_hull(points);
  const ConvexPolygonSolution of_hull = [&] {
    const ScopedPhase phase(context, "hull_dp");
    return triangulate_convex_polygon(points, hull, PolygonObjective::perimeter, context);
  }();
  const std::vector<Triangle>& hull_triangles = of_hull.triangles;
  const Interval hull_weight = weight(points, {static_cast<Index>(points.size()), hull_triangles});
  const ScopedPhase phase(context, "insertion");
  const std::vector<Index> interior = interior_points_in_order(points, hull, order, seed);
  SplitTriangles result = insert_by_splitting(points, hull, hull_triangles, interior);
  if (context.steps != nullptr) note_steps(points, hull, hull_triangles, interior, *context.steps);
  return {{static_cast<Index>(points.size()), std::move(result.triangles)},
          static_cast<Index>(hull.size()),
          hull_weight,
          result.edge_splits / 2,
          result.depth,
          of_hull.stop_reason};
}

AlgorithmInfo hull_insertion_entry() {
  AlgorithmInfo info;
  info.name = "hull_insertion";
  info.summary = "optimal triangulation of the hull, then interior points inserted by splitting triangles";
  info.source = "source report, section 5.2";
  info.guarantee = "none: linear in n in the worst case (family insertion_trap); the source report claims O(log n)";
  info.time = "O(h^3 + n log^2 n)";
  info.space = "O(h^2 + n)";
  info.max_n = 1'000'000;
  info.version = 3;
  info.has_steps = true;
  info.parameters = {{"order",
                      ParameterType::choice,
                      "index",
                      "the order in which interior points are inserted: as given, a random one (by the seed), or by x",
                      {"index", "random", "x"}}};
  info.function = solve;
  return info;
}

}  // namespace mwt
