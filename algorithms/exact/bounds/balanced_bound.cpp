#include "algorithms/exact/bounds/balanced_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/common/rows.h"
#include "algorithms/exact/holes/triangle_emptiness.h"
#include "geometry/numbers/double_double.h"
#include "geometry/numbers/interval.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxTriangles = std::size_t{1} << 23;
constexpr std::size_t kMaxRounds = 400;
constexpr std::size_t kRoundsBeforeEmptiness = 2;  // so that there is some bound whatever the time
constexpr std::size_t kMaxVisits = 1'000'000'000;  // of triangles, in all rounds together
// A round that raises the bound by less than this, relatively, is the last.
constexpr double kNegligibleGain = 1e-5;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A directed side of triangles to its left: 2 e and 2 e + 1 are edge e in both directions.
using Side = std::uint32_t;

// Vertices by their place in the region's list. Edges: the candidates, then those of the boundary.
class BalancedBound {
 public:
  BalancedBound(Points points, const FaceRegion& region, const Deadline& deadline)
      : deadline_(deadline), points_(region.points_among(points)), edges_(region.in_places(region.candidates)) {
    candidates_ = edges_.size();
    std::vector<Edge> boundary = region.in_places(region.boundary);
    for (const Edge& edge : undirected_edges(boundary)) edges_.push_back(edge);
    std::sort(boundary.begin(), boundary.end());
    is_inside_.assign(2 * edges_.size(), true);
    for (auto e = static_cast<Side>(candidates_); e < edges_.size(); ++e) {
      for (const Side side : {2 * e, 2 * e + 1})
        is_inside_[side] = std::binary_search(boundary.begin(), boundary.end(), directed(side));
    }
    for (const Edge& edge : edges_) length_.push_back(length(points_[edge.a], points_[edge.b]).high);
  }

  double run() {
    if (!list_triangles()) return 0;
    dual_.assign(is_inside_.size(), 0);
    file_triangles();
    balance(kRoundsBeforeEmptiness);
    leave_out_occupied();
    file_triangles();
    balance(kMaxRounds);
    return certified_bound();
  }

 private:
  struct Column {
    std::array<Side, 3> side;
    double reduced_cost = 0;
  };
  struct Neighbour {
    Index to;
    std::uint32_t edge;
  };

  [[nodiscard]] bool is_candidate(Side side) const { return side / 2 < candidates_; }
  [[nodiscard]] Edge directed(Side side) const {
    const Edge& edge = edges_[side / 2];
    return side % 2 == 0 ? edge : Edge{edge.b, edge.a};
  }
  [[nodiscard]] Side side_from(Index from, std::uint32_t edge) const {
    return 2 * edge + (edges_[edge].a == from ? 0 : 1);
  }

