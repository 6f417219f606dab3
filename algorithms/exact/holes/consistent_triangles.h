// The strongest form of the LMT idea, for the few regions that need it: which triangles can have suitable neighbours at
// all.
#pragma once

#include <span>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// Of the given triangles those that remain when, again and again, every triangle is dropped that has a side, not on
/// the boundary, across which no remaining triangle fits: the side must be locally minimal in the quadrilateral of the
/// two (not strictly convex, or the side not longer than the other diagonal).
///
/// Every triangle of every minimum weight triangulation remains, if it was given, since flips do not improve an
/// optimum. This subsumes the advanced LMT test of Haas (SoCG 2018), which looks one triangle further than the normal
/// test.
///
/// `boundary`: directed edges with the region on their left, sides of exactly one triangle. Order is kept.
/// Time: the number of pairs of triangles with a common side, each compared at most once; space O(triangles).
[[nodiscard]] std::vector<Triangle> consistent_triangles(Points points, std::span<const Triangle> triangles,
                                                         std::span<const Edge> boundary);

}  // namespace mwt
