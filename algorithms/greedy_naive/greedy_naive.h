// The greedy triangulation as the source report writes it (section 5.1): all pairs, sorted; the shortest that fits is
// in.
#pragma once

#include <optional>

#include "algorithms/algorithm.h"

namespace mwt {

/// The greedy triangulation. Goes through all pairs of points in the order of sort_by_length() (exact length, then
/// smaller index, then larger index), keeps a pair as an edge if it crosses no edge kept before (segments_cross()), and
/// stops when 2n - h - 2 triangles have come together.
///
/// Triangles are listed in the order in which their last edge is found, those of one edge by their third corner; each
/// starts at its smallest index and runs counter-clockwise. Three pairwise joined points are a triangle exactly if no
/// other point lies in it, boundary included; since edges do not cross, such triangles cannot overlap.
///
/// Collinear points need no rule of their own: if c lies on segment ab, take the point c of that kind nearest to a. The
/// shorter pair ac came earlier and either is an edge, which ab would overlap, or crosses one, which ab crosses as
/// well. So no edge ever passes through a point.
///
/// Preconditions: distinct points, not all collinear; at most 10,000, otherwise NotApplicable. Deterministic. O(n^2)
/// space for the pairs. O(n^3) tests in the worst case, since the edges kept are fewer than 3n (the source report's
/// O(n^4) counts n^2 of them); a box test in front settles most.
[[nodiscard]] Triangulation greedy_naive(Points points);

/// The same; nothing if the deadline passes first, for an unfinished greedy is no triangulation.
/// `steps`, if not null, gets the edges as they are kept.
[[nodiscard]] std::optional<Triangulation> greedy_naive(Points points, const Deadline& deadline,
                                                        StepTrace* steps = nullptr);

/// Registry entry. Where the deadline or memory stop it, the triangulation is that of `greedy`, which is the same.
[[nodiscard]] AlgorithmInfo greedy_naive_entry();

}  // namespace mwt
