// Points that show why an edge passes or fails a test of the exact solver.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The candidates that are left, as neighbours of each point.
class CandidateStars {
 public:
  explicit CandidateStars(std::size_t points) : neighbours_(points) {}

  void add(const Edge& edge);
  void remove(const Edge& edge);
  /// Ascending.
  [[nodiscard]] const std::vector<Index>& neighbours(Index point) const { return neighbours_[point]; }

 private:
  std::vector<std::vector<Index>> neighbours_;
};

/// For display, not for decisions: distances are rounded. Both searches look at the points whose abscissas are in
/// question, and return nothing once they have looked at 2^28 points in all: pictures of large sets do without.
class EdgeWitnesses {
 public:
  /// Left and right of the edge from its first end, kNoIndex where there is none.
  using Sides = std::array<Index, 2>;

  explicit EdgeWitnesses(Points points);

  /// A point inside each of the two triangles on the edge with base angles of pi/4.6: its diamond. Points on or very
  /// near their sides do not count, as in the diamond test.
  [[nodiscard]] std::optional<Sides> in_diamond(const Edge& edge);

  /// On each side, of the empty triangles whose two other sides are candidates, the third corner of the one with the
  /// largest angle there. Exact.
  [[nodiscard]] std::optional<Sides> apexes(const Edge& edge, const CandidateStars& candidates);

 private:
  template <class Test>
  [[nodiscard]] Index find(double left, double right, const Test& test);
  [[nodiscard]] Index inside_half_diamond(const Edge& edge, double side);
  [[nodiscard]] bool is_empty(const std::array<Index, 3>& triangle);

  std::vector<Point> points_;
  std::vector<Index> by_x_;
  std::vector<double> xs_;
  std::uint64_t work_ = 0;
};

}  // namespace mwt
