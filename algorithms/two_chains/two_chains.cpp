#include "algorithms/two_chains/two_chains.h"

#include <algorithm>
#include <string>
#include <utility>

#include "algorithms/common/solve_scaled.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/polygon_dp/polygon_dp.h"
#include "algorithms/proof/polygon_duals.h"
#include "algorithms/two_chains/corridor_duals.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/double_double.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// The chains from one bridge to the other: p counter-clockwise around its polygon, q clockwise.
struct Chains {
  std::span<const Index> p;
  std::vector<Index> q;
};

Chains chains_of(const ChainPair& pair) { return {pair.first, {pair.second.rbegin(), pair.second.rend()}}; }

// Whether the best path to (i, j) comes from (i - 1, j) rather than from (i, j - 1).
class Steps {
 public:
  Steps(std::size_t rows, std::size_t columns) : columns_(columns), along_first_(rows * columns, false) {}
  void set(std::size_t i, std::size_t j, bool along_first) { along_first_[i * columns_ + j] = along_first; }
  [[nodiscard]] bool along_first(std::size_t i, std::size_t j) const { return along_first_[i * columns_ + j]; }

 private:
  std::size_t columns_;
  std::vector<bool> along_first_;
};

// Fills in `steps`; returns the length of the best path to the last place.
DoubleDouble shortest_path(Points points, const Chains& chains, Steps& steps) {
  std::vector<DoubleDouble> best(chains.q.size());  // of row i, overwriting row i - 1 from left to right
  for (std::size_t i = 0; i < chains.p.size(); ++i) {
    for (std::size_t j = 0; j < chains.q.size(); ++j) {
      const DoubleDouble edge = length(points[chains.p[i]], points[chains.q[j]]);
      const bool along_first = i > 0 && (j == 0 || !(best[j - 1] < best[j]));
      const bool is_start = i == 0 && j == 0;
      steps.set(i, j, along_first);
      best[j] = is_start ? edge : edge + (along_first ? best[j] : best[j - 1]);
    }
  }
  return best.back();
}

std::vector<Triangle> triangles_along(const Chains& chains, const Steps& steps) {
  std::vector<Triangle> triangles;
  std::size_t i = chains.p.size() - 1, j = chains.q.size() - 1;
  while (i + j > 0) {
    if (steps.along_first(i, j)) {
      triangles.push_back({chains.p[i], chains.p[i - 1], chains.q[j]});
      --i;
    } else {
      triangles.push_back({chains.q[j - 1], chains.q[j], chains.p[i]});
      --j;
    }
  }
  return triangles;
}

// Bounds on the weight of a polygon's best triangulation, and a triangulation.
PolygonTriangulation bounded_greedily(Points points, const std::vector<Index>& cycle) {
  std::vector<Point> own;
  own.reserve(cycle.size());
  for (const Index i : cycle) own.push_back(points[i]);
  Triangulation greedy = greedy_triangulation(own);
  const Interval bounds = {cycle_length(points, cycle).lower, weight(own, greedy).upper};
  for (Triangle& triangle : greedy.triangles) {
    for (Index& corner : triangle) corner = cycle[corner];
  }
  return {std::move(greedy.triangles), bounds};
}

PolygonTriangulation triangulated(Points points, const std::vector<Index>& cycle) {
  std::vector<Point> own;
  for (const Index i : cycle) own.push_back(points[i]);
  if (all_collinear(own)) {
    LengthSum along_the_line;
    for (std::size_t i = 1; i < own.size(); ++i) along_the_line.add(own[i - 1], own[i]);
    return {{}, along_the_line.enclosure()};
  }
  if (cycle.size() > kMaxPolygon) return bounded_greedily(points, cycle);
  return triangulate_polygon(points, cycle, PolygonObjective::edges);
}

ChainPair require_pair(Points points) {
  std::optional<ChainPair> pair = find_chain_pair(points);
  if (!pair) throw NotApplicable("two_chains takes two reflex chains that face each other, with 4 points on the hull");
  if (std::uint64_t{pair->first.size()} * pair->second.size() > kMaxCorridorEdges) {
    throw NotApplicable("two_chains takes chains with at most " + std::to_string(kMaxCorridorEdges) +
                        " edges between them");
  }
  return *std::move(pair);
}

