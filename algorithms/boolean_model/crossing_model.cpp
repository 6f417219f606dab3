#include "algorithms/boolean_model/crossing_model.h"

#include <algorithm>

#include "geometry/convex_hull.h"
#include "geometry/predicates.h"

namespace mwt {

CrossingModel::CrossingModel(Points points) : size(3 * points.size() - 3 - convex_hull(points).size()) {
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) {
      const bool is_free = std::none_of(points.begin(), points.end(),
                                        [&](const Point& p) { return in_segment_interior(p, points[a], points[b]); });
      if (is_free) edges.push_back({a, b});
    }
  }
  crossing.resize(edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (std::uint32_t f = 0; f < edges.size(); ++f) {
      const auto& [a, b] = edges[e];
      const auto& [c, d] = edges[f];
      if (e != f && segments_cross(points[a], points[b], points[c], points[d])) crossing[e].push_back(f);
    }
  }
}

bool CrossingModel::cross(std::uint32_t e, std::uint32_t f) const {
  return std::binary_search(crossing[e].begin(), crossing[e].end(), f);
}

}  // namespace mwt
