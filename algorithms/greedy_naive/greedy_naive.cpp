#include "algorithms/greedy_naive/greedy_naive.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/step_trace.h"
#include "geometry/convex_hull.h"
#include "geometry/mesh/edge_order.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr Index kMaxN = 10'000;  // 50 million pairs: about a gigabyte

std::uint64_t bytes_for_pairs(std::uint64_t n) { return n * (n - 1) / 2 * 24; }

// Nothing if the deadline passes first.
std::optional<std::vector<Edge>> sorted_pairs(Points points, const Deadline& deadline) {
  const auto n = static_cast<Index>(points.size());
  std::vector<Edge> pairs;
  pairs.reserve(points.size() * (points.size() - 1) / 2);
  for (Index a = 0; a < n; ++a) {
    if (has_passed(deadline)) return {};
    for (Index b = a + 1; b < n; ++b) pairs.push_back({a, b});
  }
  if (!sort_by_length(points, pairs, [&] { return has_passed(deadline); })) return {};
  return pairs;
}

// The edges kept so far, with their bounding boxes.
class KeptEdges {
 public:
  explicit KeptEdges(Points points) : points_(points) {}

  void add(const Edge& edge) {
    edges_.push_back(edge);
    boxes_.push_back(box_of(edge));
  }

  // Whether `edge` crosses any of them. The last ones are the longest, so they are tested first.
  [[nodiscard]] bool cross(const Edge& edge) const {
    const Box box = box_of(edge);
    for (std::size_t i = edges_.size(); i-- > 0;) {
      if (meet(box, boxes_[i]) && cross(edge, edges_[i])) return true;
    }
    return false;
  }

 private:
  struct Box {
    double left, right, bottom, top;
  };

  [[nodiscard]] Box box_of(const Edge& edge) const {
    const auto [left, right] = std::minmax(points_[edge.a].x, points_[edge.b].x);
    const auto [bottom, top] = std::minmax(points_[edge.a].y, points_[edge.b].y);
    return {left, right, bottom, top};
  }

  static bool meet(const Box& p, const Box& q) {
    return p.left <= q.right && q.left <= p.right && p.bottom <= q.top && q.bottom <= p.top;
  }

  [[nodiscard]] bool cross(const Edge& e, const Edge& f) const {
    if (e.a == f.a) return overlap_from(e.a, e.b, f.b);
    if (e.a == f.b) return overlap_from(e.a, e.b, f.a);
    if (e.b == f.a) return overlap_from(e.b, e.a, f.b);
    if (e.b == f.b) return overlap_from(e.b, e.a, f.a);
    return segments_cross(points_[e.a], points_[e.b], points_[f.a], points_[f.b]);
  }

  // segments_cross for segments from one end: only overlap counts. Spares its exact tests of equal points.
  [[nodiscard]] bool overlap_from(Index end, Index p, Index q) const {
    return orientation(points_[end], points_[p], points_[q]) == 0 && dot_sign(points_[p], points_[end], points_[q]) > 0;
  }

  Points points_;
  std::vector<Edge> edges_;
  std::vector<Box> boxes_;
};

// Puts triangles together from edges.
class TriangleAssembly {
 public:
  explicit TriangleAssembly(Points points) : points_(points), neighbours_(points.size()) {}

  // Adds the edge and every triangle that it completes.
  void add(const Edge& edge) {
    std::vector<Index> apexes;
    std::set_intersection(neighbours_[edge.a].begin(), neighbours_[edge.a].end(), neighbours_[edge.b].begin(),
                          neighbours_[edge.b].end(), std::back_inserter(apexes));
    for (const Index apex : apexes) add_if_empty(edge, apex);
    insert_sorted(neighbours_[edge.a], edge.b);
    insert_sorted(neighbours_[edge.b], edge.a);
  }

  [[nodiscard]] std::size_t count() const { return triangles_.size(); }
  [[nodiscard]] std::vector<Triangle> take() { return std::move(triangles_); }

