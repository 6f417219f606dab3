#include "algorithms/exact/holes/consistent_triangles.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "algorithms/common/rows.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

class Consistency {
 public:
  Consistency(Points points, std::span<const Triangle> triangles, std::span<const Edge> boundary)
      : points_(points),
        triangles_(triangles),
        is_dropped_(triangles.size(), false),
        next_(3 * triangles.size()),
        end_(3 * triangles.size()),
        supported_(triangles.size(), kNone),
        next_supported_(3 * triangles.size(), kNone) {
    file_sides();
    match_sides(boundary);
  }

  std::vector<Triangle> run() {
    for (Side side = 0; side < next_.size(); ++side) find_support(side);
    while (!dropped_.empty()) {
      const std::uint32_t triangle = dropped_.back();
      dropped_.pop_back();
      for (Side side = supported_[triangle]; side != kNone;) {
        const Side following = next_supported_[side];
        find_support(side);
        side = following;
      }
    }
    std::vector<Triangle> remaining;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      if (!is_dropped_[t]) remaining.push_back(triangles_[t]);
    }
    return remaining;
  }

 private:
  using Side = std::uint32_t;                // 3 * triangle + opposite corner
  using FiledSide = std::pair<Index, Side>;  // with the second end of its directed edge
  static constexpr Side kNone = 0xFFFFFFFF;

  [[nodiscard]] Edge edge_of(Side side) const {
    return directed_edge(triangles_[side / 3], static_cast<int>(side % 3));
  }
  [[nodiscard]] const Point& apex_of(Side side) const { return points_[triangles_[side / 3][side % 3]]; }

  // All sides, sorted by their directed edge.
  void file_sides() {
    filed_ = file_in_rows<FiledSide>(points_.size(), [&](const auto& file) {
      for (Side side = 0; side < next_.size(); ++side) file(edge_of(side).a, {edge_of(side).b, side});
    });
    for (std::size_t v = 0; v < points_.size(); ++v) std::sort(filed_[v].begin(), filed_[v].end());
  }

  // The places of the sides that are this directed edge.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> places_of(const Edge& edge) const {
    const std::span<const FiledSide> row = std::as_const(filed_)[edge.a];
    const auto [from, to] =
        std::equal_range(row.begin(), row.end(), FiledSide{edge.b, 0},
                         [](const auto& one, const auto& other) { return one.first < other.first; });
    const std::uint32_t first = filed_.first[edge.a];
    return {first + static_cast<std::uint32_t>(from - row.begin()),
            first + static_cast<std::uint32_t>(to - row.begin())};
  }

  // For each side the range of sides on its other side; an empty range that starts at kNone on the boundary.
  void match_sides(std::span<const Edge> boundary) {
    std::vector<Edge> sorted_boundary(boundary.begin(), boundary.end());
    std::sort(sorted_boundary.begin(), sorted_boundary.end());
    const std::vector<FiledSide>& filed = filed_.values;
    for (std::size_t i = 0; i < filed.size();) {
      const Edge edge = edge_of(filed[i].second);
      const auto [from, to] = places_of({edge.b, edge.a});
      const bool is_boundary = std::binary_search(sorted_boundary.begin(), sorted_boundary.end(), edge);
      for (; i < filed.size() && edge_of(filed[i].second) == edge; ++i) {
        next_[filed[i].second] = is_boundary ? kNone : from;
        end_[filed[i].second] = to;
      }
    }
  }

  // Moves on to the first triangle across the side that remains and fits; what was passed over never comes back.
  void find_support(Side side) {
    if (next_[side] == kNone || is_dropped_[side / 3]) return;
    for (std::uint32_t& i = next_[side]; i < end_[side]; ++i) {
      const Side across = filed_.values[i].second;
      if (is_dropped_[across / 3] || !fit(side, across)) continue;
      next_supported_[side] = supported_[across / 3];
      supported_[across / 3] = side;
      return;
    }
    is_dropped_[side / 3] = true;
    dropped_.push_back(side / 3);
  }

  [[nodiscard]] bool fit(Side side, Side across) const {
    const Edge edge = edge_of(side);
    const Point& a = points_[edge.a];
    const Point& b = points_[edge.b];
    const Point& left = apex_of(side);
    const Point& right = apex_of(across);
    return compare_length(a, b, left, right) <= 0 || !is_strictly_convex(a, right, b, left);
  }

  Points points_;
  std::span<const Triangle> triangles_;
  std::vector<bool> is_dropped_;
  Rows<FiledSide> filed_;            // sides by the first end of their directed edge
  std::vector<std::uint32_t> next_;  // by side: place in filed_.values of its present support
  std::vector<std::uint32_t> end_;
  std::vector<Side> supported_;       // by triangle: head of the list of sides that it supports
  std::vector<Side> next_supported_;  // by side
  std::vector<std::uint32_t> dropped_;
};

}  // namespace

std::vector<Triangle> consistent_triangles(Points points, std::span<const Triangle> triangles,
                                           std::span<const Edge> boundary) {
  return Consistency(points, triangles, boundary).run();
}

}  // namespace mwt
