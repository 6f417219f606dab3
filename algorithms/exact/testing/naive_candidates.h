// For tests only: candidate graphs and optima of small point sets by the definitions, without any cleverness.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/faces/face_region.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/double_double.h"
#include "geometry/predicates.h"
#include "geometry/triangulation.h"

namespace mwt::naive {

/// Every segment with no point in its interior, a < b, ascending. O(n^3).
inline std::vector<Edge> possible_edges(Points points) {
  std::vector<Edge> edges;
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) {
      const bool is_free = std::none_of(points.begin(), points.end(),
                                        [&](const Point& p) { return in_segment_interior(p, points[a], points[b]); });
      if (is_free) edges.push_back({a, b});
    }
  }
  return edges;
}

inline std::set<Edge> hull_edges(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  std::set<Edge> edges;
  for (std::size_t i = 0; i < hull.size(); ++i) edges.insert(make_edge(hull[i], hull[(i + 1) % hull.size()]));
  return edges;
}

/// Those of `edges` that none of them crosses.
inline std::set<Edge> uncrossed_edges(Points points, const std::vector<Edge>& edges) {
  std::set<Edge> result;
  for (const Edge& e : edges) {
    const bool is_crossed = std::any_of(edges.begin(), edges.end(), [&](const Edge& f) {
      return e != f && segments_cross(points[e.a], points[e.b], points[f.a], points[f.b]);
    });
    if (!is_crossed) result.insert(e);
  }
  return result;
}

inline CandidateGraph make_graph(Points points, const std::vector<Edge>& edges, const std::set<Edge>& certain) {
  return make_candidate_graph(points, edges, std::vector<Edge>(certain.begin(), certain.end()));
}

/// All within the hull, with every possible edge.
inline FaceRegion region_of_hull(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  FaceRegion region;
  for (Index v = 0; v < points.size(); ++v) region.vertices.push_back(v);
  for (std::size_t i = 0; i < hull.size(); ++i) region.boundary.push_back({hull[i], hull[(i + 1) % hull.size()]});
  const std::set<Edge> certain = hull_edges(points);
  for (const Edge& edge : possible_edges(points)) {
    if (!certain.contains(edge)) region.candidates.push_back(edge);
  }
  region.components = 1 + points.size() - hull.size();
  return region;
}

/// The graph in which `certain` and the hull's edges are certain, and candidates all that do not cross them.
inline CandidateGraph graph_with_certain(Points points, std::set<Edge> certain) {
  certain.merge(hull_edges(points));
  std::vector<Edge> edges;
  for (const Edge& e : possible_edges(points)) {
    const bool is_crossed = std::any_of(certain.begin(), certain.end(), [&](const Edge& f) {
      return segments_cross(points[e.a], points[e.b], points[f.a], points[f.b]);
    });
    if (!is_crossed || certain.contains(e)) edges.push_back(e);
  }
  return make_graph(points, edges, certain);
}

/// The edges left when those without a certificate are deleted again and again: a certificate of an edge is a pair of
/// empty triangles on its two sides, sides not deleted, whose quadrilateral is not strictly convex or has no shorter
/// diagonal.
class LocallyMinimalEdges {
 public:
  explicit LocallyMinimalEdges(Points points) : points_(points), edges_(possible_edges(points)) {
    const std::set<Edge> hull = hull_edges(points);
    remaining_.insert(edges_.begin(), edges_.end());
    const auto loses = [&](const Edge& e) {
      return remaining_.contains(e) && !hull.contains(e) && !has_certificate(e);
    };
    for (bool changed = true; changed;) {
      changed = false;
      for (const Edge& e : edges_) {
        if (!loses(e)) continue;
        remaining_.erase(e);
        changed = true;
      }
    }
  }

  [[nodiscard]] std::vector<Edge> edges() const { return {remaining_.begin(), remaining_.end()}; }

 private:
  [[nodiscard]] bool is_empty(Index a, Index b, Index c) const {
    for (Index p = 0; p < points_.size(); ++p) {
      const bool is_corner = p == a || p == b || p == c;
      if (!is_corner && in_closed_triangle(points_[p], points_[a], points_[b], points_[c])) return false;
    }
    return true;
  }

  // Apexes of empty triangles left of a -> b.
  [[nodiscard]] std::vector<Index> apexes(Index a, Index b) const {
    std::vector<Index> result;
    for (Index c = 0; c < points_.size(); ++c) {
      if (c == a || c == b || orientation(points_[a], points_[b], points_[c]) <= 0) continue;
      const bool has_sides = remaining_.contains(make_edge(a, c)) && remaining_.contains(make_edge(b, c));
      if (has_sides && is_empty(a, b, c)) result.push_back(c);
    }
    return result;
  }

