// `boolean_model`: the source report's Boolean model (section 3), solved as an integer program.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// One 0-1 variable per possible edge, a clause for every pair that crosses, 3 n - 3 - h edges, the least length: the
/// models are exactly the triangulations, so the lightest is a minimum weight triangulation. Branch and cut: linear
/// relaxations with GLPK (edge_program.h), crossing constraints added where a solution violates them, depth-first
/// search over edges that are used in part, from greedy's triangulation as the first upper bound.
///
/// With count=on also the number of models, by enumeration (model_count.h).
///
/// Preconditions: distinct points, not all collinear; NotApplicable beyond max_points. Postcondition: optimal within
/// the certified interval; wider if the deadline passes, and then the lightest of the best model and what heuristics
/// find (common/lightest_heuristic.h). The source report writes triangulation as a formula to argue for NP-hardness;
/// that a problem can be written as a hard one proves nothing about it (claim C14). Time:
/// exponential; the relaxation is weak in convex position, where 9 points on a circle take 84 branchings and 10 take
/// 665. Deterministic, except for the deadline.
[[nodiscard]] AlgorithmInfo boolean_model_entry();

}  // namespace mwt
