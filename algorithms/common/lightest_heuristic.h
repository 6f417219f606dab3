// The best triangulation that heuristics find in the time that is left: what an exact algorithm returns when something
// stops it.
#pragma once

#include <optional>

#include "algorithms/algorithm.h"

namespace mwt {

/// The lightest of these triangulations, made in this order:
///   (1) that of `flip`;
///   (2) `own`, a valid triangulation if given;
///   (3) that of `patch`, which starts from `greedy` and is never heavier;
///   (4) what patches make of `own`;
///   (5) what patches make of (1), unless (3) is lighter than (1) and (2);
/// all with default parameters. So without a deadline it is never heavier than `greedy`, `patch`, `flip` or `own`.
///
/// Stops at the deadline of `context` with the lightest so far; at least one Delaunay triangulation is made. Of
/// triangulations whose certified weights have equal upper ends, the first.
/// Preconditions: distinct points, not all collinear. O(n log n) in practice: about nine Delaunay triangulations.
/// Deterministic, except for the deadline. Throws std::bad_alloc if there is not even memory for this.
[[nodiscard]] Triangulation lightest_heuristic(Points points, const Context& context,
                                               const std::optional<Triangulation>& own = {});

/// For an exact algorithm that something has stopped: replaces its triangulation, if it has one, by the lightest of
/// that and what heuristics find until deadline_of_heuristics(context.deadline), and lowers the upper end of its
/// certified optimum, if it has one, to the new weight.
void improve_by_heuristics(Points points, Context& context, Solution& solution);

/// When an exact algorithm that must end by `deadline` should leave its own work for improve_by_heuristics() of n
/// points: a quarter of the remaining time before it, or less where that suffices.
[[nodiscard]] Deadline deadline_before_heuristics(const Deadline& deadline, std::size_t n);

/// When an exact algorithm whose work for n points must end by `deadline` should stop and use what is left for a lower
/// bound: a tenth of the remaining time before it, or less where that suffices.
[[nodiscard]] Deadline deadline_before_bounds(const Deadline& deadline, std::size_t n);

/// The deadline for bounds of n points: the given one, but at least as long from now as a Delaunay triangulation takes
/// and 0.05 s, so that there is a bound even when the time limit has passed.
[[nodiscard]] Deadline deadline_of_bounds(const Deadline& deadline, std::size_t n);

/// The deadline for improve_by_heuristics(): the given one, but at least 0.2 s from now, so that small
/// instances are improved even when the time limit has passed.
[[nodiscard]] Deadline deadline_of_heuristics(const Deadline& deadline);

}  // namespace mwt