  [[nodiscard]] bool has_certificate(const Edge& e) const {
    const std::vector<Index> left = apexes(e.a, e.b);
    const std::vector<Index> right = apexes(e.b, e.a);
    for (const Index l : left) {
      for (const Index r : right) {
        const auto [a, b, c, d] = std::array{points_[e.a], points_[r], points_[e.b], points_[l]};
        if (!is_strictly_convex(a, b, c, d) || compare_length(b, d, a, c) >= 0) return true;
      }
    }
    return false;
  }

  Points points_;
  std::vector<Edge> edges_;
  std::set<Edge> remaining_;
};

/// The weight of a minimum weight triangulation of up to about 16 points, by sweeping: a chain that is monotone in
/// lexicographic order moves from the lower hull to the upper hull over one empty triangle at a time.
class SweptOptimum {
 public:
  explicit SweptOptimum(Points input) : points_(input.begin(), input.end()) {
    std::sort(points_.begin(), points_.end(), lexicographically_less);
    best_.resize(std::size_t{1} << points_.size());
    const std::size_t n = points_.size();
    std::uint32_t lower = 0;
    for (std::size_t p = 0; p < n; ++p) {
      if (is_on_hull(p, 1)) lower |= 1U << p;
      if (is_on_hull(p, -1)) upper_ |= 1U << p;
    }
    value_ = chain_length(lower) + rest(lower);
  }

  [[nodiscard]] Interval weight() const { return enclose(value_, 200 * kDoubleDoubleError); }

 private:
  // Whether no point lies below (side 1) or above (side -1) point p on the hull's chain.
  [[nodiscard]] bool is_on_hull(std::size_t p, int side) const {
    for (std::size_t a = 0; a < p; ++a) {
      for (std::size_t b = p + 1; b < points_.size(); ++b) {
        if (orientation(points_[a], points_[b], points_[p]) * side > 0) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool is_empty(std::size_t a, std::size_t b, std::size_t c) const {
    for (std::size_t p = 0; p < points_.size(); ++p) {
      const bool is_corner = p == a || p == b || p == c;
      if (!is_corner && in_closed_triangle(points_[p], points_[a], points_[b], points_[c])) return false;
    }
    return true;
  }

  [[nodiscard]] std::vector<std::size_t> members(std::uint32_t chain) const {
    std::vector<std::size_t> result;
    for (std::size_t p = 0; p < points_.size(); ++p) {
      if (chain >> p & 1U) result.push_back(p);
    }
    return result;
  }

  [[nodiscard]] DoubleDouble chain_length(std::uint32_t chain) const {
    const auto chain_points = members(chain);
    DoubleDouble sum;
    for (std::size_t i = 1; i < chain_points.size(); ++i)
      sum += length(points_[chain_points[i - 1]], points_[chain_points[i]]);
    return sum;
  }

  // The least total length of edges above the chain; infinite where the chain leads nowhere.
  DoubleDouble rest(std::uint32_t chain) {
    if (chain == upper_) return {};
    if (best_[chain]) return *best_[chain];
    DoubleDouble least = std::numeric_limits<double>::infinity();
    const auto consider = [&](std::uint32_t next, const DoubleDouble& added) {
      const DoubleDouble after = rest(next);
      if (after.high == std::numeric_limits<double>::infinity()) return;
      const DoubleDouble total = added + after;
      if (total < least) least = total;
    };
    const auto on_chain = members(chain);
    for (std::size_t i = 1; i < on_chain.size(); ++i) {
      const std::size_t a = on_chain[i - 1], b = on_chain[i];
      for (std::size_t apex = a + 1; apex < b; ++apex) {
        const bool fits = orientation(points_[a], points_[b], points_[apex]) > 0 && is_empty(a, b, apex);
        if (fits) consider(chain | 1U << apex, length(points_[a], points_[apex]) + length(points_[apex], points_[b]));
      }
      if (i + 1 == on_chain.size()) continue;
      const std::size_t c = on_chain[i + 1];
      const bool is_convex = orientation(points_[a], points_[b], points_[c]) > 0 && is_empty(a, b, c);
      if (is_convex) consider(chain & ~(1U << b), length(points_[a], points_[c]));
    }
    best_[chain] = least;
    return least;
  }

  std::vector<Point> points_;
  std::uint32_t upper_ = 0;
  std::vector<std::optional<DoubleDouble>> best_;
  DoubleDouble value_;
};

}  // namespace mwt::naive
