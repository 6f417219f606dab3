// The Delaunay triangulation as linked triangles, built for speed: what the planar mesh starts from.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/mesh/kept_memory.h"
#include "geometry/point.h"

namespace mwt {

/// A side of a triangle: 4 * triangle + i, i in {0, 1, 2}, going from the triangle's corner i to corner i + 1 (mod 3).
using Side = std::uint32_t;

/// A triangle, counter-clockwise. Ghosts, one outside every edge of the hull, have the corner `point count`, which
/// stands for a point at infinity; with them every side has a twin.
struct LinkedTriangle {
  std::array<Index, 3> corners;
  std::array<Side, 3> twins;  ///< for side i, the same edge seen from the triangle across it
};

/// The Delaunay triangulation of `points`, ghosts included; cocircular ties fall as the order of insertion has it.
///
/// Incremental: points enter in random rounds of growing size (A. Amenta, S. Choi, G. Rote, "Incremental constructions
/// con BRIO", SoCG 2003; the rounds come from a fixed hash), each round in the given order; every point is found by
/// walking from the one before, and the triangles whose circles it hits are replaced by its star (A. Bowyer, D. F.
/// Watson, The Computer Journal 24, 1981). Decisions are exact, so the replaced region is always star-shaped.
///
/// `points` gets a point at infinity at its end until the call returns: with room for it, nothing is copied.
///
/// Preconditions: distinct points, not all collinear (otherwise std::logic_error), fewer than 2^29, in spatial order
/// for speed (any order for correctness). Expected O(n log n) time, in practice linear; 48 bytes per point.
/// Deterministic.
[[nodiscard]] KeptVector<LinkedTriangle> delaunay_triangles(KeptVector<Point>& points);

}  // namespace mwt