// Larger parts are left out of proofs, which then prove less: nobody could check them.
constexpr std::size_t kMaxNotedEdges = 4'000'000;

// Nothing crosses the chains' edges; between them lies the corridor, and each closes a convex polygon. A chain of two
// points closes none.
void note_proof(Points points, const ChainPair& pair, ProofTrace& trace) {
  const Chains chains = chains_of(pair);
  LengthSum certain;
  EdgeConclusions uncrossed{EdgeReason::uncrossed, {}, {}};
  for (const std::vector<Index>* chain : {&pair.first, &pair.second}) {
    for (std::size_t i = 1; i < chain->size(); ++i) {
      uncrossed.edges.push_back(make_edge((*chain)[i - 1], (*chain)[i]));
      certain.add(points[(*chain)[i - 1]], points[(*chain)[i]]);
    }
    if (chain->size() > 2) certain.add(points[chain->front()], points[chain->back()]);
    const bool is_noted = chain->size() > 2 && chain->size() * chain->size() / 2 <= kMaxNotedEdges;
    if (is_noted)
      trace.regions.push_back(PolygonDuals().solve(points, *chain, diagonals_of_convex_polygon(points, *chain)));
  }
  certain.add(points[chains.p.front()], points[chains.q.front()]);
  certain.add(points[chains.p.back()], points[chains.q.back()]);
  if (chains.p.size() * chains.q.size() <= kMaxNotedEdges) {
    trace.regions.push_back(corridor_duals(points, chains.p, chains.q));
  }
  trace.edges.push_back(std::move(uncrossed));
  trace.lower_bound = certain.enclosure().lower;
  for (const DualRegion& region : trace.regions) trace.lower_bound = next_down(trace.lower_bound + region.lower_bound);
  trace.is_complete = true;
}

Solution solve(Points points, Context& context) {
  const ChainPair pair = [&] {
    const ScopedPhase phase(context, "recognition");
    return require_pair(points);
  }();
  Corridor corridor = [&] {
    const ScopedPhase phase(context, "corridor");
    return triangulate_corridor(points, pair);
  }();
  const ScopedPhase phase(context, "polygons");
  Solution solution;
  solution.triangulation = {static_cast<Index>(points.size()), std::move(corridor.triangles)};
  Interval optimum = corridor.cross_edges;
  for (const std::vector<Index>* chain : {&pair.first, &pair.second}) {
    const PolygonTriangulation part = triangulated(points, *chain);
    optimum = optimum + part.cost;
    solution.triangulation.triangles.insert(solution.triangulation.triangles.end(), part.triangles.begin(),
                                            part.triangles.end());
  }
  solution.optimum = {optimum.lower, weight(points, solution.triangulation).upper};
  if (context.proof != nullptr) note_proof(points, pair, *context.proof);
  solution.counters = {{"first_chain", static_cast<double>(pair.first.size())},
                       {"second_chain", static_cast<double>(pair.second.size())}};
  return solution;
}

Solution solve_at_any_size(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

Corridor triangulate_corridor(Points points, const ChainPair& pair) {
  const Chains chains = chains_of(pair);
  Steps steps(chains.p.size(), chains.q.size());
  const DoubleDouble path = shortest_path(points, chains, steps);
  // A length errs by 8 units and passes through at most r + s additions, of one unit each.
  const double relative_error = (static_cast<double>(chains.p.size() + chains.q.size()) + 8) * kDoubleDoubleError;
  return {triangles_along(chains, steps), enclose(path, relative_error)};
}

AlgorithmInfo two_chains_entry() {
  AlgorithmInfo info;
  info.name = "two_chains";
  info.summary = "dynamic programs for two facing reflex chains (corridors)";
  info.source = "lattice-path and interval dynamic programs; Klincsek 1980 for the latter";
  info.guarantee = "optimal";
  info.time = "O(r^3 + s^3) for chains of r and s points";
  info.space = "O(r^2 + s^2)";
  info.exactness = Exactness::exact;
  info.has_proofs = true;
  info.max_n = 200'000;
  info.version = 2;
  info.function = solve_at_any_size;
  return info;
}

}  // namespace mwt
