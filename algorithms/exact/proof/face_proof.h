// Notes what proves that a graph's candidates, and the triangulation found among them, are optimal.
#pragma once

#include <span>

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "geometry/triangulation.h"

namespace mwt {

/// Appends to the context's proof, which must be there: the certain edges of the graph, the candidates that cross some
/// of them, and for every face with candidates inside dual values: of the polygon's dynamic program, or of linear
/// programs with branching for faces with holes or isolated vertices. The proof is complete after that.
///
/// The dual values are made from the graph and `triangles` alone: how the faces were solved does not matter.
/// `triangles` may be any triangulation, or none; without an optimal one there is no branching. Faces that are beyond
/// this (too many triangles, no time left) get no dual values, and the proof's lower bound is what the others prove.
/// Uses the threads of the enclosing task arena; the result does not depend on them.
void note_faces(CandidateGraph graph, std::span<const Triangle> triangles, const Context& context);

}  // namespace mwt
