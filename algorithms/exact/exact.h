// `exact`: a minimum weight triangulation with a proof, at any size.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// The stages, each a unit of its own, the first four in candidates/ and division/, the last in faces/:
///   1. kd_order: neighbours in the plane become neighbours in memory;
///   2. diamond_candidates: all edges that may be in a minimum weight triangulation, about 11.6 n (long_edges: those
///      much longer than the distance to the nearest neighbour are tested against all points);
///   3. lmt_skeleton: deletes edges that are locally minimal in no quadrilateral; about 3.8 n stay;
///   4. certain_edges: those that nothing crosses any more, about 2.5 n, are in every optimum (up to ties);
///      certain_division: unless these connect all points, edges of the beta-skeleton are certain, too;
///   5. face_solver: each face of the certain edges: polygons by dynamic programs, faces with one hole by shortest
///      paths in their universal cover; faces with more are cut open, bounded by dual values and divided
///      (holes/region_solver.h), and what is left are linear programs or branching.
/// All points on the hull: instead of stages 2 to 5 a program over intervals (polygon_dp/convex_polygon.h). Two facing
/// chains of 1,000 points or more: `two_chains`.
///
/// Preconditions: distinct points, not all collinear. Collinear triples, ties and all magnitudes are normal input.
/// Postcondition: the triangulation's weight is the optimum's upper end, and the optimum is certified from below. Where
/// the deadline, memory or a size stop a stage, the result is a valid triangulation with a wider interval, never an
/// abort, and `stop_reason` says which; the size that stops it is a count of candidates beyond max(3*10^7, 64 n). The
/// triangulation is then the lightest that heuristics find in the time that is left, for which the stages end a little
/// before the deadline (common/lightest_heuristic.h): never heavier than those of `greedy`, `patch` and `flip`, time
/// permitting. Ties: between optima of equal weight, the order of the points decides. Time: about n log n on inputs of
/// gradually varying or clustered density; the general problem is NP-hard (Mulzer and Rote 2008). Deterministic,
/// whatever context.threads.
///
/// After A. Haas, "Solving large-scale minimum-weight triangulation instances to provable optimality", SoCG 2018, and
/// the papers named in the stages' headers; data structures and vector code are this project's own.
[[nodiscard]] Solution exact(Points points, Context& context);

[[nodiscard]] AlgorithmInfo exact_entry();

}  // namespace mwt
