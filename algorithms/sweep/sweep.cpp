#include "algorithms/sweep/sweep.h"

#include <utility>

#include "geometry/predicates.h"

namespace mwt {

namespace {

// The triangulation so far with the counter-clockwise cycle of its hull, collinear points included.
class Sweep {
 public:
  Sweep(Points points, std::vector<Index> order)
      : points_(points), order_(std::move(order)), next_(points.size()), previous_(points.size()) {
    for (std::size_t i = join_collinear_run() + 1; i < order_.size(); ++i) join(order_[i], order_[i - 1]);
  }

  std::vector<Triangle> take() { return std::move(triangles_); }

 private:
  void link(Index u, Index v) {
    next_[u] = v;
    previous_[v] = u;
  }

  // Joins the first point off the initial line to the points on it. Returns its position in the order.
  std::size_t join_collinear_run() {
    std::size_t first_off = 2;
    int turn = 0;
    while ((turn = orientation(points_[order_[0]], points_[order_[1]], points_[order_[first_off]])) == 0) ++first_off;
    const Index p = order_[first_off];
    for (std::size_t i = 0; i + 1 < first_off; ++i) {
      const auto [u, v] = turn > 0 ? std::pair(order_[i], order_[i + 1]) : std::pair(order_[i + 1], order_[i]);
      triangles_.push_back({u, v, p});
      link(u, v);
    }
    const Index lowest = order_[0], highest = order_[first_off - 1];
    link(turn > 0 ? highest : lowest, p);
    link(p, turn > 0 ? lowest : highest);
    return first_off;
  }

  // p, lexicographically larger than all points so far, sees `last`, the largest of them.
  void join(Index p, Index last) {
    Index after = last;
    for (; sees(p, after, next_[after]); after = next_[after]) triangles_.push_back({next_[after], after, p});
    Index before = last;
    for (; sees(p, previous_[before], before); before = previous_[before]) {
      triangles_.push_back({before, previous_[before], p});
    }
    link(before, p);
    link(p, after);
  }

  [[nodiscard]] bool sees(Index p, Index u, Index v) const {
    return orientation(points_[u], points_[v], points_[p]) < 0;
  }

  Points points_;
  std::vector<Index> order_;
  std::vector<Index> next_;
  std::vector<Index> previous_;
  std::vector<Triangle> triangles_;
};

Solution solve(Points points, Context&) {
  Solution solution;
  solution.triangulation = sweep_triangulation(points);
  return solution;
}

}  // namespace

Triangulation sweep_triangulation(Points points) {
  return {static_cast<Index>(points.size()), Sweep(points, lexicographic_order(points)).take()};
}

AlgorithmInfo sweep_entry() {
  AlgorithmInfo info;
  info.name = "sweep";
  info.summary = "left-to-right sweep that joins each point to all it sees";
  info.source = "folklore; the initial triangulation of the source report, section 5.3, is left open there";
  info.guarantee = "none: grows like sqrt(n) on uniform points";
  info.time = "O(n log n)";
  info.space = "O(n)";
  info.max_n = 10'000'000;
  info.function = solve;
  return info;
}

}  // namespace mwt
