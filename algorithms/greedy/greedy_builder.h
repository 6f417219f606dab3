// Turns a Delaunay triangulation into the greedy triangulation: the method of README.md.
#pragma once

#include <cstddef>

#include "algorithms/greedy/greedy.h"

namespace mwt {

/// What make_greedy() does, but for clearing the marks. Faces with more edges than `large_face` are made smaller first,
/// for the cache's sake.
GreedyCounters build_greedy(PlanarMesh& mesh, const Context& context, std::size_t large_face = 10'000);

}  // namespace mwt
