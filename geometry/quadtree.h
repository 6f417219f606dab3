// The bare quadtree of the source report (sections 5.4 and 6.5): a square split in four until cells hold few points.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// A quadtree over distinct points as a flat array of cells in depth-first order, children south-west, south-east,
/// north-west, north-east.
///
/// The root is the points' bounding square. Cells are half-open and partition their parent exactly: a cell holds the
/// points with x <= p.x < right and y <= p.y < top, compared as doubles, so that every point lies in exactly one leaf.
/// The root's right and top are enlarged just enough (to the next double) to hold the rightmost and topmost points.
///
/// A cell is split while it holds more than `capacity` points, down to `kMaximumDepth` levels, where a leaf may hold
/// more: clusters finer than the square's side / 2^kMaximumDepth end there. Any distribution: empty children cost
/// nothing, and there is no recursion. O(n depth) time, O(n) leaves that hold points. Deterministic; within a leaf the
/// points keep the order of the input.
class Quadtree {
 public:
  static constexpr int kMaximumDepth = 48;

  struct Cell {
    double x = 0;  ///< south-west corner
    double y = 0;
    double size = 0;          ///< side of the square, the root's / 2^depth; x + size is `right` up to rounding only
    double right = 0;         ///< first abscissa beyond the cell: test membership against it
    double top = 0;           ///< first ordinate beyond the cell
    std::uint32_t first = 0;  ///< its points are order()[first .. last)
    std::uint32_t last = 0;
    std::uint8_t depth = 0;
    bool is_leaf = true;

    [[nodiscard]] bool contains(const Point& p) const { return x <= p.x && p.x < right && y <= p.y && p.y < top; }
  };

  /// Preconditions: at least one point, capacity >= 1, coordinates finite and at most 1e300 in magnitude (otherwise
  /// InputError).
  Quadtree(Points points, int capacity);

  /// All cells with at least one point, root first.
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }

  /// The points' indices, those of one cell side by side.
  [[nodiscard]] std::span<const Index> order() const { return order_; }

  [[nodiscard]] std::span<const Index> points_of(const Cell& cell) const {
    return order().subspan(cell.first, cell.last - cell.first);
  }

 private:
  std::vector<Cell> cells_;
  std::vector<Index> order_;
};

}  // namespace mwt
