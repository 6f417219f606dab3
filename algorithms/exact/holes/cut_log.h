// Where faces with holes are cut open, for pages that play the solver.
#pragma once

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/holes/cut_polygon.h"

namespace mwt {

/// By coordinates, as parts of faces number their points in their own way. Thread-safe.
class CutLog {
 public:
  /// The shortest cuts of a region.
  void note(Points points, const FaceRegion& region) {
    const std::vector<Edge> cuts = shortest_cuts(points, region);
    const std::lock_guard lock(mutex_);
    for (const Edge& cut : cuts) cuts_.emplace_back(points[region.vertices[cut.a]], points[region.vertices[cut.b]]);
  }

  /// All of them, each once, by positions among these points, which are distinct and hold them all.
  [[nodiscard]] std::vector<Edge> among(Points points) const {
    const std::vector<Index> order = lexicographic_order(points);
    const auto position = [&](const Point& p) {
      return *std::lower_bound(order.begin(), order.end(), p,
                               [&](Index i, const Point& q) { return lexicographically_less(points[i], q); });
    };
    std::vector<Edge> edges;
    for (const auto& [a, b] : cuts_) edges.push_back(make_edge(position(a), position(b)));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

 private:
  std::mutex mutex_;
  std::vector<std::pair<Point, Point>> cuts_;
};

}  // namespace mwt
