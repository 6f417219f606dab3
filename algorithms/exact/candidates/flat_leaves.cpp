#include "algorithms/exact/candidates/flat_leaves.h"

#include <algorithm>
#include <cmath>

#include "algorithms/exact/candidates/long_edge_kernels.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// Boxes are far if they are this many times as far away as the near points reach.
constexpr float kFar = 4;
constexpr double kFlat = 0x1p-10;

std::array<Point, 4> corners_of(const Box& box) {
  return {{{box.min_x, box.min_y}, {box.min_x, box.max_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}}};
}

}  // namespace

void FlatLeafTest::start(std::uint32_t leaf, float farthest) {
  leaf_ = leaf;
  near_ = nullptr;
  is_flat_.reset();
  const Box& box = order_.boxes[leaf];
  const double extent = std::max(box.max_x - box.min_x, box.max_y - box.min_y);
  if (farthest <= kFar * extent * scale_) is_flat_ = false;
}

const NearPoints& FlatLeafTest::near() {
  if (near_ == nullptr) near_ = &finder_.find(leaf_);
  return *near_;
}

std::uint32_t FlatLeafTest::with_edges_into(std::uint32_t node, std::uint32_t mask) {
  if (is_flat_ == false) return mask;
  const NearPoints& near = this->near();
  const float reach = near.distance[static_cast<std::size_t>(near.leaves - 1)];
  const Box& box = order_.boxes[node];
  if (!(box_distance(order_.boxes[leaf_], box, scale_) > kFar * reach)) return mask;
  if (!is_flat_) find_line();
  if (!*is_flat_ || !is_along(box)) return mask;
  for (std::uint32_t left = mask; left != 0; left &= left - 1) {
    const auto place = static_cast<std::size_t>(__builtin_ctz(left));
    if (is_excluded(place, box)) mask &= ~(std::uint32_t{1} << place);
  }
  return mask;
}

// From the leaf's first point to the farthest near one.
void FlatLeafTest::find_line() {
  const NearPoints& near = *near_;
  const auto places = static_cast<std::size_t>(near.leaves) * KdOrder::kMaxLeaf;
  const auto from_first = [&](std::size_t i) {
    return Point{(near.x[i] - near.x[0]) * scale_, (near.y[i] - near.y[0]) * scale_};
  };
  along_ = {0, 0};
  double longest = 0;
  for (std::size_t i = 0; i < places; ++i) {
    const Point v = from_first(i);
    const double square = v.x * v.x + v.y * v.y;
    if (!(square > longest)) continue;  // nor if the place is empty
    longest = square;
    along_ = v;
  }
  is_flat_ = longest > 0;
  for (std::size_t i = 0; i < places; ++i) {
    const Point v = from_first(i);
    if (std::abs(along_.x * v.y - along_.y * v.x) > kFlat * longest) is_flat_ = false;
  }
  for (auto& last : last_) last = {0, 0};
}

// Within the diamond test's angle of the line. It need not be exact.
bool FlatLeafTest::is_along(const Box& box) const {
  const Point v{(box.min_x + .5 * (box.max_x - box.min_x) - near_->x[0]) * scale_,
                (box.min_y + .5 * (box.max_y - box.min_y) - near_->y[0]) * scale_};
  return std::abs(along_.x * v.y - along_.y * v.x) < kTangentForDoubles * std::abs(along_.x * v.x + along_.y * v.y);
}

bool FlatLeafTest::is_excluded(std::size_t place, const Box& box) {
  const Point p = order_.points[order_.first_of(leaf_) + place];
  std::array<bool, 2> has{};  // left, right
  const auto look_at = [&](std::size_t i) {
    const int side = side_of({near_->x[i], near_->y[i]}, p, box);
    if (side == 0) return;
    const std::size_t which = side > 0 ? 0 : 1;
    has[which] = true;
    last_[place][which] = i;
  };
  const std::array<std::size_t, 2> last = last_[place];
  for (const std::size_t i : last) look_at(i);
  const auto places = static_cast<std::size_t>(near_->leaves) * KdOrder::kMaxLeaf;
  for (std::size_t i = 0; i < places && !(has[0] && has[1]); ++i) look_at(i);
  return has[0] && has[1];
}

// Seen from p the box lies in the cone of its corners: what is left of these directions, or below the angle, is so for
// all directions between. Empty places are not a number, and no comparison with them holds.
int FlatLeafTest::side_of(const Point& z, const Point& p, const Box& box) const {
  const double scale = scale_;
  const double zx = (z.x - p.x) * scale, zy = (z.y - p.y) * scale;
  const double dx = std::max({0.0, box.min_x - p.x, p.x - box.max_x}) * scale;
  const double dy = std::max({0.0, box.min_y - p.y, p.y - box.max_y}) * scale;
  constexpr double kNotHalf = 4.001;
  const double square = zx * zx + zy * zy;
  if (!(square > kTrustedProduct && kNotHalf * square < dx * dx + dy * dy)) return 0;
  int common = 0;
  for (const Point& corner : corners_of(box)) {
    const double cx = (corner.x - p.x) * scale, cy = (corner.y - p.y) * scale;
    const double one = cx * zy, two = cy * zx, height = one - two, magnitude = std::abs(one) + std::abs(two);
    if (!(std::abs(height) < kTangentForDoubles * (cx * zx + cy * zy))) return 0;
    const bool is_sure = std::abs(height) > 1e-15 * magnitude && magnitude > kTrustedProduct;
    const int side = is_sure ? (height > 0 ? 1 : -1) : orientation(p, corner, z);
    if (side == 0 || side == -common) return 0;
    common = side;
  }
  return common;
}

}  // namespace mwt
