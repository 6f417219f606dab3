#include "algorithms/exact/bounds/count_bound.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "algorithms/common/rows.h"
#include "algorithms/exact/bounds/side_costs.h"
#include "algorithms/exact/bounds/simple_bound.h"
#include "algorithms/exact/candidates/kd_order.h"
#include "algorithms/exact/division/beta_skeleton.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/double_double.h"
#include "geometry/numbers/interval.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/triangulation.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// So few certain edges take less time than a deadline may be exceeded by: 0.2 s for 10,000 points.
constexpr std::size_t kFewEdges = 10'000;

constexpr std::size_t kNeighbours = 10;

// The nearest other points, by squared distance; fewer if there are fewer points.
struct Nearest {
  struct Neighbour {
    double square = std::numeric_limits<double>::infinity();
    Index to = kNoIndex;
  };
  std::array<Neighbour, kNeighbours> all;  // ascending; unused ones last

  void consider(double square, Index to) {
    if (square >= all.back().square) return;
    std::size_t place = kNeighbours - 1;
    for (; place > 0 && all[place - 1].square > square; --place) all[place] = all[place - 1];
    all[place] = {square, to};
  }

  // All points that are not among these are at least so far away, rounding included. Squares that overflow are of
  // longer distances than the largest that is trusted; those that underflow say nothing.
  [[nodiscard]] double reach() const {
    const double square = std::min(all.back().square, kMaxTrustedProduct);
    return square > kMinTrustedProduct ? std::sqrt(square) * (1 - 0x1p-49) : 0;
  }
  [[nodiscard]] bool contains(Index v) const {
    return std::any_of(all.begin(), all.end(), [&](const Neighbour& neighbour) { return neighbour.to == v; });
  }
};

class NeighbourSearch {
 public:
  explicit NeighbourSearch(const KdOrder& order) : order_(order) {}

  // By position in the order. Nothing if the deadline passes.
  [[nodiscard]] std::optional<std::vector<Nearest>> run(const Deadline& deadline) const {
    constexpr std::uint32_t kLeavesPerDeadlineCheck = 16;
    std::vector<Nearest> nearest(order_.points.size());
    std::atomic<bool> is_late = false;
    tbb::parallel_for(order_.leaf_count, 2 * order_.leaf_count, [&](std::uint32_t leaf) {
      if (leaf % kLeavesPerDeadlineCheck == 0 && has_passed(deadline)) is_late = true;
      if (is_late) return;
      for (Index v = order_.first_of(leaf); v < order_.last_of(leaf); ++v) nearest[v] = nearest_of(v, leaf);
    });
    if (is_late) return {};
    return nearest;
  }

 private:
  [[nodiscard]] Nearest nearest_of(Index v, std::uint32_t leaf) const {
    Nearest nearest;
    search_leaf(leaf, v, nearest);
    std::array<std::uint32_t, 64> stack{1};  // a path in the tree and its siblings
    std::size_t height = 1;
    while (height > 0) {
      const std::uint32_t node = stack[--height];
      if (square_to(order_.boxes[node], order_.points[v]) >= nearest.all.back().square) continue;
      if (order_.is_leaf(node)) {
        if (node != leaf) search_leaf(node, v, nearest);
        continue;
      }
      const bool is_low_nearer = square_to(order_.boxes[2 * node], order_.points[v]) <=
                                 square_to(order_.boxes[2 * node + 1], order_.points[v]);
      stack[height++] = is_low_nearer ? 2 * node + 1 : 2 * node;
      stack[height++] = is_low_nearer ? 2 * node : 2 * node + 1;
    }
    return nearest;
  }

  void search_leaf(std::uint32_t leaf, Index v, Nearest& nearest) const {
    const Point& p = order_.points[v];
    for (Index w = order_.first_of(leaf); w < order_.last_of(leaf); ++w) {
      const double x = order_.points[w].x - p.x, y = order_.points[w].y - p.y;
      if (w != v) nearest.consider(x * x + y * y, w);
    }
  }

  static double square_to(const Box& box, const Point& p) {
    const double x = std::max({0.0, box.min_x - p.x, p.x - box.max_x});
    const double y = std::max({0.0, box.min_y - p.y, p.y - box.max_y});
    return x * x + y * y;
  }

  const KdOrder& order_;
};

// Points by position in the order.
class CountBound {
 public:
  CountBound(const KdOrder& order, const Deadline& deadline) : order_(order), points_(order.points) {
    if (auto found = NeighbourSearch(order_).run(deadline)) nearest_ = *std::move(found);
    const std::vector<Index> hull = convex_hull(points_);
    hull_size_ = hull.size();
    std::vector<Edge> certain = beta_skeleton(points_);
    for (std::size_t i = 0; i < hull.size(); ++i) certain.push_back({hull[i], hull[(i + 1) % hull.size()]});
    certain_ = undirected_edges(std::move(certain));
    for (const Edge& edge : certain_) certain_length_.add(points_[edge.a], points_[edge.b]);
    // A part of the sides would make a bound that more time elsewhere may lower.
    sides_ = side_costs(order_, certain_, certain_.size() <= kFewEdges ? Deadline() : deadline);
  }

