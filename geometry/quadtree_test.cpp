#include "geometry/quadtree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/error.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

using Cell = Quadtree::Cell;

// The children of cell i: the cells of the next depth in its subtree, which follows it in depth-first order.
std::vector<Cell> children_of(std::span<const Cell> cells, std::size_t i) {
  std::vector<Cell> children;
  for (std::size_t j = i + 1; j < cells.size() && cells[j].depth > cells[i].depth; ++j) {
    if (cells[j].depth == cells[i].depth + 1) children.push_back(cells[j]);
  }
  return children;
}

// 0 south-west, 1 south-east, 2 north-west, 3 north-east.
int quarter_in(const Cell& parent, const Cell& child) {
  return (child.right == parent.right && child.x != parent.x ? 1 : 0) +
         (child.top == parent.top && child.y != parent.y ? 2 : 0);
}

void expect_leaves_partition_the_points(const Quadtree& tree, std::size_t n, int capacity) {
  std::vector<int> times_seen(n, 0);
  for (const Cell& cell : tree.cells()) {
    ASSERT_LT(cell.first, cell.last);
    if (!cell.is_leaf) continue;
    if (cell.depth < Quadtree::kMaximumDepth) {
      ASSERT_LE(cell.last - cell.first, static_cast<std::uint32_t>(capacity));
    }
    for (const Index i : tree.points_of(cell)) ++times_seen[i];
    ASSERT_TRUE(std::is_sorted(tree.points_of(cell).begin(), tree.points_of(cell).end()));
  }
  ASSERT_TRUE(std::all_of(times_seen.begin(), times_seen.end(), [](int times) { return times == 1; }));
}

void expect_children_partition_their_parents(const Quadtree& tree, int capacity) {
  const auto cells = tree.cells();
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (cells[i].is_leaf) continue;
    ASSERT_GT(cells[i].last - cells[i].first, static_cast<std::uint32_t>(capacity));
    std::uint32_t next = cells[i].first;
    int previous_quarter = -1;
    for (const Cell& child : children_of(cells, i)) {
      ASSERT_EQ(child.first, next);
      next = child.last;
      ASSERT_EQ(child.size, cells[i].size / 2);
      ASSERT_TRUE(cells[i].x <= child.x && child.right <= cells[i].right);
      ASSERT_TRUE(cells[i].y <= child.y && child.top <= cells[i].top);
      const bool full_width = child.x == cells[i].x && child.right == cells[i].right;
      const bool full_height = child.y == cells[i].y && child.top == cells[i].top;
      if (full_width || full_height) continue;  // too narrow for another double: no quarters to tell apart
      ASSERT_LT(previous_quarter, quarter_in(cells[i], child));
      previous_quarter = quarter_in(cells[i], child);
    }
    ASSERT_EQ(next, cells[i].last);
  }
}

// A point lies in a cell exactly if the cell lists it: for all cells and all points (small n).
void expect_cells_hold_what_they_contain(const Quadtree& tree, const std::vector<Point>& points) {
  std::vector<std::size_t> place(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) place[tree.order()[i]] = i;
  for (const Cell& cell : tree.cells()) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(cell.contains(points[i]), cell.first <= place[i] && place[i] < cell.last);
    }
  }
}

TEST(Quadtree, PartitionsEveryShape) {
  for (const test::Shape& shape : test::all_shapes()) {
    for (const int capacity : {1, 4, 1000}) {
      SCOPED_TRACE(shape.name + ", capacity " + std::to_string(capacity));
      const Quadtree tree(shape.points, capacity);
      expect_leaves_partition_the_points(tree, shape.points.size(), capacity);
      expect_children_partition_their_parents(tree, capacity);
      expect_cells_hold_what_they_contain(tree, shape.points);
    }
  }
}

TEST(Quadtree, DistinctPointsEndAloneUnlessFinerThanTheDepth) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const bool too_fine = shape.name == "every_magnitude" || shape.name == "log_radial";
    if (too_fine) continue;
    const Quadtree tree(shape.points, 1);
    for (const Cell& cell : tree.cells()) {
      if (cell.is_leaf) {
        ASSERT_EQ(cell.last - cell.first, 1U);
      }
    }
  }
}

