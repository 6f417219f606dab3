#include "algorithms/exact/holes/side_bound.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <vector>

#include "geometry/numbers/double_double.h"
#include "geometry/numbers/interval.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

// All vertices by their position in the region's list.
class SideBound {
 public:
  SideBound(Points points, const FaceRegion& region) {
    for (const Index vertex : region.vertices) points_.push_back(points[vertex]);
    const auto in_places = [&](const Edge& edge) { return Edge{region.place_of(edge.a), region.place_of(edge.b)}; };
    for (const Edge& edge : region.boundary) boundary_.push_back(in_places(edge));
    std::sort(boundary_.begin(), boundary_.end());
    std::vector<Edge> edges = undirected_edges(boundary_);
    for (const Edge& edge : region.candidates) edges.push_back(in_places(edge));
    file_neighbours(edges);
  }

  [[nodiscard]] double run() const {
    double bound = 0;
    for (const Edge& side : boundary_) {
      const double least = min_share(side);
      if (least < std::numeric_limits<double>::infinity()) bound = next_down(bound + least);
    }
    return std::max(0.0, bound);
  }

 private:
  void file_neighbours(const std::vector<Edge>& edges) {
    first_.assign(points_.size() + 1, 0);
    for (const Edge& edge : edges) {
      ++first_[edge.a + std::size_t{1}];
      ++first_[edge.b + std::size_t{1}];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    neighbour_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const Edge& edge : edges) {
      neighbour_[next[edge.a]++] = edge.b;
      neighbour_[next[edge.b]++] = edge.a;
    }
    for (std::size_t v = 0; v < points_.size(); ++v) {
      std::sort(neighbour_.begin() + static_cast<std::ptrdiff_t>(first_[v]),
                neighbour_.begin() + static_cast<std::ptrdiff_t>(first_[v + 1]));
    }
  }

  [[nodiscard]] std::span<const Index> neighbours(Index v) const {
    return std::span(neighbour_).subspan(first_[v], first_[v + std::size_t{1}] - first_[v]);
  }

  [[nodiscard]] bool is_boundary(const Edge& directed) const {
    return std::binary_search(boundary_.begin(), boundary_.end(), directed);
  }

  // Of w(t) / k(t) over the triangles left of the side; infinite if there is none.
  [[nodiscard]] double min_share(const Edge& side) const {
    double least = std::numeric_limits<double>::infinity();
    const auto a = neighbours(side.a), b = neighbours(side.b);
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      if (a[i] == b[j]) {
        if (orientation(points_[side.a], points_[side.b], points_[a[i]]) > 0) {
          least = std::min(least, share(side, a[i]));
        }
        ++i;
        ++j;
      } else {
        ++(a[i] < b[j] ? i : j);
      }
    }
    return least;
  }

  [[nodiscard]] double share(const Edge& side, Index apex) const {
    double diagonals = 0;
    int boundary_sides = 1;
    for (const Edge& other : {Edge{side.b, apex}, Edge{apex, side.a}}) {
      if (is_boundary(other)) {
        ++boundary_sides;
      } else {
        diagonals += length(points_[other.a], points_[other.b]).high;
      }
    }
    const bool is_whole = boundary_sides == 3 && points_.size() > 3;
    if (is_whole) return std::numeric_limits<double>::infinity();  // there are other vertices in it
    // Two rounded lengths, their sum and a quotient.
    return std::max(0.0, next_down(diagonals / (2 * boundary_sides) * (1 - 0x1p-50)));
  }

  std::vector<Point> points_;
  std::vector<Edge> boundary_;  // directed, ascending
  std::vector<std::size_t> first_;
  std::vector<Index> neighbour_;
};

}  // namespace

double bound_by_sides(Points points, const FaceRegion& region) { return SideBound(points, region).run(); }

}  // namespace mwt
