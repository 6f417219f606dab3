#include "algorithms/exact/bounds/star_bound.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <vector>

#include "algorithms/exact/bounds/balanced_bound.h"
#include "algorithms/exact/division/beta_skeleton.h"
#include "geometry/numbers/interval.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

double bound_by_stars(Points points, const HullEdges& hull, const StarTable& table, const Deadline& deadline) {
  constexpr std::size_t kMaxCandidates = std::size_t{1} << 23;
  FaceRegion region;
  region.vertices.resize(points.size());
  std::iota(region.vertices.begin(), region.vertices.end(), Index{0});
  for (const Edge& edge : beta_skeleton(points))
    region.boundary.insert(region.boundary.end(), {edge, {edge.b, edge.a}});
  for (Index v = 0; v < points.size(); ++v) {
    if (hull.next[v] != kNoIndex) region.boundary.push_back({v, hull.next[v]});
  }
  const std::vector<Edge> certain = undirected_edges(region.boundary);
  LengthSum sum;
  for (const Edge& edge : certain) sum.add(points[edge.a], points[edge.b]);
  std::size_t halfedges = 0;
  for (const Star& star : table.stars) halfedges += star.count;
  if (halfedges > 2 * kMaxCandidates) return sum.enclosure().lower;
  std::vector<Edge> candidates;
  for (Index v = 0; v < points.size(); ++v) {
    for (const Index w : table.stars[v].targets()) {
      if (v < w) candidates.push_back({v, w});
    }
  }
  std::sort(candidates.begin(), candidates.end());
  std::set_difference(candidates.begin(), candidates.end(), certain.begin(), certain.end(),
                      std::back_inserter(region.candidates));
  return std::max(0.0, next_down(sum.enclosure().lower + balanced_bound(points, region, deadline)));
}

}  // namespace mwt
