#include "geometry/quadtree.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "geometry/numbers/interval.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

using Cell = Quadtree::Cell;

// A point travels with its index, so that splitting a cell reads memory in order.
struct IndexedPoint {
  Point point;
  Index index;
};

void require_usable(Points points, int capacity) {
  if (points.empty()) throw InputError("quadtree: no points; it needs at least one");
  if (capacity < 1) {
    throw InputError(fmt::format("quadtree: capacity {}; a leaf must hold at least 1 point", capacity));
  }
  for (const Point& p : points) {
    const bool usable = std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate;
    if (!usable) throw InputError("quadtree: a coordinate is not finite or beyond 1e300; scale the points down");
  }
}

Cell bounding_square(Points points) {
  Point low = points.front();
  Point high = points.front();
  for (const Point& p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  Cell root;
  root.x = low.x;
  root.y = low.y;
  root.size = std::max(high.x - low.x, high.y - low.y);
  root.right = std::max(low.x + root.size, next_up(high.x));
  root.top = std::max(low.y + root.size, next_up(high.y));
  root.last = static_cast<std::uint32_t>(points.size());
  return root;
}

// Where [low, high) is split: at low + half, which is exact on lattices. Where that rounds to an end (the half is below
// the spacing of doubles), at the middle double; where there is none, at low: the lower part is empty then.
double split_coordinate(double low, double half, double high) {
  const double middle = low + half;
  return low < middle && middle < high ? middle : std::midpoint(low, high);
}

// The four children of `cell` without their points.
std::array<Cell, 4> quarters(const Cell& cell) {
  const double half = cell.size / 2;
  const double middle_x = split_coordinate(cell.x, half, cell.right);
  const double middle_y = split_coordinate(cell.y, half, cell.top);
  const auto depth = static_cast<std::uint8_t>(cell.depth + 1);
  return {Cell{cell.x, cell.y, half, middle_x, middle_y, 0, 0, depth, true},
          Cell{middle_x, cell.y, half, cell.right, middle_y, 0, 0, depth, true},
          Cell{cell.x, middle_y, half, middle_x, cell.top, 0, 0, depth, true},
          Cell{middle_x, middle_y, half, cell.right, cell.top, 0, 0, depth, true}};
}

std::size_t quarter_of(const Point& p, const Cell& north_east) {
  return (p.x >= north_east.x ? 1U : 0U) + (p.y >= north_east.y ? 2U : 0U);
}

// Distributes the cell's points over its children, stably; sets the children's ranges. `scratch` is as long as
// `points`.
std::array<Cell, 4> split(const Cell& cell, std::vector<IndexedPoint>& points, std::vector<IndexedPoint>& scratch) {
  std::array<Cell, 4> children = quarters(cell);
  std::array<std::uint32_t, 4> count{};
  for (std::uint32_t i = cell.first; i < cell.last; ++i) ++count[quarter_of(points[i].point, children[3])];
  std::uint32_t next = cell.first;
  for (std::size_t q = 0; q < 4; ++q) {
    children[q].first = children[q].last = next;
    next += count[q];
  }
  for (std::uint32_t i = cell.first; i < cell.last; ++i) {
    scratch[children[quarter_of(points[i].point, children[3])].last++] = points[i];
  }
  std::copy(scratch.begin() + cell.first, scratch.begin() + cell.last, points.begin() + cell.first);
  return children;
}

}  // namespace

Quadtree::Quadtree(Points points, int capacity) {
  require_usable(points, capacity);
  std::vector<IndexedPoint> moving(points.size());
  for (Index i = 0; i < points.size(); ++i) moving[i] = {points[i], i};
  std::vector<IndexedPoint> scratch(points.size());

  std::vector<Cell> pending{bounding_square(points)};
  while (!pending.empty()) {
    Cell cell = pending.back();
    pending.pop_back();
    cell.is_leaf = cell.last - cell.first <= static_cast<std::uint32_t>(capacity) || cell.depth == kMaximumDepth;
    cells_.push_back(cell);
    if (cell.is_leaf) continue;
    const std::array<Cell, 4> children = split(cell, moving, scratch);
    for (std::size_t q = 4; q-- > 0;) {  // the last one pushed is the first one visited
      if (children[q].first < children[q].last) pending.push_back(children[q]);
    }
  }

  order_.reserve(points.size());
  for (const IndexedPoint& p : moving) order_.push_back(p.index);
}

}  // namespace mwt