  // Each triangle from its corner with the fewest edges, so that large stars cost little.
  bool list_triangles() {
    const Rows<Neighbour> stars = file_in_rows<Neighbour>(points_.size(), [&](const auto& file) {
      for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        file(edges_[e].a, {edges_[e].b, e});
        file(edges_[e].b, {edges_[e].a, e});
      }
    });
    const auto comes_before = [&](Index v, Index w) {
      return std::pair(stars[v].size(), v) < std::pair(stars[w].size(), w);
    };
    const Rows<Neighbour> later = file_in_rows<Neighbour>(points_.size(), [&](const auto& file) {
      for (Index v = 0; v < points_.size(); ++v) {
        for (const Neighbour& to : stars[v]) {
          if (comes_before(v, to.to)) file(v, to);
        }
      }
    });
    std::vector<std::uint32_t> edge_to(points_.size(), kNoIndex);
    for (Index a = 0; a < points_.size(); ++a) {
      if (has_passed(deadline_) || columns_.size() > kMaxTriangles) return false;
      for (const Neighbour& to : later[a]) edge_to[to.to] = to.edge;
      for (const Neighbour& ab : later[a]) {
        for (const Neighbour& bc : later[ab.to]) {
          if (edge_to[bc.to] != kNoIndex) add_triangle(a, ab, bc, edge_to[bc.to]);
        }
      }
      for (const Neighbour& to : later[a]) edge_to[to.to] = kNoIndex;
    }
    return true;
  }

  void add_triangle(Index a, const Neighbour& ab, const Neighbour& bc, std::uint32_t ca) {
    const int turn = orientation(points_[a], points_[ab.to], points_[bc.to]);
    if (turn == 0) return;
    Column column{{side_from(a, ab.edge), side_from(ab.to, bc.edge), side_from(bc.to, ca)}, 0};
    if (turn < 0) {
      for (Side& side : column.side) side ^= 1U;
    }
    if (std::all_of(column.side.begin(), column.side.end(), [&](Side side) { return is_inside_[side]; }))
      columns_.push_back(column);
  }

  void leave_out_occupied() {
    constexpr std::size_t kColumnsPerDeadlineCheck = 256;
    const TriangleEmptiness emptiness(points_);
    std::size_t kept = 0, i = 0;
    for (; i < columns_.size(); ++i) {
      if (i % kColumnsPerDeadlineCheck == 0 && has_passed(deadline_)) break;
      if (is_empty(emptiness, columns_[i])) columns_[kept++] = columns_[i];
    }
    columns_.erase(columns_.begin() + static_cast<std::ptrdiff_t>(kept),
                   columns_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  [[nodiscard]] bool is_empty(const TriangleEmptiness& emptiness, const Column& column) const {
    const Edge first = directed(column.side[0]), second = directed(column.side[1]);
    const Index apex = second.a == first.b ? second.b : second.a;
    return emptiness.is_empty(first.a, first.b, apex);
  }

  void file_triangles() {
    for (Column& column : columns_) {
      column.reduced_cost = 0;
      for (const Side side : column.side)
        column.reduced_cost += (is_candidate(side) ? length_[side / 2] / 2 : 0) - dual_[side];
    }
    columns_at_ = file_in_rows<std::uint32_t>(is_inside_.size(), [&](const auto& file) {
      for (std::uint32_t c = 0; c < columns_.size(); ++c) {
        for (const Side side : columns_[c].side) file(side, c);
      }
    });
  }

  [[nodiscard]] double least_at(Side side) const {
    double least = kInfinity;
    for (const std::uint32_t c : std::as_const(columns_at_)[side]) least = std::min(least, columns_[c].reduced_cost);
    return least;
  }

  void add_dual(Side side, double change) {
    dual_[side] += change;
    for (const std::uint32_t c : std::as_const(columns_at_)[side]) columns_[c].reduced_cost -= change;
  }

  // Short edges first and last in turn, so that changes spread both ways.
  void balance(std::size_t max_rounds) {
    constexpr std::size_t kEdgesPerDeadlineCheck = 1024;
    std::vector<std::uint32_t> order(edges_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t e, std::uint32_t f) { return std::pair(length_[e], e) < std::pair(length_[f], f); });
    const std::size_t rounds = std::min(max_rounds, kMaxVisits / (columns_.size() + 1));
    for (std::size_t round = 0; round < rounds; ++round) {
      double gain = 0;
      for (std::size_t i = 0; i < order.size(); ++i) {
        if (i % kEdgesPerDeadlineCheck == 0 && has_passed(deadline_)) return;
        gain += balance_edge(order[i]);
      }
      sum_ += gain;
      if (round > 0 && gain <= kNegligibleGain * sum_) return;
      std::reverse(order.begin(), order.end());
    }
  }

  // Returns by how much the boundary's dual values rise.
  double balance_edge(std::uint32_t edge) {
    const Side forward = 2 * edge, backward = 2 * edge + 1;
    const double left = least_at(forward), right = least_at(backward);
    if (edge < candidates_) {
      if (left == kInfinity || right == kInfinity) {
        price_out(left == kInfinity ? backward : forward);
      } else if (left != right) {
        add_dual(forward, (left - right) / 2);
        add_dual(backward, (right - left) / 2);
      }
      return 0;
    }
    double gain = 0;
    for (const auto& [side, least] : {std::pair(forward, left), std::pair(backward, right)}) {
      if (least == kInfinity || least <= 0) continue;
      add_dual(side, least);
      gain += least;
    }
    return gain;
  }

  // A candidate without a triangle on its other side is in no triangulation, nor are its triangles.
  void price_out(Side side) {
    for (const std::uint32_t c : std::as_const(columns_at_)[side]) columns_[c].reduced_cost = kInfinity;
  }

  // Of the triangles at a directed side, a triangulation has at most one: what is negative counts once at each.
  [[nodiscard]] double certified_bound() const {
    constexpr double kRounding = 0x1p-49;    // three terms of each kind, each rounded a few times
    constexpr double kDenormal = 0x1p-1000;  // where products lose their last bits
    std::vector<double> least(dual_.size(), 0);
    for (const Column& column : columns_) {
      if (column.reduced_cost == kInfinity) continue;
      double cost = 0, size = 0;
      for (const Side side : column.side) {
        // A candidate's forward dual value counts on both sides: they are opposite exactly.
        const double dual = is_candidate(side) && side % 2 == 1 ? -dual_[side - 1] : dual_[side];
        const double own = is_candidate(side) ? length_[side / 2] / 2 : 0;
        cost += own - dual;
        size += own + std::abs(dual);
      }
      const double certain = cost - (kRounding * size + kDenormal);
      if (certain < 0) least[column.side[0]] = std::min(least[column.side[0]], certain);
    }
    double bound = 0;
    for (Side side = static_cast<Side>(2 * candidates_); side < dual_.size(); ++side)
      bound = next_down(bound + dual_[side]);
    for (const double loss : least) {
      if (loss < 0) bound = next_down(bound + loss);
    }
    return std::max(0.0, bound);
  }

  const Deadline& deadline_;
  std::vector<Point> points_;
  std::vector<Edge> edges_;  // a < b
  std::size_t candidates_ = 0;
  std::vector<bool> is_inside_;  // by side: whether a triangle may lie to its left
  std::vector<double> length_;   // by edge
  std::vector<Column> columns_;
  Rows<std::uint32_t> columns_at_;  // by side
  std::vector<double> dual_;        // by side
  double sum_ = 0;                  // of the boundary's dual values, rounded
};

}  // namespace

double balanced_bound(Points points, const FaceRegion& region, const Deadline& deadline) {
  return BalancedBound(points, region, deadline).run();
}

}  // namespace mwt
