// The local search of the source report (section 5.3): flip edges as long as that shortens the triangulation.
#pragma once

#include <limits>
#include <optional>

#include "algorithms/algorithm.h"

namespace mwt {

enum class FlipImprovement {
  first,  ///< the source report's loop: pass over all edges, flip each that improves, until a pass flips none
  best,   ///< always the flip with the largest gain
};

inline constexpr std::size_t kAnyNumberOfFlips = std::numeric_limits<std::size_t>::max();

struct FlipSearch {
  Triangulation triangulation;
  std::vector<Flip> flips;     ///< in the order in which they were made
  Index passes = 0;            ///< over all edges, the last, idle one included; only for FlipImprovement::first
  bool stopped_early = false;  ///< the deadline came before the local optimum
};

/// Local search from a valid triangulation. A flip replaces the diagonal AB of a strictly convex quadrilateral ACBD by
/// CD; the perimeters change by 2 (|CD| - |AB|) in all, so it improves exactly if |CD| < |AB|, which compare_length()
/// decides exactly. (The source report also tests whether CD crosses an edge: it cannot, inside an empty convex
/// quadrilateral.)
///
/// first: each pass visits the edges that exist when it starts, by smaller index, then larger index, each in the state
/// that the flips before it have left. best: by gain to about 100 bits; equal gains by the removed edge's indices, then
/// the added one's.
///
/// Ends at a local optimum: no flip shortens it; since each flip shortens the total strictly, it does end. Nothing is
/// known about its distance to the optimum beyond Theta(n) in bad cases (families flip_corridor, delaunay_flip_stuck).
/// It stops after `max_flips` flips, or at the deadline, saying for the latter that it did.
/// O(n log n) per pass (first), O((n + flips) log n) (best), O(n + flips) space. Deterministic.
[[nodiscard]] FlipSearch flip_search(Points points, const Triangulation& start, FlipImprovement improvement,
                                     const Deadline& deadline, std::size_t max_flips = kAnyNumberOfFlips);

/// Registry entry: start = delaunay | sweep | greedy (the source report's), or a triangulation given in context.start.
[[nodiscard]] AlgorithmInfo flip_naive_entry();

}  // namespace mwt