 private:
  static void insert_sorted(std::vector<Index>& row, Index value) {
    row.insert(std::lower_bound(row.begin(), row.end(), value), value);
  }

  void add_if_empty(const Edge& edge, Index apex) {
    Triangle triangle = {edge.a, edge.b, apex};
    if (orientation(points_[edge.a], points_[edge.b], points_[apex]) < 0) std::swap(triangle[1], triangle[2]);
    if (!is_empty(triangle)) return;
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    triangles_.push_back(triangle);
  }

  [[nodiscard]] bool is_empty(const Triangle& triangle) const {
    const Point &a = points_[triangle[0]], &b = points_[triangle[1]], &c = points_[triangle[2]];
    const auto [bottom, top] = std::minmax({a.y, b.y, c.y});
    const auto [left, right] = std::minmax({a.x, b.x, c.x});
    for (Index i = 0; i < points_.size(); ++i) {
      const Point& p = points_[i];
      if (p.x < left || p.x > right || p.y < bottom || p.y > top) continue;
      const bool is_corner = i == triangle[0] || i == triangle[1] || i == triangle[2];
      if (!is_corner && in_closed_triangle(p, a, b, c)) return false;
    }
    return true;
  }

  Points points_;
  std::vector<std::vector<Index>> neighbours_;  // sorted
  std::vector<Triangle> triangles_;
};

void require_moderate_size(Points points) {
  if (points.size() <= kMaxN) return;
  throw NotApplicable(
      fmt::format("greedy_naive sorts all pairs of points and takes at most {} points; this instance has {}", kMaxN,
                  points.size()));
}

Solution solve(Points points, Context& context) {
  require_moderate_size(points);
  Solution solution;
  const ScopedPhase phase(context, "greedy");
  std::optional<Triangulation> result;
  if (context.fits(bytes_for_pairs(points.size()))) {
    result = greedy_naive(points, deadline_before_heuristics(context.deadline, points.size()), context.steps);
    if (!result) solution.stop_reason = StopReason::deadline;
  } else {
    solution.stop_reason = StopReason::memory;
  }
  solution.triangulation = result ? *std::move(result) : greedy_triangulation(points);
  return solution;
}

}  // namespace

Triangulation greedy_naive(Points points) { return *greedy_naive(points, Deadline{}); }

std::optional<Triangulation> greedy_naive(Points points, const Deadline& deadline, StepTrace* steps) {
  require_moderate_size(points);
  const std::size_t wanted = 2 * points.size() - convex_hull(points).size() - 2;
  KeptEdges kept(points);
  TriangleAssembly assembly(points);
  const std::optional<std::vector<Edge>> pairs = sorted_pairs(points, deadline);
  if (!pairs) return {};
  constexpr std::size_t kPairsBetweenChecks = 64;
  for (std::size_t i = 0; assembly.count() < wanted; ++i) {
    if (i % kPairsBetweenChecks == 0 && has_passed(deadline)) return {};
    const Edge& pair = (*pairs)[i];
    if (kept.cross(pair)) continue;
    kept.add(pair);
    if (steps != nullptr) steps->kept.push_back(pair);
    assembly.add(pair);
  }
  return Triangulation{static_cast<Index>(points.size()), assembly.take()};
}

AlgorithmInfo greedy_naive_entry() {
  AlgorithmInfo info;
  info.name = "greedy_naive";
  info.summary = "greedy: shortest pairs first, as the source report writes it";
  info.source = "source report, section 5.1";
  info.guarantee = "Theta(sqrt n) in the worst case (Levcopoulos 1987; Levcopoulos and Krznaric 1998)";
  info.time = "O(n^3) worst case (the source report bounds it by O(n^4))";
  info.space = "O(n^2)";
  info.max_n = 4000;
  info.has_steps = true;
  info.function = solve;
  return info;
}

}  // namespace mwt
