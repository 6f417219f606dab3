// Counts all triangulations and finds a lightest one by a dynamic program over monotone paths.
//
// V. Alvarez, R. Seidel, "A simple aggregative algorithm for counting triangulations of planar point sets and related
// problems", SoCG 2013.
#pragma once

#include <optional>

#include "algorithms/algorithm.h"

namespace mwt {

/// Counts are 128 bits wide; n points have fewer than 30^n triangulations (M. Sharir, A. Sheffer, "Counting
/// triangulations of planar point sets", Electronic Journal of Combinatorics 18, 2011), and 30^26 < 2^128.
inline constexpr Index kSubsetDpMaxN = 26;

struct SubsetDpResult {
  Triangulation lightest;
  Interval optimum;   ///< certified weight of a minimum weight triangulation; its upper end is the weight of `lightest`
  std::string count;  ///< of all triangulations, decimal
  std::uint64_t paths = 0;  ///< monotone paths visited
};

/// Sort the points lexicographically, so that none is above another: a sweep by x with vertical ties broken upwards. A
/// path from the first point to the last that goes through them in this order, on empty edges, splits a triangulation
/// into a part below and a part above. It advances over one triangle either by a detour to a point above an edge (p, q
/// -> p, r, q) or by a shortcut above a point (p, r, q -> p, q). From the lower hull to the upper hull every
/// triangulation is passed in exactly one way if always the leftmost possible advance is taken. That is the case
/// exactly if no advance lies wholly to the left of the one before, so it is enough to remember a mark: the leftmost
/// edge that the last advance made. States are (path, mark).
///
/// Degenerate rules: only empty triangles (closed) are advanced over, so edges have no points in their interiors, and
/// turns are strict; hull paths hold all collinear points.
///
/// Preconditions: 3 to kSubsetDpMaxN distinct points, not all collinear.
/// Ties: the first lightest way found. Exact decisions; weights in double-double. Deterministic.
/// O(n^2 2^n) time. 28 bytes per path visited (at most 2^(n - 2)) and 16 bytes per state of two neighbouring layers.
/// Nothing if the deadline or the memory of the context does not suffice; then stop_reason says which.
[[nodiscard]] std::optional<SubsetDpResult> count_and_optimise(Points points, const Context& context,
                                                               std::optional<StopReason>& stop_reason);

[[nodiscard]] AlgorithmInfo subset_dp_entry();

}  // namespace mwt
