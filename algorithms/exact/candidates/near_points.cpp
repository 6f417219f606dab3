#include "algorithms/exact/candidates/near_points.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace mwt {

double distance_scale(const KdOrder& order) {
  constexpr int kScaledExponent = 60;      // squares of scaled distances then stay below 2^125, which floats hold
  constexpr int kMaxScaleExponent = 1000;  // the scale itself is a finite double
  const Box& box = order.boxes[1];
  const double extent = std::max(box.max_x - box.min_x, box.max_y - box.min_y);
  return std::ldexp(1.0, std::min(kScaledExponent - std::ilogb(extent), kMaxScaleExponent));
}

float box_distance(const Box& a, const Box& b, double scale) {
  const double x = std::max({0.0, a.min_x - b.max_x, b.min_x - a.max_x}) * scale;
  const double y = std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y}) * scale;
  constexpr double kRoundDown = 1 - 1e-6;  // the conversion to float errs by 2^-24 = 6e-8 of the distance
  return static_cast<float>(std::sqrt(x * x + y * y) * kRoundDown);
}

void NearPointsFinder::append_leaf(std::uint32_t leaf, float distance) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  std::size_t place = static_cast<std::size_t>(near_.leaves) * KdOrder::kMaxLeaf;
  const std::size_t end = place + KdOrder::kMaxLeaf;
  for (Index i = order_.first_of(leaf); i < order_.last_of(leaf); ++i, ++place) {
    near_.x[place] = order_.points[i].x;
    near_.y[place] = order_.points[i].y;
  }
  std::fill(near_.x.begin() + static_cast<std::ptrdiff_t>(place), near_.x.begin() + static_cast<std::ptrdiff_t>(end),
            kNothing);
  std::fill(near_.y.begin() + static_cast<std::ptrdiff_t>(place), near_.y.begin() + static_cast<std::ptrdiff_t>(end),
            kNothing);
  append_box(order_.boxes[leaf]);
  near_.distance[static_cast<std::size_t>(near_.leaves++)] = distance;
}

void NearPointsFinder::append_box(const Box& box) {
  constexpr double kRoundUp = 1 + 1e-4;  // for what vectors lose of the center, too (diamond_kernels.cpp)
  const auto place = static_cast<std::size_t>(near_.leaves);
  const double x = box.min_x + 0.5 * (box.max_x - box.min_x), y = box.min_y + 0.5 * (box.max_y - box.min_y);
  near_.center_x[place] = x;
  near_.center_y[place] = y;
  near_.half_x[place] = static_cast<float>(std::max(x - box.min_x, box.max_x - x) * near_.scale * kRoundUp);
  near_.half_y[place] = static_cast<float>(std::max(y - box.min_y, box.max_y - y) * near_.scale * kRoundUp);
}

const NearPoints& NearPointsFinder::find(std::uint32_t leaf) {
  near_.leaf_size = static_cast<int>(order_.last_of(leaf) - order_.first_of(leaf));
  near_.leaves = 0;
  near_.samples = 0;
  append_leaf(leaf, 0);
  queue_.clear();
  const Box& box = order_.boxes[leaf];
  const auto push = [&](std::uint32_t node) {
    queue_.emplace_back(box_distance(box, order_.boxes[node], near_.scale), node);
    std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
  };
  for (std::uint32_t node = leaf; node > 1; node /= 2) push(node ^ 1U);
  while (near_.leaves < NearPoints::kLeaves && !queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
    const auto [distance, node] = queue_.back();
    queue_.pop_back();
    if (order_.is_leaf(node)) {
      append_leaf(node, distance);
    } else {
      push(2 * node);
      push(2 * node + 1);
    }
  }
  return near_;
}

const NearPoints& NearPointsFinder::add_samples(std::uint32_t leaf) {
  constexpr std::size_t kSamplesPerNode = 16;
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  std::size_t place = static_cast<std::size_t>(near_.places());
  for (std::uint32_t node = leaf; node > 1; node /= 2) {
    const std::uint32_t sibling = node ^ 1U;
    const std::uint64_t first = order_.first_of(sibling), size = order_.last_of(sibling) - first;
    for (std::size_t i = 0; i < kSamplesPerNode; ++i, ++place) {
      const Point& sample = order_.points[first + (2 * i + 1) * size / (2 * kSamplesPerNode)];
      near_.x[place] = sample.x;
      near_.y[place] = sample.y;
      ++near_.samples;
    }
  }
  // Vectors may read past the end.
  for (std::size_t i = 0; i < KdOrder::kMaxLeaf; ++i) near_.x[place + i] = near_.y[place + i] = kNothing;
  return near_;
}

}  // namespace mwt
