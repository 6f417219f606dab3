#include "algorithms/exact/bounds/side_bound.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/common/rows.h"
#include "geometry/numbers/double_double.h"
#include "geometry/numbers/interval.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

// All vertices by their position in the region's list.
class SideBound {
 public:
  SideBound(Points points, const FaceRegion& region)
      : points_(region.points_among(points)), boundary_(region.in_places(region.boundary)) {
    std::sort(boundary_.begin(), boundary_.end());
    std::vector<Edge> edges = region.in_places(region.candidates);
    for (const Edge& edge : undirected_edges(boundary_)) edges.push_back(edge);
    neighbours_ = file_in_rows<Index>(points_.size(), [&](const auto& file) {
      for (const Edge& edge : edges) {
        file(edge.a, edge.b);
        file(edge.b, edge.a);
      }
    });
    for (std::size_t v = 0; v < points_.size(); ++v) std::sort(neighbours_[v].begin(), neighbours_[v].end());
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
  [[nodiscard]] bool is_boundary(const Edge& directed) const {
    return std::binary_search(boundary_.begin(), boundary_.end(), directed);
  }

  // Of w(t) / k(t) over the triangles left of the side; infinite if there is none.
  [[nodiscard]] double min_share(const Edge& side) const {
    double least = std::numeric_limits<double>::infinity();
    const std::span<const Index> a = neighbours_[side.a], b = neighbours_[side.b];
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
  Rows<Index> neighbours_;      // of each point, ascending
};

}  // namespace

double bound_by_sides(Points points, const FaceRegion& region) { return SideBound(points, region).run(); }

}  // namespace mwt
