#include "algorithms/exact/holes/region_triangles.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "algorithms/common/rows.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

// An edge in the star of one of its ends.
struct Spoke {
  Index to = 0;
  std::uint32_t under = 0;  // points under the edge
  bool leaves = false;      // a triangle may lie left of the edge, directed away from here
  bool arrives = false;     // or directed towards here
};

// Left, right, under and between refer to a sweep in lexicographic order: a point is under an edge if it
// lies between its ends in that order and to the right of the edge directed upwards.
class TriangleSearch {
 public:
  explicit TriangleSearch(Points points) : points_(points), place_of_(points.size(), kNoIndex) {}

  // Whether the deadline allowed it.
  bool file_sides(std::span<const Edge> sides, const Deadline& deadline) {
    std::vector<Edge> sorted_sides(sides.begin(), sides.end());
    std::sort(sorted_sides.begin(), sorted_sides.end());
    const std::vector<Edge> edges = undirected_edges(sorted_sides);
    std::vector<std::uint32_t> under;
    for (const Edge& edge : edges) {
      if (has_passed(deadline)) return false;
      under.push_back(count_under(edge));
    }
    file_spokes(sorted_sides, edges, under);
    return true;
  }

  // Appends the triangles whose smallest corner is a.
  void find_from(Index a, std::vector<Triangle>& triangles) {
    const std::span<const Spoke> star = std::as_const(spokes_)[a];
    for (std::uint32_t i = 0; i < star.size(); ++i) place_of_[star[i].to] = i;
    for (const Spoke& ab : star) {
      if (ab.leaves && ab.to > a) find_left_of(a, ab, triangles);
    }
    for (const Spoke& spoke : star) place_of_[spoke.to] = kNoIndex;
  }

 private:
  void file_spokes(const std::vector<Edge>& sides, const std::vector<Edge>& edges,
                   const std::vector<std::uint32_t>& under) {
    const auto is_side = [&](const Edge& edge) { return std::binary_search(sides.begin(), sides.end(), edge); };
    spokes_ = file_in_rows<Spoke>(points_.size(), [&](const auto& file) {
      for (std::size_t i = 0; i < edges.size(); ++i) {
        if (under[i] == kNoIndex) continue;
        const auto [a, b] = edges[i];
        const bool forward = is_side({a, b});
        const bool backward = is_side({b, a});
        file(a, {b, under[i], forward, backward});
        file(b, {a, under[i], backward, forward});
      }
    });
  }

  // kNoIndex if a point lies on the edge.
  [[nodiscard]] std::uint32_t count_under(const Edge& edge) const {
    std::uint32_t count = 0;
    for (Index p = edge.a + 1; p < edge.b; ++p) {
      const int turn = orientation(points_[edge.a], points_[edge.b], points_[p]);
      if (turn == 0) return kNoIndex;
      count += static_cast<std::uint32_t>(turn < 0);
    }
    return count;
  }

  void find_left_of(Index a, const Spoke& ab, std::vector<Triangle>& triangles) const {
    const std::span<const Spoke> star = spokes_[a];
    for (const Spoke& bc : spokes_[ab.to]) {
      const std::uint32_t place = place_of_[bc.to];
      if (!bc.leaves || bc.to < a || place == kNoIndex || !star[place].arrives) continue;
      const std::uint32_t under_ac = star[place].under;
      // b is under ac, or c is above ab.
      const bool is_empty = ab.to < bc.to ? under_ac == ab.under + bc.under + 1 : under_ac + bc.under == ab.under;
      if (is_empty && orientation(points_[a], points_[ab.to], points_[bc.to]) > 0) {
        triangles.push_back({a, ab.to, bc.to});
      }
    }
  }

  Points points_;
  Rows<Spoke> spokes_;                   // by end
  std::vector<std::uint32_t> place_of_;  // in the star at hand, by its other end
};

}  // namespace

std::optional<std::vector<Triangle>> region_triangles(Points points, std::span<const Edge> sides, std::size_t limit,
                                                      const Deadline& deadline) {
  TriangleSearch search(points);
  if (!search.file_sides(sides, deadline)) return {};
  std::vector<Triangle> triangles;
  for (Index a = 0; a < points.size(); ++a) {
    search.find_from(a, triangles);
    if (triangles.size() > limit || has_passed(deadline)) return {};
  }
  return triangles;
}

}  // namespace mwt
