// Greedy's order of edges: exact squared length, then smaller label, then larger label.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/numbers/double_double.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/triangulation.h"

namespace mwt {

/// An edge between two points with what it takes to place it in the order, nearly always without looking at them again.
struct EdgeKey {
  DoubleDouble squared_length;  ///< relative error at most 2^-97 in the trusted range of products, rough beyond
  Index a = 0;
  Index b = 0;
  std::uint32_t tag = 0;  ///< the caller's
  bool exact = false;     ///< squared_length is exact
};

/// Whether the two edges join the same points.
[[nodiscard]] inline bool is_same_edge(const EdgeKey& one, const EdgeKey& two) {
  return (one.a == two.a && one.b == two.b) || (one.a == two.b && one.b == two.a);
}

/// Whether the keys alone show that `one` is shorter; transitive.
[[nodiscard]] bool is_surely_shorter(const EdgeKey& one, const EdgeKey& two);

/// The strict total order on the edges between some points. Exact for arbitrary doubles, and the same for points that
/// are scaled by a power of two. Squared lengths that are doubles or double-doubles themselves (lattices, integers) and
/// congruent differences of coordinates are recognised, so that the many ties of grids stay cheap.
class EdgeOrder {
 public:
  /// labels[i] is the number of points[i] that decides between edges of equal length; its own number i if there are
  /// none.
  explicit EdgeOrder(Points points, std::span<const Index> labels = {}) : points_(points), labels_(labels) {}

  [[nodiscard]] EdgeKey key(Index a, Index b, std::uint32_t tag = 0) const;

  [[nodiscard]] bool precedes(const EdgeKey& one, const EdgeKey& two) const {
    const double x = one.squared_length.high, y = two.squared_length.high;
    return surely_differ(x, y) ? x < y : precedes_slow(one, two);
  }

  /// Sorts edges whose lengths are nearly equal. O(m log m); faster where many are of one length.
  void sort(std::span<EdgeKey> edges) const;

  /// Whether rounded squared lengths show which edge is shorter, unless they leave the trusted range.
  [[nodiscard]] static bool surely_differ(double x, double y) {
    constexpr double kSquareError = 1e-15;  // each errs by less than 4.5e-16 of itself
    return std::abs(x - y) > kSquareError * (x + y) && is_trusted_product(x + y);
  }

 private:
  [[nodiscard]] Edge labelled(Index a, Index b) const {
    return labels_.empty() ? make_edge(a, b) : make_edge(labels_[a], labels_[b]);
  }
  [[nodiscard]] bool precedes_slow(const EdgeKey& one, const EdgeKey& two) const;
  [[nodiscard]] int compare_lengths(const EdgeKey& one, const EdgeKey& two) const;
  [[nodiscard]] bool have_equal_lengths(const EdgeKey& one, const EdgeKey& two) const;
  void sort_nearly_equal(std::span<EdgeKey> edges) const;
  void sort_by_labels(std::span<EdgeKey> edges) const;

  Points points_;
  std::span<const Index> labels_;
};

/// Sorts `edges` (a < b in each) in the order of their lengths, then a, then b. O(m log m) time, 16 bytes per edge of
/// extra space and 32 per edge of the longest run that rounding leaves undecided. If `must_stop`, called once per
/// 65,536 steps, returns true, the sort ends: then false, and the edges are in no order.
[[nodiscard]] bool sort_by_length(Points points, std::vector<Edge>& edges, const std::function<bool()>& must_stop);

/// The same without a stop.
void sort_by_length(Points points, std::vector<Edge>& edges);

}  // namespace mwt