  [[nodiscard]] double run() {
    const double others = by_counts_and_sides(nearest_.empty() ? std::vector<double>() : lengths_of_others());
    const double bound = std::max(0.0, next_down(certain_length_.enclosure().lower + others));
    return nearest_.empty() ? std::max(bound, simple_lower_bound(points_)) : bound;
  }

 private:
  // The part of each length above a cap counts once for each edge, the part below it at the sides of certain edges.
  [[nodiscard]] double by_counts_and_sides(const std::vector<double>& lengths) const {
    constexpr int kCaps = 48;
    std::vector<double> sums{0};  // of the longest ones
    for (const double length : lengths) sums.push_back(std::max(0.0, next_down(sums.back() + length)));
    double best = std::max(sums.back(), cost_of_sides(std::numeric_limits<double>::infinity()));
    double cap = lengths.empty() ? 0 : lengths.front();
    for (int i = 0; i < kCaps && cap > 0; ++i, cap /= 2) {
      const auto longer = std::partition_point(lengths.begin(), lengths.end(), [&](double x) { return x > cap; });
      const auto count = static_cast<std::size_t>(longer - lengths.begin());
      const double above = std::max(0.0, next_down(sums[count] - next_up(static_cast<double>(count) * cap)));
      best = std::max(best, next_down(above + cost_of_sides(cap)));
    }
    return best;
  }

  [[nodiscard]] double cost_of_sides(double cap) const {
    double sum = 0;
    for (const SideCost& side : sides_) sum = std::max(0.0, next_down(sum + side.capped(cap)));
    return sum;
  }

  // At least these: of the edges that are not certain, the longest first.
  [[nodiscard]] std::vector<double> lengths_of_others() {
    rank_vertices();
    const Rows<double> own = lengths_by_later_end();
    const std::vector<std::size_t> certain_at = certain_by_later_end();
    std::priority_queue<double> taken;  // lengths, the longest on top
    std::size_t certain = 0;
    for (std::size_t i = 0; i < by_reach_.size(); ++i) {
      certain += certain_at[i];
      const std::size_t room = most_edges(i + 1) - std::min(certain, most_edges(i + 1));
      for (const double length : own[i]) taken.push(length);
      while (taken.size() < room) taken.push(nearest_[by_reach_[i]].reach());
      while (taken.size() > room) taken.pop();
    }
    const std::size_t others = 3 * points_.size() - 3 - hull_size_ - certain_.size();
    while (taken.size() > others) taken.pop();
    std::vector<double> lengths;
    for (; !taken.empty(); taken.pop()) lengths.push_back(taken.top());
    return lengths;
  }

  // Between so many points.
  static std::size_t most_edges(std::size_t points) { return points < 3 ? points - 1 : 3 * points - 6; }

  void rank_vertices() {
    by_reach_.resize(points_.size());
    std::iota(by_reach_.begin(), by_reach_.end(), Index{0});
    std::sort(by_reach_.begin(), by_reach_.end(), [&](Index v, Index w) {
      return std::pair(nearest_[v].all.back().square, v) < std::pair(nearest_[w].all.back().square, w);
    });
    rank_.resize(points_.size());
    for (std::size_t i = 0; i < by_reach_.size(); ++i) rank_[by_reach_[i]] = i;
  }

  [[nodiscard]] std::size_t later_end(const Edge& edge) const { return std::max(rank_[edge.a], rank_[edge.b]); }

  // Of the pairs of which one is among the nearest of the other, and not certain.
  [[nodiscard]] Rows<double> lengths_by_later_end() const {
    return file_in_rows<double>(points_.size(), [&](const auto& file) {
      for (Index v = 0; v < points_.size(); ++v) {
        for (const Nearest::Neighbour& neighbour : nearest_[v].all) {
          const Index w = neighbour.to;
          if (w == kNoIndex || (w < v && nearest_[w].contains(v))) continue;  // listed there
          const Edge edge = make_edge(v, w);
          if (std::binary_search(certain_.begin(), certain_.end(), edge)) continue;
          file(later_end(edge), std::max(0.0, next_down(length(points_[v], points_[w]).high)));
        }
      }
    });
  }

  [[nodiscard]] std::vector<std::size_t> certain_by_later_end() const {
    std::vector<std::size_t> count(points_.size(), 0);
    for (const Edge& edge : certain_) ++count[later_end(edge)];
    return count;
  }

  const KdOrder& order_;
  Points points_;
  std::size_t hull_size_ = 0;
  std::vector<Edge> certain_;  // ascending
  LengthSum certain_length_;
  std::vector<SideCost> sides_;   // of the certain edges
  std::vector<Nearest> nearest_;  // of each point; none: there was no time
  std::vector<Index> by_reach_;
  std::vector<std::size_t> rank_;  // of each point among these
};

}  // namespace

double bound_by_counts(Points points, const Deadline& deadline) {
  const KdOrder order = make_kd_order(points);
  return CountBound(order, deadline).run();
}

}  // namespace mwt
