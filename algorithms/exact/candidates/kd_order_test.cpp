#include "algorithms/exact/candidates/kd_order.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>

#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

void expect_permutation(Points points, const KdOrder& order) {
  ASSERT_EQ(order.points.size(), points.size());
  ASSERT_EQ(order.original.size(), points.size());
  std::vector<Index> sorted = order.original;
  std::sort(sorted.begin(), sorted.end());
  for (Index i = 0; i < points.size(); ++i) {
    EXPECT_EQ(sorted[i], i);
    EXPECT_EQ(order.points[i], points[order.original[i]]);
  }
}

void expect_tight_box(const KdOrder& order, std::uint32_t node) {
  const auto first = order.points.begin() + order.first_of(node), last = order.points.begin() + order.last_of(node);
  ASSERT_LT(first, last) << "node " << node << " is empty";
  const auto by_x = [](const Point& p, const Point& q) { return p.x < q.x; };
  const auto by_y = [](const Point& p, const Point& q) { return p.y < q.y; };
  const Box& box = order.boxes[node];
  EXPECT_EQ(box.min_x, std::min_element(first, last, by_x)->x);
  EXPECT_EQ(box.max_x, std::max_element(first, last, by_x)->x);
  EXPECT_EQ(box.min_y, std::min_element(first, last, by_y)->y);
  EXPECT_EQ(box.max_y, std::max_element(first, last, by_y)->y);
}

// The children share the node's points, and the split runs across the longer side, ties by the other coordinate.
void expect_split(const KdOrder& order, std::uint32_t node) {
  const std::uint32_t low = 2 * node, high = 2 * node + 1;
  EXPECT_EQ(order.first_of(node), order.first_of(low));
  EXPECT_EQ(order.last_of(low), order.first_of(high));
  EXPECT_EQ(order.last_of(high), order.last_of(node));
  const Box& box = order.boxes[node];
  const bool splits_x = box.max_x - box.min_x >= box.max_y - box.min_y;
  const auto is_less = [&](const Point& p, const Point& q) {
    return splits_x ? lexicographically_less(p, q) : lexicographically_less({p.y, p.x}, {q.y, q.x});
  };
  const auto first = order.points.begin() + order.first_of(node), middle = order.points.begin() + order.last_of(low);
  const auto last = order.points.begin() + order.last_of(node);
  EXPECT_TRUE(is_less(*std::max_element(first, middle, is_less), *std::min_element(middle, last, is_less))) << node;
}

void expect_kd_order(Points points, const KdOrder& order) {
  expect_permutation(points, order);
  EXPECT_EQ(order.first_of(1), 0);
  EXPECT_EQ(order.last_of(1), points.size());
  ASSERT_EQ(order.boxes.size(), 2 * std::size_t{order.leaf_count});
  for (std::uint32_t node = 1; node < 2 * order.leaf_count; ++node) {
    expect_tight_box(order, node);
    if (!order.is_leaf(node)) {
      expect_split(order, node);
      continue;
    }
    EXPECT_LE(order.last_of(node) - order.first_of(node), KdOrder::kMaxLeaf);
    if (order.leaf_count > 1) {
      EXPECT_GE(order.last_of(node) - order.first_of(node), KdOrder::kMinLeaf);
    }
  }
}

TEST(KdOrder, HoldsOnAllSmallSizes) {
  for (Index n = 3; n <= 40; ++n) {
    for (const char* family : {"uniform", "fan", "collinear_rows"}) {
      SCOPED_TRACE(family + std::to_string(n));
      const std::vector<Point> points = generate(family, n, n);
      expect_kd_order(points, make_kd_order(points));
    }
  }
}

TEST(KdOrder, HoldsOnAllFamilies) {
  for (const auto& [name, points] : instances_of_all_families({33, 257, 10'000})) {
    SCOPED_TRACE(name);
    expect_kd_order(points, make_kd_order(points));
  }
}

TEST(KdOrder, HoldsWhereCoordinatesAreEqualOrExtreme) {
  std::vector<Point> column, huge;
  for (int i = 0; i < 500; ++i) {
    column.push_back({1, static_cast<double>(i * 7919 % 500)});
    huge.push_back({i % 2 == 0 ? -1e300 : 1e300, 1e-300 * i});
  }
  column.push_back({2, 0});
  expect_kd_order(column, make_kd_order(column));
  expect_kd_order(huge, make_kd_order(huge));
}

TEST(KdOrder, DoesNotDependOnThreads) {
  const std::vector<Point> points = generate("lattice", 100'000, 1);
  const KdOrder one = make_kd_order(points);
  tbb::task_arena arena(3);
  const KdOrder three = arena.execute([&] { return make_kd_order(points); });
  EXPECT_EQ(one.original, three.original);
}

// The points fall into the same leaves whatever order they come in.
TEST(KdOrder, AssignsLeavesByThePointsAlone) {
  std::vector<Point> points = generate("integer_uniform", 300, 2, {{"range", "20"}});
  const KdOrder order = make_kd_order(points);
  std::reverse(points.begin(), points.end());
  const KdOrder reversed = make_kd_order(points);
  for (std::uint32_t leaf = order.leaf_count; leaf < 2 * order.leaf_count; ++leaf) {
    const auto points_of = [leaf](const KdOrder& tree) {
      std::vector<Point> result(tree.points.begin() + tree.first_of(leaf), tree.points.begin() + tree.last_of(leaf));
      std::sort(result.begin(), result.end(), lexicographically_less);
      return result;
    };
    EXPECT_EQ(points_of(order), points_of(reversed)) << leaf;
  }
}

}  // namespace
}  // namespace mwt
