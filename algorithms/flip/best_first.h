// Best-first search by flips, played where the edges lie in memory.
#pragma once

#include "algorithms/flip/flip.h"

namespace mwt {

/// Enough edges that few flips touch those of another portion, few enough that a processor's cache holds them.
inline constexpr std::size_t kBestFirstPortion = 8192;

/// FlipOrder::best of flip_to_local_optimum(): again and again the flip that improves with the largest gain; of equal
/// gains (in doubles) the one of the larger edge number.
///
/// In that order, flips are scattered over memory. Yet a flip depends on its neighbourhood only: it reads and writes
/// the two triangles at its edge and reads those beyond its sides, where it may make flips possible. So the search is
/// played portion by portion of the edges, each portion best-first, and what came too early is taken back:
///
///   - The *time* of a flip is the smallest (gain, edge) that the search has taken until then, itself included: times
///     fall. A *burst* is a flip and those of larger gain that it makes possible; they share a time, and nothing else
///     comes between them.
///   - Invariant, after each portion: the mesh is the result of a best-first search that starts with only those
///     flips that are possible at the edges looked through so far.
///   - A portion adds its flips to that search, in the order of their times. Before one of time t looks at its
///     neighbourhood, all later flips there are taken back, each with its whole burst and with all that came after it
///     in its own neighbourhood. So it reads the triangles of time t, and flips that remain read nothing that changed.
///     What was taken back and is possible joins the search again.
///   - The last portion's invariant is the claim. Before a flip changes the triangles of an edge not looked through
///     yet, that edge is looked at, so that every edge is looked at in the mesh of the start.
///
/// With a trace there is one portion of all edges, nothing to take back, and the flips come in the order of the search.
/// `portion` has no effect on the result, except where the deadline stops the search: then it is optimal for some
/// portions and untouched in others. FlipResult::tests counts edges that are looked at again.
///
/// Where flips reach far, as in fans along curves, much would be taken back again and again: once it outweighs the
/// edges looked through, all the others are looked through at once, and the search starts anew from what is done. So
/// O(n) flips are taken back in all (1% of the flips on uniform points).
///
/// Precondition: portion > 0. O((n + flips) log n) time, 12 bytes per point and 32 per flip of extra space.
/// Deterministic.
FlipResult flip_best_first(PlanarMesh& mesh, const Context& context, bool with_trace,
                           std::size_t portion = kBestFirstPortion);

}  // namespace mwt
