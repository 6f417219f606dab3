#include "algorithms/exact/candidates/long_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/exact/candidates/long_edge_kernels.h"
#include "algorithms/exact/candidates/near_points.h"

namespace mwt {

namespace {

// More points than this are not gathered: edges with so many around them are found to be excluded soon.
constexpr std::size_t kMaxGathered = 768;

Point center_of(const Box& box) {
  return {box.min_x + 0.5 * (box.max_x - box.min_x), box.min_y + 0.5 * (box.max_y - box.min_y)};
}

double radius_of(const Box& box) { return 0.5 * std::hypot(box.max_x - box.min_x, box.max_y - box.min_y); }

struct Vector {
  double x = 0;
  double y = 0;

  [[nodiscard]] double square() const { return x * x + y * y; }
};

// The diamond triangles of edges whose ends lie within `widening` of p and q; all of it scaled, p at the origin.
class Diamonds {
 public:
  Diamonds(double scale, const Point& p, const Point& q, double widening) : scale_(scale), p_(p), edge_(from_p(q)) {
    const Vector along{kTangentForDoubles * edge_.x, kTangentForDoubles * edge_.y};
    const double end = kTangentForDoubles * edge_.square();
    for (const std::size_t side : {0U, 1U}) {
      const double sign = side == 0 ? 1 : -1;
      const Vector up{-sign * edge_.y, sign * edge_.x};
      borders_[side] = {{{up, 0}, {{along.x - up.x, along.y - up.y}, 0}, {{-along.x - up.x, -along.y - up.y}, end}}};
      for (Border& border : borders_[side]) border.constant += widening * scale * std::sqrt(border.gradient.square());
    }
  }

  // Whether the box may hold points of the left (0) or right (1) triangle: it does not lie beyond one of the triangle's
  // sides.
  [[nodiscard]] bool may_meet(std::size_t side, const Box& box) const {
    const Vector center = from_p(center_of(box));
    const double half_x = 0.5 * scale_ * (box.max_x - box.min_x), half_y = 0.5 * scale_ * (box.max_y - box.min_y);
    return std::all_of(borders_[side].begin(), borders_[side].end(), [&](const Border& border) {
      const auto [x, y] = border.gradient;
      const double reach = x * center.x + y * center.y + border.constant + std::abs(x) * half_x + std::abs(y) * half_y;
      const double magnitude =
          std::abs(x) * (std::abs(center.x) + half_x) + std::abs(y) * (std::abs(center.y) + half_y);
      return reach >= -1e-14 * (magnitude + border.constant);
    });
  }

  [[nodiscard]] bool may_meet(const Box& box) const { return may_meet(0, box) || may_meet(1, box); }

  // Squared, of the box's center from the nearer end.
  [[nodiscard]] double distance_of(const Box& box) const {
    const Vector v = from_p(center_of(box));
    return std::min(v.square(), Vector{v.x - edge_.x, v.y - edge_.y}.square());
  }

 private:
  // gradient . z + constant, not negative inside
  struct Border {
    Vector gradient;
    double constant;
  };

  [[nodiscard]] Vector from_p(const Point& point) const {
    return {(point.x - p_.x) * scale_, (point.y - p_.y) * scale_};
  }

  double scale_;
  Point p_;
  Vector edge_;
  std::array<std::array<Border, 3>, 2> borders_;
};

// Visits the leaves that may hold points of the triangles, those near the edge's ends first, while visit(leaf) is true.
template <class MayMeet, class Visit>
void visit_leaves(const KdOrder& order, const Diamonds& diamonds, const MayMeet& may_meet, const Visit& visit) {
  std::array<std::uint32_t, 64> stack{1};  // a path in the tree and its siblings
  std::size_t height = 1;
  while (height > 0) {
    const std::uint32_t node = stack[--height];
    if (!may_meet(order.boxes[node])) continue;
    if (order.is_leaf(node)) {
      if (!visit(node)) return;
      continue;
    }
    const bool first_is_nearer =
        diamonds.distance_of(order.boxes[2 * node]) <= diamonds.distance_of(order.boxes[2 * node + 1]);
    stack[height++] = first_is_nearer ? 2 * node + 1 : 2 * node;
    stack[height++] = first_is_nearer ? 2 * node : 2 * node + 1;
  }
}

// To a whole number of vectors.
void pad(std::vector<double>& column) {
  while (column.size() % PointColumns::kWidth != 0) column.push_back(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

LongEdgeTest::LongEdgeTest(const KdOrder& order) : order_(order), scale_(distance_scale(order)) {}

void LongEdgeTest::start(std::uint32_t leaf, std::uint32_t other_leaf) {
  leaf_ = leaf;
  other_leaf_ = other_leaf;
  has_gathered_ = false;
}

// When an edge's ends move by r and s, the corners of its triangles move by at most r + s: the ends by r or s, the
// upper corner, .5 (p + q) +- .41 (q - p) turned, by less than .91 (r + s).
void LongEdgeTest::gather() {
  const Box& from = order_.boxes[leaf_];
  const Box& to = order_.boxes[other_leaf_];
  const Diamonds diamonds(scale_, center_of(from), center_of(to), 1.0001 * (radius_of(from) + radius_of(to)));
  x_.clear();
  y_.clear();
  has_all_ = true;
  const auto may_meet = [&](const Box& box) { return diamonds.may_meet(box); };
  visit_leaves(order_, diamonds, may_meet, [&](std::uint32_t leaf) {
    for (Index i = order_.first_of(leaf); i < order_.last_of(leaf); ++i) {
      x_.push_back(order_.points[i].x);
      y_.push_back(order_.points[i].y);
    }
    has_all_ = x_.size() <= kMaxGathered;
    return has_all_;
  });
  pad(x_);
  pad(y_);
  has_gathered_ = true;
}

bool LongEdgeTest::is_excluded(Index p, Index q) {
  if (!has_gathered_) gather();
  const DiamondOccupancy occupancy =
      find_occupancy({x_.data(), y_.data(), x_.size()}, order_.points[p], order_.points[q], scale_);
  return occupancy.excludes() || (!has_all_ && is_excluded_by_any(p, q));
}

bool LongEdgeTest::is_excluded_by_any(Index p, Index q) const {
  const Diamonds diamonds(scale_, order_.points[p], order_.points[q], 0);
  DiamondOccupancy found;
  const auto may_meet = [&](const Box& box) {
    return (!found.left && diamonds.may_meet(0, box)) || (!found.right && diamonds.may_meet(1, box));
  };
  visit_leaves(order_, diamonds, may_meet, [&](std::uint32_t leaf) {
    std::array<double, KdOrder::kMaxLeaf> x, y;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
    const Index first = order_.first_of(leaf), last = order_.last_of(leaf);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const bool exists = first + i < last;
      x[i] = exists ? order_.points[first + i].x : std::numeric_limits<double>::quiet_NaN();
      y[i] = exists ? order_.points[first + i].y : std::numeric_limits<double>::quiet_NaN();
    }
    const DiamondOccupancy here =
        find_occupancy({x.data(), y.data(), x.size()}, order_.points[p], order_.points[q], scale_);
    found = {found.left || here.left, found.right || here.right, found.on_edge || here.on_edge};
    return !found.excludes();
  });
  return found.excludes();
}

}  // namespace mwt
