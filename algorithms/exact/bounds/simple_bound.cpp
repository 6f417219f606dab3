#include "algorithms/exact/bounds/simple_bound.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/weight.h"

namespace mwt {

double simple_lower_bound(Points points) {
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::infinity());
  for (const auto& [a, b] : edges_of(delaunay_triangulation(points))) {
    const double shortest = enclose(length(points[a], points[b]), 8 * kDoubleDoubleError).lower;
    nearest[a] = std::min(nearest[a], shortest);
    nearest[b] = std::min(nearest[b], shortest);
  }
  std::vector<double> half_edges(points.size(), 1.5);
  for (const Index p : convex_hull(points)) half_edges[p] = 1;
  double bound = 0;
  for (std::size_t p = 0; p < points.size(); ++p)
    bound = std::max(0.0, next_down(bound + next_down(half_edges[p] * nearest[p])));
  return bound;
}

}  // namespace mwt
