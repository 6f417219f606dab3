// The diamond test against all points: for edges that reach beyond what near points can decide.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/exact/candidates/kd_order.h"

namespace mwt {

/// Searches the k-d tree for points in the diamond triangles (direction_bins.h) of edges between two leaves.
///
/// The tables of the diamond test see 56 directions and the nearest hundred points or so. An edge that leaves a chain
/// of points almost along it passes them: the chain lies in the edge's own bin, and beyond the near points nothing is
/// looked at. Each such edge crosses short edges of the chain, which are then no longer certain.
///
/// Holds the space that the search needs: one object per thread.
class LongEdgeTest {
 public:
  /// The order must stay alive.
  explicit LongEdgeTest(const KdOrder& order);

  /// The edges asked for next lead from one of these leaves to the other.
  void start(std::uint32_t leaf, std::uint32_t other_leaf);

  /// Whether each of the two open triangles of edge pq holds a point, or a point lies in the edge's interior: then no
  /// minimum weight triangulation contains the edge.
  ///
  /// Nothing is concluded from points so near to the triangles' upper sides that doubles may be mistaken, and from
  /// those within 1e-280 of an end, the extent of all points being about 2^60; all else is exact.
  [[nodiscard]] bool is_excluded(Index p, Index q);

  /// The same for any edge, by a search of its own. O(log n + leaves that meet a triangle but have no point in it).
  [[nodiscard]] bool is_excluded_by_any(Index p, Index q) const;

 private:
  void gather();

  const KdOrder& order_;
  double scale_;  // power of two that keeps products of coordinates within range
  std::uint32_t leaf_ = 1;
  std::uint32_t other_leaf_ = 1;
  bool has_gathered_ = false;
  bool has_all_ = false;   // whether the points below are all that lie in a triangle of any edge between the leaves
  std::vector<double> x_;  // the points gathered; NaN up to a multiple of the vectors' size
  std::vector<double> y_;
};

}  // namespace mwt
