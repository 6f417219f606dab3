// The sides of all triangles, filed so that the two sides of an edge stand next to each other: what edge lists,
// adjacency and the checker are read from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// One side of a triangle, filed under its smaller end.
struct TriangleSide {
  Index other_end = 0;
  Index triangle = 0;
  std::uint8_t corner = 0;   ///< of the triangle, opposite the side
  bool is_ascending = true;  ///< whether it runs from the smaller end to the larger with its triangle on the left
};

/// In each vertex's row, sides are sorted by the other end, ascending ones first, then by triangle.
/// Precondition: indices in range. O(n) buckets plus sorting within rows.
class TriangleSides {
 public:
  explicit TriangleSides(const Triangulation& triangulation);

  [[nodiscard]] std::span<const TriangleSide> row(Index smaller_end) const {
    return std::span(sides_).subspan(first_[smaller_end], first_[smaller_end + std::size_t{1}] - first_[smaller_end]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<TriangleSide> sides_;
};

}  // namespace mwt
