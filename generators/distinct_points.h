// Drawing n distinct points that span a triangle, by drawing again whatever is already there.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/convex_hull.h"
#include "geometry/point.h"

namespace mwt {

/// Points in the order of their insertion, equal ones (-0 = 0) only once. A hash table with open addressing: expected
/// O(1) time and 11 to 22 bytes per point besides the points. What it holds does not depend on the hash.
class DistinctPoints {
 public:
  /// For up to `capacity` points.
  explicit DistinctPoints(Index capacity);

  /// Appends p; false if an equal point is there already. Precondition: size() < capacity.
  bool insert(Point p);

  [[nodiscard]] Index size() const { return static_cast<Index>(points_.size()); }
  [[nodiscard]] std::vector<Point> take() { return std::move(points_); }

 private:
  // Part of the hash beside the position saves nearly all looks at points_, which would miss the cache.
  struct Slot {
    std::uint32_t hash = 0;
    Index position = kNoIndex;  // in points_
  };

  std::vector<Point> points_;
  std::vector<Slot> slots_;  // the size is a power of two
};

/// Counts draws and gives up when there are far too many of them (100 per point and a million more).
class DrawingBudget {
 public:
  DrawingBudget(std::string family, Index n);

  /// Throws InputError if the budget is used up; `found` is how many points there are so far.
  void spend_one(Index found);

 private:
  std::string family_;
  Index n_;
  std::uint64_t left_;
};

/// n points draw(0), .., draw(n - 1), each drawn again while it equals an earlier one, and all of them while they lie
/// on one line. Precondition: n >= 3. Expected O(n) draws unless the family can give hardly more than n points. Throws
/// InputError naming the number of points that it found if the family cannot give n of them.
template <class Draw>
[[nodiscard]] std::vector<Point> draw_distinct_points(const std::string& family, Index n, Draw draw) {
  DrawingBudget budget(family, n);
  for (;;) {
    DistinctPoints found(n);
    while (found.size() < n) {
      budget.spend_one(found.size());
      found.insert(draw(found.size()));
    }
    std::vector<Point> points = found.take();
    if (!all_collinear(points)) return points;
  }
}

}  // namespace mwt
