// A minimum weight triangulation of two facing reflex chains, by dynamic programming.
#pragma once

#include "algorithms/algorithm.h"
#include "algorithms/two_chains/chain_pair.h"

namespace mwt {

/// The best triangulation of the region between the two chains of a pair.
struct Corridor {
  std::vector<Triangle> triangles;  ///< counter-clockwise
  Interval cross_edges;             ///< certified bounds on the least total length of edges from chain to chain, the
                                    ///< two bridges included
};

/// Between the chains p_0 .. p_r and q_0 .. q_s (from one bridge to the other) a triangulation is a monotone lattice
/// path from (0, 0) to (r, s): (i, j) stands for the edge p_i q_j, a step for the triangle between two such edges. A
/// shortest path by dynamic programming over double-double sums. O(r s) time and bits, O(s) words.
/// Ties (of sums that agree to about 100 bits): the step along the first chain. Nothing if the deadline passes first.
[[nodiscard]] std::optional<Corridor> triangulate_corridor(Points points, const ChainPair& pair,
                                                           const Deadline& deadline = {});

/// The convex polygons that the chains bound by the O(k^3) polygon program (polygon_dp.h), the corridor as above:
/// together a minimum weight triangulation, because the chains' edges are in every triangulation (chain_pair.h).
///
/// Where the deadline or memory stop it, the optimum is an interval: as triangulate_convex_polygon() says for the
/// chains' polygons; if even the corridor takes too long, only the chains and bridges count, there is no triangulation,
/// and the optimum has no upper end. `pair` is that of the points, which must be scaled (common/solve_scaled.h).
/// Deterministic, except for the deadline.
[[nodiscard]] Solution solve_chain_pair(Points points, const ChainPair& pair, Context& context);

/// Registry entry: solve_chain_pair(). NotApplicable unless the points are such a pair, decided exactly. Where the
/// deadline or memory stop it, the triangulation is the lightest that heuristics find as well
/// (common/lightest_heuristic.h).
[[nodiscard]] AlgorithmInfo two_chains_entry();

}  // namespace mwt
