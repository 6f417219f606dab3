#include "algorithms/two_chains/two_chains.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/common/solve_scaled.h"
#include "algorithms/polygon_dp/convex_polygon.h"
#include "algorithms/proof/convex_proof.h"
#include "algorithms/proof_trace.h"
#include "algorithms/two_chains/corridor_duals.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/double_double.h"
#include "geometry/predicates.h"
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

// Fills in `steps`; returns the length of the best path to the last place, unless the deadline passes first.
std::optional<DoubleDouble> shortest_path(Points points, const Chains& chains, Steps& steps, const Deadline& deadline) {
  std::vector<DoubleDouble> best(chains.q.size());  // of row i, overwriting row i - 1 from left to right
  for (std::size_t i = 0; i < chains.p.size(); ++i) {
    if (has_passed(deadline)) return {};
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

// A chain with the edge from its end to its start: a convex polygon, or a line.
ConvexPolygonSolution triangulated(Points points, const std::vector<Index>& cycle, Context& context) {
  std::vector<Point> own;
  for (const Index i : cycle) own.push_back(points[i]);
  if (!all_collinear(own)) return triangulate_convex_polygon(points, cycle, PolygonObjective::edges, context);
  LengthSum along_the_line;
  for (std::size_t i = 1; i < own.size(); ++i) along_the_line.add(own[i - 1], own[i]);
  return {{}, along_the_line.enclosure(), {}};
}

std::uint64_t bytes_for_corridor(const ChainPair& pair) {
  return std::uint64_t{pair.first.size()} * pair.second.size() / 8 + sizeof(DoubleDouble) * pair.second.size();
}

// Of the corridor's dual values.
constexpr std::uint64_t kBytesPerNotedEdge = 32;

// A chain of two points closes none, nor does one along a side of the hull.
bool closes_polygon(Points points, const std::vector<Index>& chain) {
  return chain.size() > 2 && orientation(points[chain[0]], points[chain[1]], points[chain.back()]) != 0;
}

// The chains, the edges that close their polygons, and the bridges are in every triangulation.
double certain_length(Points points, const ChainPair& pair) {
  LengthSum sum;
  for (const std::vector<Index>* chain : {&pair.first, &pair.second}) {
    for (std::size_t i = 1; i < chain->size(); ++i) sum.add(points[(*chain)[i - 1]], points[(*chain)[i]]);
    if (closes_polygon(points, *chain)) sum.add(points[chain->front()], points[chain->back()]);
  }
  sum.add(points[pair.first.front()], points[pair.second.back()]);
  sum.add(points[pair.second.front()], points[pair.first.back()]);
  return sum.enclosure().lower;
}

// Notes what proves the optimum. Nothing crosses the chains' edges; between them lies the corridor, and each closes a
// convex polygon.
class TwoChainsProof {
 public:
  TwoChainsProof(Points points, const ChainPair& pair) : points_(points), pair_(pair) {
    EdgeConclusions uncrossed{EdgeReason::uncrossed, {}, {}};
    for (const std::vector<Index>* chain : {&pair.first, &pair.second}) {
      for (std::size_t i = 1; i < chain->size(); ++i)
        uncrossed.edges.push_back(make_edge((*chain)[i - 1], (*chain)[i]));
    }
    trace_.edges.push_back(std::move(uncrossed));
  }

  // Those parts for which there are time and memory.
  void add_regions(const Context& context) {
    const Chains chains = chains_of(pair_);
    for (const std::vector<Index>* chain : {&pair_.first, &pair_.second}) {
      if (!closes_polygon(points_, *chain)) continue;
      if (auto region = duals_of_convex_polygon(points_, *chain, context)) trace_.regions.push_back(*std::move(region));
    }
    const std::size_t across = chains.p.size() * chains.q.size();
    if (across <= kMaxNotedEdges && context.fits(kBytesPerNotedEdge * across) && !context.deadline_passed())
      trace_.regions.push_back(corridor_duals(points_, chains.p, chains.q));
  }

  ProofTrace take() {
    trace_.lower_bound = certain_length(points_, pair_);
    for (const DualRegion& region : trace_.regions)
      trace_.lower_bound = next_down(trace_.lower_bound + region.lower_bound);
    trace_.is_complete = true;
    return std::move(trace_);
  }

 private:
  Points points_;
  const ChainPair& pair_;
  ProofTrace trace_;
};

// What the programs find until the deadline: at least bounds.
class TwoChainsSolver {
 public:
  TwoChainsSolver(Points points, const ChainPair& pair, Context& context)
      : points_(points), pair_(pair), context_(context) {}

  Solution run() {
    solution_.counters = {{"first_chain", static_cast<double>(pair_.first.size())},
                          {"second_chain", static_cast<double>(pair_.second.size())}};
    if (!context_.fits(bytes_for_corridor(pair_))) return stopped(StopReason::memory);
    std::optional<Corridor> corridor = cross();
    if (!corridor) return stopped(StopReason::deadline);
    solution_.triangulation = {static_cast<Index>(points_.size()), std::move(corridor->triangles)};
    solution_.optimum = corridor->cross_edges;
    const ScopedPhase phase(context_, "polygons");
    for (const std::vector<Index>* chain : {&pair_.first, &pair_.second}) add(triangulated(points_, *chain, context_));
    solution_.optimum->upper = weight(points_, solution_.triangulation).upper;
    note_proof();
    return std::move(solution_);
  }

 private:
  std::optional<Corridor> cross() {
    const ScopedPhase phase(context_, "corridor");
    return triangulate_corridor(points_, pair_, context_.deadline);
  }

  void add(const ConvexPolygonSolution& part) {
    solution_.optimum = *solution_.optimum + part.weight_of_optimum;
    solution_.stop_reason = combined(solution_.stop_reason, part.stop_reason);
    std::vector<Triangle>& all = solution_.triangulation.triangles;
    all.insert(all.end(), part.triangles.begin(), part.triangles.end());
  }

  Solution stopped(StopReason reason) {
    solution_.stop_reason = reason;
    solution_.optimum = {certain_length(points_, pair_), std::numeric_limits<double>::infinity()};
    note_proof();
    return std::move(solution_);
  }

  // Without dual values if something stopped the programs: there is no more time or memory for them.
  void note_proof() {
    if (context_.proof == nullptr) return;
    const ScopedPhase phase(context_, "proof");
    TwoChainsProof proof(points_, pair_);
    if (!solution_.stop_reason) proof.add_regions(context_);
    *context_.proof = proof.take();
  }

  Points points_;
  const ChainPair& pair_;
  Context& context_;
  Solution solution_;
};

// Nothing if the deadline passes first.
std::optional<ChainPair> recognise(Points points, Context& context) {
  const ScopedPhase phase(context, "recognition");
  std::optional<ChainPair> pair = find_chain_pair(points, context.deadline);
  if (!pair && !context.deadline_passed())
    throw NotApplicable("two_chains takes two reflex chains that face each other, with 4 points on the hull");
  return pair;
}

Solution unrecognised(Points points, const Context& context) {
  Solution solution;
  const double lower_bound = cycle_length(points, convex_hull(points)).lower;
  solution.stop_reason = StopReason::deadline;
  solution.optimum = {lower_bound, std::numeric_limits<double>::infinity()};
  if (context.proof != nullptr) *context.proof = trace_of_bound(lower_bound);
  return solution;
}

Solution solve(Points points, Context& context) {
  Solution solution = [&] {
    const OtherDeadline leaving_time(context, deadline_before_heuristics(context.deadline, points.size()));
    const std::optional<ChainPair> pair = recognise(points, context);
    return pair ? solve_chain_pair(points, *pair, context) : unrecognised(points, context);
  }();
  if (solution.stop_reason) improve_by_heuristics(points, context, solution);
  return solution;
}

Solution solve_at_any_size(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

std::optional<Corridor> triangulate_corridor(Points points, const ChainPair& pair, const Deadline& deadline) {
  const Chains chains = chains_of(pair);
  Steps steps(chains.p.size(), chains.q.size());
  const std::optional<DoubleDouble> path = shortest_path(points, chains, steps, deadline);
  if (!path) return {};
  // A length errs by 8 units and passes through at most r + s additions, of one unit each.
  const double relative_error = (static_cast<double>(chains.p.size() + chains.q.size()) + 8) * kDoubleDoubleError;
  return Corridor{triangles_along(chains, steps), enclose(*path, relative_error)};
}

Solution solve_chain_pair(Points points, const ChainPair& pair, Context& context) {
  return TwoChainsSolver(points, pair, context).run();
}

AlgorithmInfo two_chains_entry() {
  AlgorithmInfo info;
  info.name = "two_chains";
  info.summary = "dynamic programs for two facing reflex chains (corridors)";
  info.source = "lattice-path and interval dynamic programs; Klincsek 1980 for the latter";
  info.guarantee = "optimal; with too little time or memory a certified interval";
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
