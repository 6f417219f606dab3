#include "algorithms/boolean_model/crossing_model.h"

#include <algorithm>
#include <set>

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

// Three edges between three points bound a triangle of the triangulation unless a point lies among them.
Triangulation triangulation_of(Points points, const std::vector<Edge>& edges) {
  const std::set<Edge> present(edges.begin(), edges.end());
  Triangulation result{static_cast<Index>(points.size()), {}};
  for (const auto& [a, b] : edges) {
    for (Index c = b + 1; c < points.size(); ++c) {
      if (!present.contains({a, c}) || !present.contains({b, c})) continue;
      const bool turns_left = orientation(points[a], points[b], points[c]) > 0;
      const Triangle triangle = turns_left ? Triangle{a, b, c} : Triangle{a, c, b};
      bool is_empty = true;
      for (Index p = 0; p < points.size(); ++p) {
        const bool is_corner = p == a || p == b || p == c;
        is_empty = is_empty && (is_corner || !in_closed_triangle(points[p], points[triangle[0]], points[triangle[1]],
                                                                 points[triangle[2]]));
      }
      if (is_empty) result.triangles.push_back(triangle);
    }
  }
  return result;
}

}  // namespace mwt
