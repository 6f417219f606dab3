// Bounds for convex polygons of so many vertices that the program over all intervals takes too long.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/polygon_dp/convex_chords.h"
#include "algorithms/polygon_dp/interval_band.h"
#include "geometry/triangulation.h"

namespace mwt {

struct ConvexBounds {
  double diagonals_at_least = 0;    ///< certified; in units of coordinates
  std::vector<Triangle> triangles;  ///< a triangulation, by positions in the polygon; none if a side of the polygon has
                                    ///< too many vertices
};

/// Two programs over intervals, coarser and coarser: level 0 has all intervals up to `longest` vertices long, level l
/// those up to 2^l times as long, but only between every 2^l-th vertex or block of 2^l vertices. At the last level the
/// intervals reach around half the polygon, and the best three of them around it, none longer than that, are the
/// result: every triangulation has a triangle that leaves at most half of the vertices on each of its sides. (Longer
/// intervals would do as well, but where they wrap around, blocks are near each other and F below is loose.)
///
/// **From above**, an interval of level l is split at every 2^l-th vertex only; what level l - 1 has is taken from
/// there. On a circle this is within .02% of the optimum with longest = 256.
///
/// **From below**, level l bounds for blocks U and V
///     F(U, V) <= cost(i, j) - (P(j) - P(i))   for all i in U, j in V,
/// where cost(i, j) is that of the best triangulation from vertex i to vertex j, chord included. P, the potential,
/// grows by what another vertex costs at intervals of this length, so that the difference hardly varies within the
/// blocks. It may be anything that does not fall; level l has its own, and a change of potentials within a block is
/// paid for. F is
///     the least of the four F of their halves (with the change of potentials), where level l - 1 has them, else
///     chord + min over blocks W between of F(U, W) + F(W, V) + min(0, chord - p(U) - p(V)),
/// chord being the least distance between the blocks and p(U) the growth of P within U. Proof of the latter: let (i, j)
/// have the least difference. Follow the splits from (i, j) as long as they lie in U or V, to (i', j'), which is split
/// outside both: what it costs is at least the first two terms. Each of the s splits passed costs a chord, and the
/// intervals cut off within U and V have costs of at least 0, so differences of at least -p(U) - p(V) in total. The sum
/// is as stated for s >= 1, and without the last term for s = 0.
/// If two corners of the last triangle lie in one block U, what lies between them costs at least -p(U) likewise.
/// On circles of about 8,000 vertices the bound misses the optimum by .5% with longest = 128, by .2% with 256 and by
/// .06% with 512; on random points of a circle by 2.3% with 128.
///
/// About 1.5 n longest^2 sums, 24 n longest bytes and more. Integers throughout, so that no rounding is involved beyond
/// that of lengths. Nothing if the deadline passes first. Deterministic; runs on the threads of the enclosing arena.
/// Precondition: polygons of at least 4 * longest vertices, longest = reach * kTile.
[[nodiscard]] std::optional<ConvexBounds> bound_convex_polygon(const ConvexChords& chords, std::size_t reach,
                                                               const Deadline& deadline);

/// Bytes that bound_convex_polygon() takes.
[[nodiscard]] std::uint64_t bytes_for_convex_bounds(std::size_t n, std::size_t reach);

}  // namespace mwt
