// `boolean_model`: the source report's Boolean model (section 3), solved as an integer program.
#pragma once

#include "algorithms/algorithm.h"

namespace mwt {

/// One 0-1 variable per possible edge, a clause for every pair that crosses, 3 n - 3 - h edges, the least length: the
/// models are exactly the triangulations, so the lightest is a minimum weight triangulation. A linear relaxation with
/// GLPK (edge_program.h), crossing constraints added where a solution violates them, bounds the length and decides most
/// variables by their reduced costs, given the best of two models (greedy's, and what the relaxation uses most). A
/// search decides the others (model_search.h); where the relaxation is weak, in convex position, that are all, but they
/// fall into few parts.
///
/// With count=on also the number of models, by the same search with nothing decided.
///
/// Preconditions: distinct points, not all collinear; NotApplicable beyond max_points. Postcondition: optimal within
/// the certified interval; wider if the deadline passes or the parts need too much memory, and then the lightest of the
/// best model and what heuristics find (common/lightest_heuristic.h). The source report writes triangulation as a
/// formula to argue for NP-hardness; that a problem can be written as a hard one proves nothing about it (claim C14).
/// Time: exponential. Deterministic, except for the deadline.
[[nodiscard]] AlgorithmInfo boolean_model_entry();

}  // namespace mwt
