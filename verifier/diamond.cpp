#include "verifier/diamond.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "verifier/exact.h"

namespace mwt::verifier {

namespace {

// Which pairs need no exact test is found out in doubles. There angles err by less than kAngleMargin and distances by
// less than the factor kDistanceMargin: both are millions of times what rounding does.
constexpr double kAngleMargin = 1e-9;
constexpr double kDistanceMargin = 1 + 1e-6;
constexpr double kDiamondAngle = std::numbers::pi / 4.6 - kAngleMargin;
constexpr double kTurn = 2 * std::numbers::pi;

constexpr int kSectors = 40;
constexpr double kSectorsPerRadian = kSectors / kTurn;

// By sector of directions from a point, a distance beyond which witnesses lie in both triangles of every edge.
//
// A witness at distance r lies inside the triangle left of an edge if its direction is to the left of the edge's by
// less than the diamond angle alpha, and the edge is longer than 2 cos(alpha) r: then it is seen lower than alpha from
// the far end, too.
using Reach = std::array<float, kSectors>;

float farthest(const Reach& reach) { return *std::max_element(reach.begin(), reach.end()); }

std::size_t wrapped(long sector) { return static_cast<std::size_t>((sector % kSectors + kSectors) % kSectors); }
std::size_t opposite(long sector) { return wrapped(sector + kSectors / 2); }

// The sectors that directions between two angles may lie in, and those that hold no others.
struct SectorRange {
  long first, last;
};
SectorRange sectors_touched(double from, double to) {
  return {static_cast<long>(std::floor((from - kAngleMargin) * kSectorsPerRadian)),
          static_cast<long>(std::floor((to + kAngleMargin) * kSectorsPerRadian))};
}
SectorRange sectors_filled(double from, double to) {
  return {static_cast<long>(std::ceil((from + kAngleMargin) * kSectorsPerRadian)),
          static_cast<long>(std::floor((to - kAngleMargin) * kSectorsPerRadian)) - 1};
}

// The reach of one point, witness by witness.
class ReachOfPoint {
 public:
  ReachOfPoint() {
    left_.fill(std::numeric_limits<float>::infinity());
    right_ = left_;
  }

  void add_witness(double dx, double dy) {
    const double distance = std::hypot(dx, dy);
    if (!(distance > 1e-30 && distance < 1e30)) return;  // so that floats hold it
    const double angle = std::atan2(dy, dx);
    const auto beyond = static_cast<float>(2 * std::cos(kDiamondAngle) * distance * kDistanceMargin);
    lower(left_, sectors_filled(angle - kDiamondAngle, angle), beyond);
    lower(right_, sectors_filled(angle, angle + kDiamondAngle), beyond);
  }

  [[nodiscard]] Reach on_both_sides() const {
    Reach both;
    for (std::size_t s = 0; s < kSectors; ++s) both[s] = std::max(left_[s], right_[s]);
    return both;
  }

 private:
  static void lower(Reach& side, const SectorRange& sectors, float beyond) {
    for (long s = sectors.first; s <= sectors.last; ++s) side[wrapped(s)] = std::min(side[wrapped(s)], beyond);
  }

  Reach left_, right_;
};

class DiamondSearch {
 public:
  DiamondSearch(Points points, const PointTree& tree)
      : points_(points), tree_(tree), reach_(points.size()), reach_of_node_(tree.node_count()) {
    const Box& all = tree.box(tree.root());
    const double extent = std::max(all.max_x - all.min_x, all.max_y - all.min_y);
    scale_ = std::ldexp(1.0, std::min(-std::ilogb(extent), 1000));
    compute_reach(tree_.root());
  }

  EdgeSet run() {
    EdgeSet edges(points_.size());
    for (const Index p : tree_.points_in_order()) find_edges(p, farthest(reach_[p]), tree_.root(), edges);
    return edges;
  }

 private:
  // Of all points of a node, and of the node itself: the largest of its points'.
  void compute_reach(const PointTree::Node& node) {
    Reach& most = reach_of_node_[node.number];
    most.fill(0);
    const auto include = [&](const Reach& part) {
      for (std::size_t s = 0; s < kSectors; ++s) most[s] = std::max(most[s], part[s]);
    };
    if (!node.is_leaf()) {
      for (const PointTree::Node& child : {node.left(), node.right()}) {
        compute_reach(child);
        include(reach_of_node_[child.number]);
      }
      return;
    }
    collect_witnesses(tree_.box(node));
    for (std::size_t i = node.begin; i < node.end; ++i) {
      const Index p = tree_.points_in_order()[i];
      reach_[p] = reach_of(p);
      include(reach_[p]);
    }
  }

  // Points around a box, nearest first: all that are near, and of those farther away the fewer the farther. Which ones
  // matters for the time only.
  void collect_witnesses(const Box& box) {
    witnesses_.clear();
    sample(middle_of(box), tree_.root());
    std::sort(witnesses_.begin(), witnesses_.end());
  }

  void sample(const Point& middle, const PointTree::Node& node) {
    const Box& box = tree_.box(node);
    const bool is_far = distance(middle, box) > size_of(box);
    if (!is_far && !node.is_leaf()) {
      sample(middle, node.left());
      sample(middle, node.right());
      return;
    }
    const std::size_t step = is_far ? std::max<std::size_t>((node.end - node.begin) / 2, 1) : 1;
    for (std::size_t i = node.begin; i < node.end; i += step) {
      const Index w = tree_.points_in_order()[i];
      witnesses_.emplace_back(distance(middle, points_[w]), w);
    }
  }

