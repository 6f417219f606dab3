// All regions that inserting points by splitting triangles has made: it finds the triangle that holds a point, however
// deeply nested.
#pragma once

#include <span>
#include <vector>

#include "algorithms/hull_insertion/preferred_paths.h"
#include "algorithms/step_trace.h"
#include "geometry/triangulation.h"

namespace mwt {

/// A list of triangles and insertions into it one by one, to the same effect as insert_by_splitting().
///
/// The regions form a tree: the polygon's part, the parts that its triangulation cuts off, the triangles, and the
/// triangles into which these were split. A region lies in its parent, so whether it holds a point can be searched
/// along paths (PreferredPaths). The list is the tree's leaves from left to right, written once at the end.
///
/// Exact predicates only. Amortised O(log^2 n) time per insertion for any points in any order, 32 bytes per region, at
/// most 4 regions per point.
class SplitHistory {
 public:
  /// Starts from a single triangle; room is made for `expected_points`.
  SplitHistory(Points points, const Triangle& triangle, std::size_t expected_points);

  /// Starts from the part of a convex polygon right of the chord from the first to the last vertex of `chain`.
  /// `triangles` triangulates it in the preorder of triangulate_polygon().
  SplitHistory(Points points, std::span<const Index> chain, std::span<const Triangle> triangles,
               std::size_t expected_points);

  /// Precondition: p lies inside the triangle or part, or on its boundary, except on a side of `chain`; it is no corner
  /// yet.
  void insert(Index p);

  /// From now on, each triangle that is split is noted there; null: no longer.
  void note_splits_in(std::vector<TracedSplit>* splits) { splits_ = splits; }

  /// The current list.
  [[nodiscard]] std::vector<Triangle> triangles() const;

  /// Triangles so far that were split by a point on one of their sides.
  [[nodiscard]] std::size_t edge_splits() const { return edge_splits_; }

  /// The largest number of splits that led to one triangle. O(n).
  [[nodiscard]] std::size_t depth() const;

 private:
  struct Region {
    Triangle corners;  // a triangle; or the part of the polygon right of the chord corners[0] -> corners[1]
    Index first_child = kNoIndex;
    Index child_count = 0;
  };
  struct Place;

  void add_parts(Index region, std::span<const Index> chain, std::span<const Triangle> triangles);
  void reserve(std::size_t count);
  void add_child(Index parent, const Triangle& corners);
  [[nodiscard]] Index triangle_at(const Place& place);
  [[nodiscard]] bool contains(Index region, const Place& place) const;
  Index split(Index region, Index p);

  Points points_;
  std::vector<Region> regions_;
  PreferredPaths paths_;
  std::size_t edge_splits_ = 0;
  std::vector<TracedSplit>* splits_ = nullptr;
};

}  // namespace mwt
