// Recognises point sets that consist of two facing reflex chains.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "geometry/point.h"

namespace mwt {

/// Two chains of at least 2 points that hold all points between them. Properties, decided by exact predicates:
///   (1) each chain runs around its own convex hull, counter-clockwise: every triple turns left or straight on, and the
///       edge from its end back to its start closes the polygon;
///   (2) the hull of all points has 4 boundary points: the ends of both chains. Two of its edges close the polygons,
///   the
///       other two, from the start of one chain to the end of the other, are the bridges;
///   (3) every point of one chain lies strictly to the right of every edge of the other.
///
/// Then no segment between two of the points crosses an edge of a chain: between points of one chain it stays in their
/// polygon, and between points of both it leaves each polygon at once and for good, by (3). So the chains' edges are in
/// every triangulation, and between the chains all triangles have two corners on one and one on the other.
struct ChainPair {
  std::vector<Index> first;
  std::vector<Index> second;
};

/// The pair for some partition of the points; nothing if no partition is one, or if all points lie on their hull's
/// boundary, where polygon programs serve better. Preconditions: distinct points, not all collinear.
/// O(n log^2 n + candidates * |first| |second|), where nearly always at most one candidate is examined in full.
/// Deterministic. Nothing either if the deadline passes during that examination.
[[nodiscard]] std::optional<ChainPair> find_chain_pair(Points points, const Deadline& deadline = {});

}  // namespace mwt
