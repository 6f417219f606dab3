#include "algorithms/exact/bounds/side_costs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <utility>

#include "algorithms/common/rows.h"
#include "geometry/numbers/double_double.h"
#include "geometry/numbers/interval.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// At most the root of the square, rounded in any way: squares that overflow or underflow say less.
double root_below(double square) {
  if (!(square > kMinTrustedProduct)) return 0;
  return std::sqrt(std::min(square, kMaxTrustedProduct)) * (1 - 0x1p-49);
}

double distance_below(const Point& p, const Point& q) {
  const double x = p.x - q.x, y = p.y - q.y;
  return root_below(x * x + y * y);
}

double distance_below(const Box& box, const Point& p) {
  const double x = std::max({0.0, box.min_x - p.x, p.x - box.max_x});
  const double y = std::max({0.0, box.min_y - p.y, p.y - box.max_y});
  return root_below(x * x + y * y);
}

class SideCosts {
 public:
  SideCosts(const KdOrder& order, std::span<const Edge> edges) : order_(order), points_(order.points), edges_(edges) {
    neighbours_ = file_in_rows<Index>(points_.size(), [&](const auto& file) {
      for (const Edge& edge : edges) {
        file(edge.a, edge.b);
        file(edge.b, edge.a);
      }
    });
  }

  std::vector<SideCost> run(const Deadline& deadline) const {
    constexpr std::size_t kEdgesPerDeadlineCheck = 64;
    std::vector<SideCost> costs(2 * edges_.size());
    std::atomic<bool> is_late = false;
    tbb::parallel_for(std::size_t{0}, edges_.size(), [&](std::size_t e) {
      if (e % kEdgesPerDeadlineCheck == 0 && has_passed(deadline)) is_late = true;
      if (is_late) return;
      costs[2 * e] = cost_left_of(edges_[e].a, edges_[e].b);
      costs[2 * e + 1] = cost_left_of(edges_[e].b, edges_[e].a);
    });
    return costs;
  }

 private:
  [[nodiscard]] bool is_left(Index p, Index q, const Point& z) const {
    return orientation(points_[p], points_[q], z) > 0;
  }

  [[nodiscard]] SideCost cost_left_of(Index p, Index q) const {
    SideCost cost;
    cost.edge = next_up(length(points_[p], points_[q]).high);
    cost.detour = least_detour(p, q);
    if (cost.detour == SideCost::kNone) return cost;
    for (const auto& [from, other] : {std::pair(p, q), std::pair(q, p)}) {
      for (const Index z : neighbours_[from]) {
        if (z == other || !is_left(p, q, points_[z])) continue;
        const auto beyond = neighbours_[other];
        cost.is_free = cost.is_free || std::find(beyond.begin(), beyond.end(), z) != beyond.end();
        cost.diagonal = std::min(cost.diagonal, distance_below(points_[other], points_[z]));
      }
    }
    return cost;
  }

  // Of |pz| + |qz| over the points z left of pq.
  [[nodiscard]] double least_detour(Index p, Index q) const {
    double least = SideCost::kNone;
    struct Visit {
      std::uint32_t node;
      double detour;
    };
    std::array<Visit, 64> stack{{{1, 0}}};  // a path in the tree and its siblings
    std::size_t height = 1;
    while (height > 0) {
      const auto [node, detour] = stack[--height];
      if (detour >= least || !may_be_left(p, q, order_.boxes[node])) continue;
      if (order_.is_leaf(node)) {
        search_leaf(node, p, q, least);
        continue;
      }
      Visit near{2 * node, detour_to(2 * node, p, q)}, far{2 * node + 1, detour_to(2 * node + 1, p, q)};
      if (far.detour < near.detour) std::swap(near, far);
      stack[height++] = far;
      stack[height++] = near;
    }
    return least;
  }

  void search_leaf(std::uint32_t leaf, Index p, Index q, double& least) const {
    for (Index z = order_.first_of(leaf); z < order_.last_of(leaf); ++z) {
      if (z == p || z == q) continue;
      const double detour = next_down(distance_below(points_[p], points_[z]) + distance_below(points_[q], points_[z]));
      if (detour < least && is_left(p, q, points_[z])) least = std::max(0.0, detour);
    }
  }

  [[nodiscard]] double detour_to(std::uint32_t node, Index p, Index q) const {
    const Box& box = order_.boxes[node];
    return next_down(distance_below(box, points_[p]) + distance_below(box, points_[q]));
  }

  // Whether the box's corner farthest to the left is left of pq.
  [[nodiscard]] bool may_be_left(Index p, Index q, const Box& box) const {
    const Point &from = points_[p], &to = points_[q];
    return is_left(p, q, {to.y < from.y ? box.max_x : box.min_x, to.x > from.x ? box.max_y : box.min_y});
  }

  const KdOrder& order_;
  Points points_;
  std::span<const Edge> edges_;
  Rows<Index> neighbours_;  // by given edges
};

}  // namespace

// Let |pz| and |qz| be at most the cap: their sum counts. If one of them is longer, the other is at most |pq| shorter.
double SideCost::capped(double cap) const {
  if (is_free || detour == kNone) return 0;
  const double longest = next_down(2 * cap - std::min(edge, cap));
  const double one = next_down(std::min(detour, longest) / 2);
  const double two = next_down(std::min(diagonal, cap) / 4);
  return std::max(0.0, std::min(one, two));
}

std::vector<SideCost> side_costs(const KdOrder& order, std::span<const Edge> edges, const Deadline& deadline) {
  return SideCosts(order, edges).run(deadline);
}

}  // namespace mwt
