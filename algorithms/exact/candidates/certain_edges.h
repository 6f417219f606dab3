// Third stage of the exact solver: sorts the surviving edges around their vertices and marks those that are certain.
#pragma once

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/candidates/stars.h"

namespace mwt {

/// The graph of the edges left in `stars`, for the face solver. An edge through another point is dropped: the
/// nearer of two neighbours in exactly the same direction stays.
///
/// An edge st is certain if no surviving edge yw between neighbours y, w of s crosses it. That suffices: were st
/// missing from a minimum weight triangulation, st would enter a triangle syw of it at s and leave through yw, and all
/// three edges of that triangle survived.
///
/// Exact. In small stars one look-up per pair of a vertex's neighbours; in large ones, for each edge st and neighbour y
/// until one is found, a bisection for the edges of y between its directions to s and t. Runs on the threads of the
/// enclosing task arena; the result does not depend on them. Throws SearchStopped (search_stopped.h) after the
/// context's deadline.
[[nodiscard]] CandidateGraph mark_certain_edges(Points points, const StarTable& stars, const Context& context);

}  // namespace mwt
