// Second stage of the exact solver: the locally minimal triangulation (LMT) skeleton.
#pragma once

#include "algorithms/exact/candidates/diamond_candidates.h"
#include "algorithms/exact/candidates/lmt_kernels.h"
#include "algorithms/exact/candidates/stars.h"

namespace mwt {

struct LmtSkeleton {
  StarTable stars;  ///< the surviving edges, each in both ends' stars
  LmtCounters counters;
};

/// Deletes candidates that are not locally minimal in any quadrilateral of surviving candidates, until none is left
/// (Dickerson and Montague 1996; Beirouti and Snoeyink 1998). The candidates are those of the diamond test, which is
/// used up.
///
/// Edges within a block first, longest first, as soon as the diamond test has found them, blocks in parallel; then, up
/// the k-d tree, the edges between a node's two
/// children: an edge touches the stars of its two ends only, so nodes of one level do not disturb each other, and the
/// result does not depend on the number of threads. Runs on the threads of the enclosing task arena.
/// Throws SearchStopped (search_stopped.h) after the context's deadline, or when there are too many candidates.
[[nodiscard]] LmtSkeleton find_lmt_skeleton(const KdOrder& order, const HullEdges& hull, DiamondTest& test,
                                            const Context& context);

/// Goes on with the edges between two stars of more than Star::kMaxExamined edges, longest first: up to cubic time, for
/// inputs whose other edges do not divide. Returns how many edges it has deleted. One thread.
/// Throws SearchStopped (search_stopped.h) after the context's deadline.
std::uint64_t examine_between_large_stars(StarTable& table, const KdOrder& order, const HullEdges& hull,
                                          const Context& context);

}  // namespace mwt
