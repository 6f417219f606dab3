#include "geometry/triangle_sides.h"

#include <algorithm>
#include <tuple>

namespace mwt {

namespace {

bool in_row_order(const TriangleSide& a, const TriangleSide& b) {
  return std::tuple(a.other_end, !a.is_ascending, a.triangle) < std::tuple(b.other_end, !b.is_ascending, b.triangle);
}

}  // namespace

TriangleSides::TriangleSides(const Triangulation& triangulation)
    : first_(triangulation.point_count + std::size_t{2}, 0), sides_(3 * triangulation.triangles.size()) {
  for (const Triangle& triangle : triangulation.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangle, i);
      ++first_[std::min(side.a, side.b) + std::size_t{2}];
    }
  }
  for (std::size_t v = 2; v < first_.size(); ++v) first_[v] += first_[v - 1];
  for (Index t = 0; t < triangulation.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(triangulation.triangles[t], i);
      const auto [low, high] = std::minmax(side.a, side.b);
      sides_[first_[low + std::size_t{1}]++] = {high, t, static_cast<std::uint8_t>(i), side.a < side.b};
    }
  }
  const auto begin = sides_.begin();
  for (std::size_t v = 0; v < triangulation.point_count; ++v) {
    std::sort(begin + first_[v], begin + first_[v + 1], in_row_order);
  }
}

}  // namespace mwt
