// Exact comparison of lengths and of sums of lengths.
#pragma once

#include <optional>
#include <vector>

#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// Sign of |e| - |f|, exact.
[[nodiscard]] int compare_edge_lengths(Points points, const Edge& e, const Edge& f);

/// Sign of (sum of the lengths of `a`) - (sum of the lengths of `b`), edges between distinct points; consumes both
/// lists.
///
/// Exact: equal lengths cancel; what remains are roots of integers after scaling by a power of two. Roots of integers
/// are linearly independent over the rationals unless the product of two of them is a perfect square (A. S.
/// Besicovitch, "On the linear independence of fractional powers of integers", J. London Math. Soc. 15 (1940)), which
/// decides equality; sums that differ are compared by integer roots of 256, 1024, ... bits behind the point.
/// Failure mode: nothing, if 2^14 such bits are not enough; no such sums are known.
///
/// O(m log m) comparisons of lengths for m edges; what does not cancel costs O(m^2) integer roots.
[[nodiscard]] std::optional<int> compare_length_sums(Points points, std::vector<Edge>& a, std::vector<Edge>& b);

}  // namespace mwt