  [[nodiscard]] Reach reach_of(Index p) const {
    constexpr std::size_t kRound = 16;
    ReachOfPoint reach;
    for (std::size_t i = 0; i < witnesses_.size(); ++i) {
      const auto& [away, w] = witnesses_[i];
      if (i % kRound == 0 && away > farthest(reach.on_both_sides())) break;
      if (w != p) reach.add_witness(scaled_x(points_[p], points_[w]), scaled_y(points_[p], points_[w]));
    }
    return reach.on_both_sides();
  }

  // Inserts the edges from p to points q > p of the node.
  void find_edges(Index p, float farthest, const PointTree::Node& node, EdgeSet& edges) const {
    if (is_out_of_reach(p, farthest, node)) return;
    if (!node.is_leaf()) {
      find_edges(p, farthest, node.left(), edges);
      find_edges(p, farthest, node.right(), edges);
      return;
    }
    for (std::size_t i = node.begin; i < node.end; ++i) {
      const Index q = tree_.points_in_order()[i];
      if (q > p && is_within_reach(p, q) && is_candidate(p, q)) edges.insert(p, q);
    }
  }

  [[nodiscard]] bool is_out_of_reach(Index p, float farthest, const PointTree::Node& node) const {
    const Box& box = tree_.box(node);
    const double away = distance(points_[p], box) / kDistanceMargin;
    if (away > farthest) return true;
    if (away < size_of(box)) return false;
    const SectorRange sectors = directions(points_[p], box);
    for (long s = sectors.first; s <= sectors.last; ++s) {
      if (away <= reach_[p][wrapped(s)] && away <= reach_of_node_[node.number][opposite(s)]) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_within_reach(Index p, Index q) const {
    const double away = distance(points_[p], points_[q]) / kDistanceMargin;
    const double angle = std::atan2(scaled_y(points_[p], points_[q]), scaled_x(points_[p], points_[q]));
    const SectorRange sectors = sectors_touched(angle, angle);
    for (long s = sectors.first; s <= sectors.last; ++s) {
      if (away <= reach_[p][wrapped(s)] && away <= reach_[q][opposite(s)]) return true;
    }
    return false;
  }

  // Of all points of a box, seen from p. Precondition: p is farther away than the box is wide.
  [[nodiscard]] SectorRange directions(const Point& p, const Box& box) const {
    const auto angle_to = [&](const Point& q) { return std::atan2(scaled_y(p, q), scaled_x(p, q)); };
    const double middle = angle_to(middle_of(box));
    double low = middle, high = middle;
    for (const Point& corner : {Point{box.min_x, box.min_y}, Point{box.max_x, box.min_y}, Point{box.min_x, box.max_y},
                                Point{box.max_x, box.max_y}}) {
      const double angle = middle + std::remainder(angle_to(corner) - middle, kTurn);
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    return sectors_touched(low, high);
  }

  // The exact test, over all points.
  [[nodiscard]] bool is_candidate(Index p_index, Index q_index) const {
    const Point &p = points_[p_index], &q = points_[q_index];
    bool left = false, right = false;
    const auto excludes = [&](Index i) {
      if (i == p_index || i == q_index) return false;
      const Point& w = points_[i];
      const int side = turn(p, q, w);
      if (side == 0) return is_inside_segment(w, p, q);
      bool& is_occupied = side > 0 ? left : right;
      is_occupied = is_occupied || (sign_of_form(p, q, w, -side, kDiamondTangent) > 0 &&
                                    sign_of_form(q, p, w, side, kDiamondTangent) > 0);
      return left && right;
    };
    // The other corners of the diamond, farther out than they are by more than what rounding may do to them.
    const double size = std::max({std::abs(p.x), std::abs(p.y), std::abs(q.x), std::abs(q.y)});
    const double rounding = 0x1p-49 * size / std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
    const double outwards = (0.501 + rounding) * kDiamondTangent;
    const double hx = (q.x - p.x) * outwards, hy = (q.y - p.y) * outwards;
    const Point middle{std::midpoint(p.x, q.x), std::midpoint(p.y, q.y)};
    const Point over{middle.x - hy, middle.y + hx}, under{middle.x + hy, middle.y - hx};
    const auto skip = [&](const Box& box) {
      return lies_right(box, p, under) || lies_right(box, under, q) || lies_right(box, q, over) ||
             lies_right(box, over, p);
    };
    return !tree_.search(skip, excludes);
  }

  // In units of about the extent of all points, so that neither tiny nor huge coordinates matter.
  [[nodiscard]] double scaled_x(const Point& from, const Point& to) const { return (to.x - from.x) * scale_; }
  [[nodiscard]] double scaled_y(const Point& from, const Point& to) const { return (to.y - from.y) * scale_; }
  [[nodiscard]] double distance(const Point& p, const Point& q) const {
    return std::hypot(scaled_x(p, q), scaled_y(p, q));
  }
  [[nodiscard]] double distance(const Point& p, const Box& box) const {
    return distance(p, Point{std::clamp(p.x, box.min_x, box.max_x), std::clamp(p.y, box.min_y, box.max_y)});
  }
  [[nodiscard]] double size_of(const Box& box) const {
    return distance(Point{box.min_x, box.min_y}, Point{box.max_x, box.max_y});
  }
  [[nodiscard]] static Point middle_of(const Box& box) {
    return {std::midpoint(box.min_x, box.max_x), std::midpoint(box.min_y, box.max_y)};
  }

  Points points_;
  const PointTree& tree_;
  double scale_ = 1;
  std::vector<Reach> reach_;
  std::vector<Reach> reach_of_node_;
  std::vector<std::pair<double, Index>> witnesses_;
};

}  // namespace

EdgeSet diamond_candidates(Points points, const PointTree& tree) { return DiamondSearch(points, tree).run(); }

}  // namespace mwt::verifier
