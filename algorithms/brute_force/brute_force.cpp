#include "algorithms/brute_force/brute_force.h"

#include <bitset>
#include <string>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/max_points.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/common/solve_scaled.h"
#include "geometry/convex_hull.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxEdges = kBruteForceMaxN * (kBruteForceMaxN - 1) / 2;
using EdgeSet = std::bitset<kMaxEdges>;

// Numbers all edges and triangles of a few points once, so that the enumeration works on sets of numbers.
class SmallGeometry {
 public:
  explicit SmallGeometry(Points points) : points_(points), n_(static_cast<Index>(points.size())) {
    for (Index a = 0; a < n_; ++a) {
      for (Index b = a + 1; b < n_; ++b) {
        edges_.push_back({a, b});
        lengths_.push_back(length(points[a], points[b]));
      }
    }
    find_crossings();
    find_apexes();
  }

  [[nodiscard]] std::size_t number(Index a, Index b) const {
    const Edge edge = make_edge(a, b);
    return std::size_t{edge.a} * (2 * n_ - edge.a - 1) / 2 + (edge.b - edge.a - 1);
  }
  [[nodiscard]] const Edge& edge(std::size_t number) const { return edges_[number]; }
  [[nodiscard]] const DoubleDouble& length_of(std::size_t edge) const { return lengths_[edge]; }
  [[nodiscard]] const EdgeSet& crossing(std::size_t edge) const { return crossing_[edge]; }

  /// The points that make an empty triangle on the left of a -> b.
  [[nodiscard]] const std::vector<Index>& apexes(Index a, Index b) const { return apexes_[a * n_ + b]; }

 private:
  void find_crossings() {
    crossing_.resize(edges_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      for (std::size_t f = 0; f < edges_.size(); ++f) {
        const Edge &one = edges_[e], &two = edges_[f];
        if (e != f && segments_cross(points_[one.a], points_[one.b], points_[two.a], points_[two.b])) {
          crossing_[e].set(f);
        }
      }
    }
  }

  [[nodiscard]] bool is_empty_triangle(Index a, Index b, Index c) const {
    if (orientation(points_[a], points_[b], points_[c]) <= 0) return false;
    for (Index p = 0; p < n_; ++p) {
      const bool is_corner = p == a || p == b || p == c;
      if (!is_corner && in_closed_triangle(points_[p], points_[a], points_[b], points_[c])) return false;
    }
    return true;
  }

  void find_apexes() {
    apexes_.resize(std::size_t{n_} * n_);
    for (Index a = 0; a < n_; ++a) {
      for (Index b = 0; b < n_; ++b) {
        for (Index c = 0; c < n_; ++c) {
          const bool distinct = a != b && b != c && c != a;
          if (distinct && is_empty_triangle(a, b, c)) apexes_[a * n_ + b].push_back(c);
        }
      }
    }
  }

  Points points_;
  Index n_;
  std::vector<Edge> edges_;
  std::vector<DoubleDouble> lengths_;
  std::vector<EdgeSet> crossing_;
  std::vector<std::vector<Index>> apexes_;
};