// Points on dividing lines belong to the upper and the right cell; the split lines of a lattice are exact.
TEST(Quadtree, CellsAreHalfOpen) {
  const std::vector<Point> points{{0, 0}, {8, 8}, {4, 0}, {4, 4}, {0, 4}, {2, 2}};
  const Quadtree tree(points, 1);
  const auto cells = tree.cells();
  EXPECT_EQ(cells[0].size, 8);
  EXPECT_EQ(cells[0].right, std::nextafter(8.0, 9.0));
  const std::vector<Cell> quarters = children_of(cells, 0);
  ASSERT_EQ(quarters.size(), 4U);
  const auto holds = [&](const Cell& cell, Index i) { return std::ranges::count(tree.points_of(cell), i) == 1; };
  EXPECT_TRUE(holds(quarters[0], 0) && holds(quarters[0], 5));
  EXPECT_TRUE(holds(quarters[1], 2));
  EXPECT_TRUE(holds(quarters[2], 4));
  EXPECT_TRUE(holds(quarters[3], 1) && holds(quarters[3], 3));
  EXPECT_EQ(quarters[3].x, 4);
  EXPECT_EQ(quarters[3].y, 4);
}

TEST(Quadtree, FullLatticeGivesEqualLeaves) {
  const Quadtree tree(test::full_lattice(17, 17), 1);
  int leaves = 0;
  for (const Cell& cell : tree.cells()) leaves += cell.is_leaf ? 1 : 0;
  EXPECT_EQ(leaves, 17 * 17);
  EXPECT_TRUE(std::ranges::all_of(tree.cells(), [](const Cell& c) { return c.x == std::floor(c.x) || c.size < 1; }));
}

TEST(Quadtree, OnePointAndEqualPoints) {
  const std::vector<Point> one{{3, 4}};
  const Quadtree tree(one, 1);
  ASSERT_EQ(tree.cells().size(), 1U);
  EXPECT_TRUE(tree.cells()[0].is_leaf);
  EXPECT_TRUE(tree.cells()[0].contains(one[0]));
  // Equal points are no valid input, but the depth bounds what they can do.
  const Quadtree equal(std::vector<Point>(10, Point{1, 1}), 4);
  EXPECT_EQ(equal.cells().back().depth, Quadtree::kMaximumDepth);
  EXPECT_EQ(equal.points_of(equal.cells().back()).size(), 10U);
}

// 10^6 points in clusters down to 10^-12 of the square, and one of them so fine that the depth ends in it.
TEST(Quadtree, MillionPointsInTinyClusters) {
  std::mt19937_64 random(9);
  std::vector<Point> points;
  for (int cluster = 0; cluster < 100; ++cluster) {
    const Point centre{test::random_unit(random), test::random_unit(random)};
    const double size = std::pow(10.0, -(cluster % 13));
    for (int i = 0; i < 10000; ++i) {
      points.push_back({centre.x + size * test::random_unit(random), centre.y + size * test::random_unit(random)});
    }
  }
  points.insert(points.end(), {{0, 0}, {1e-200, 0}, {0, 1e-200}, {3e-200, 1e-200}, {1e-300, 1e-300}});
  const Quadtree tree(points, 4);
  expect_leaves_partition_the_points(tree, points.size(), 4);
  EXPECT_TRUE(std::ranges::any_of(tree.cells(), [](const Cell& c) { return c.depth == Quadtree::kMaximumDepth; }));
}

TEST(Quadtree, RejectsWhatItCannotHold) {
  EXPECT_THROW(Quadtree({}, 4), InputError);
  EXPECT_THROW(Quadtree(test::full_lattice(2, 2), 0), InputError);
  EXPECT_THROW(Quadtree(std::vector<Point>{{0, std::nan("")}}, 1), InputError);
  EXPECT_THROW(Quadtree(std::vector<Point>{{HUGE_VAL, 0}}, 1), InputError);
  EXPECT_THROW(Quadtree(std::vector<Point>{{0, -1e301}}, 1), InputError);
}

}  // namespace
}  // namespace mwt
