#include "algorithms/exact/candidates/kd_order.h"

#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <limits>

namespace mwt {

namespace {

struct IndexedPoint {
  double x;
  double y;
  Index index;
};

class Builder {
 public:
  Builder(Points points, KdOrder& order) : order_(order) {
    entries_.reserve(points.size());
    for (Index i = 0; i < points.size(); ++i) entries_.push_back({points[i].x, points[i].y, i});
  }

  void split(std::uint32_t node) {
    const auto begin = entries_.begin();
    const auto first = begin + order_.first_of(node), last = begin + order_.last_of(node);
    const Box box = box_of(first, last);
    order_.boxes[node] = box;
    if (order_.is_leaf(node)) return store(node);
    const auto middle = begin + order_.last_of(2 * node);
    if (box.max_x - box.min_x >= box.max_y - box.min_y) {
      std::nth_element(first, middle, last, [](const IndexedPoint& a, const IndexedPoint& b) {
        return a.x < b.x || (a.x == b.x && a.y < b.y);
      });
    } else {
      std::nth_element(first, middle, last, [](const IndexedPoint& a, const IndexedPoint& b) {
        return a.y < b.y || (a.y == b.y && a.x < b.x);
      });
    }
    constexpr std::ptrdiff_t kWorthATask = 1 << 14;
    if (last - first < kWorthATask) {
      split(2 * node);
      split(2 * node + 1);
    } else {
      tbb::parallel_invoke([&] { split(2 * node); }, [&] { split(2 * node + 1); });
    }
  }

 private:
  using Iterator = std::vector<IndexedPoint>::iterator;

  static Box box_of(Iterator first, Iterator last) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    Box box{kInfinity, kInfinity, -kInfinity, -kInfinity};
    for (auto entry = first; entry != last; ++entry) {
      box.min_x = std::min(box.min_x, entry->x);
      box.max_x = std::max(box.max_x, entry->x);
      box.min_y = std::min(box.min_y, entry->y);
      box.max_y = std::max(box.max_y, entry->y);
    }
    return box;
  }

  void store(std::uint32_t leaf) {
    for (Index i = order_.first_of(leaf); i < order_.last_of(leaf); ++i) {
      order_.points[i] = {entries_[i].x, entries_[i].y};
      order_.original[i] = entries_[i].index;
    }
  }

  KdOrder& order_;
  std::vector<IndexedPoint> entries_;
};

std::uint32_t leaves_for(std::size_t point_count) {
  std::uint32_t leaves = 1;
  while (point_count / leaves >= KdOrder::kMaxLeaf) leaves *= 2;
  return leaves;
}

}  // namespace

KdOrder make_kd_order(Points points) {
  KdOrder order;
  order.leaf_count = leaves_for(points.size());
  order.points.resize(points.size());
  order.original.resize(points.size());
  order.boxes.resize(2 * std::size_t{order.leaf_count});
  Builder(points, order).split(1);
  return order;
}

}  // namespace mwt