class Enumeration {
 public:
  Enumeration(Points points, const Context& context) : points_(points), context_(context), geometry_(points) {
    const std::vector<Index> hull = convex_hull(points);
    Region region;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Index a = hull[i], b = hull[(i + 1) % hull.size()];
      region.edges.set(geometry_.number(a, b));
      region.open_from(a, b).set(geometry_.number(a, b));
    }
    grow(region);
  }

  BruteForceResult result() {
    const Triangulation lightest{static_cast<Index>(points_.size()), best_};
    const double terms = 3 * static_cast<double>(points_.size());
    const double lower = enclose(best_weight_, (terms + 8) * kDoubleDoubleError).lower;
    return {lightest, {lower, weight(points_, lightest).upper}, count_, !stopped_};
  }

 private:
  // What is triangulated so far: its edges, and those of them that still lack a triangle on their left, by direction.
  struct Region {
    EdgeSet edges;
    EdgeSet open_upwards;    // left of a -> b, a < b
    EdgeSet open_downwards;  // left of b -> a

    EdgeSet& open_from(Index a, Index b) { return a < b ? open_upwards : open_downwards; }
  };

  void grow(const Region& region) {
    if (region.open_upwards.none() && region.open_downwards.none()) {
      weigh(region.edges);
      return;
    }
    const bool upwards = region.open_upwards.any();
    const Edge& edge = geometry_.edge((upwards ? region.open_upwards : region.open_downwards)._Find_first());
    const Index a = upwards ? edge.a : edge.b, b = upwards ? edge.b : edge.a;
    for (const Index c : geometry_.apexes(a, b)) {
      Region grown = region;
      if (!close(grown, a, b) || !close(grown, b, c) || !close(grown, c, a)) continue;
      triangles_.push_back({a, b, c});
      grow(grown);
      triangles_.pop_back();
      if (stopped_) return;
    }
  }

  // Puts a triangle on the left of a -> b, unless the edge crosses another or has one there already.
  bool close(Region& region, Index a, Index b) const {
    const std::size_t edge = geometry_.number(a, b);
    if (region.edges.test(edge)) {
      const bool was_open = region.open_from(a, b).test(edge);
      region.open_from(a, b).reset(edge);
      return was_open;
    }
    if ((region.edges & geometry_.crossing(edge)).any()) return false;
    region.edges.set(edge);
    region.open_from(b, a).set(edge);
    return true;
  }

  void weigh(const EdgeSet& edges) {
    DoubleDouble total;
    for (std::size_t e = edges._Find_first(); e < edges.size(); e = edges._Find_next(e))
      total += geometry_.length_of(e);
    if (count_++ == 0 || total < best_weight_) {
      best_weight_ = total;
      best_ = triangles_;
    }
    stopped_ = context_.deadline_passed();
  }

  Points points_;
  const Context& context_;
  SmallGeometry geometry_;
  std::vector<Triangle> triangles_;  // of the region at hand
  std::vector<Triangle> best_;
  DoubleDouble best_weight_;
  std::uint64_t count_ = 0;
  bool stopped_ = false;
};

Solution solve(Points points, Context& context) {
  require_max_points("brute_force", points, context, kBruteForceMaxN);
  BruteForceResult result = [&] {
    const OtherDeadline leaving_time(context, deadline_before_heuristics(context.deadline, points.size()));
    return enumerate_triangulations(points, context);
  }();
  Solution solution;
  solution.triangulation = std::move(result.lightest);
  solution.counters["triangulations"] = static_cast<double>(result.count);
  if (result.complete) {
    solution.optimum = result.optimum;
    solution.count = std::to_string(result.count);
  } else {
    solution.stop_reason = StopReason::deadline;
    solution.optimum = {cycle_length(points, convex_hull(points)).lower, result.optimum.upper};
    improve_by_heuristics(points, context, solution);
  }
  return solution;
}

Solution solve_at_any_size(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

BruteForceResult enumerate_triangulations(Points points, const Context& context) {
  return Enumeration(points, context).result();
}

AlgorithmInfo brute_force_entry() {
  AlgorithmInfo info;
  info.name = "brute_force";
  info.summary = "enumerates every triangulation once, keeps the lightest and counts them";
  info.source = "source report, section 4";
  info.guarantee = "optimal; with too little time a certified interval";
  info.time = "O(n) per triangulation, exponentially many";
  info.space = "O(n^3)";
  info.exactness = Exactness::exact;
  info.max_n = 13;
  info.version = 2;
  info.parameters = {{"max_points", ParameterType::integer, "14", "largest number of points it takes, 3 to 16"}};
  info.function = solve_at_any_size;
  return info;
}

}  // namespace mwt
