#include "algorithms/exact/faces/cut_region.h"

#include <algorithm>
#include <utility>

#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/face_walk.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

bool lies_below_or_left(const Point& p, const Point& q) { return p.y < q.y || (p.y == q.y && p.x < q.x); }

}  // namespace

CutRegion::CutRegion(Points points, const FaceRegion& region) : region_(region) {
  for (const Index vertex : region.vertices) points_.push_back(points[vertex]);
  for (const Edge& edge : region.boundary) boundary_.push_back({region_.place_of(edge.a), region_.place_of(edge.b)});
  boundary_ = undirected_edges(std::move(boundary_));
  for (const Edge& edge : region.candidates)
    candidates_.push_back({region_.place_of(edge.a), region_.place_of(edge.b)});
  DisjointSets components(points_.size());
  for (const Edge& edge : boundary_) components.unite(edge.a, edge.b);
  for (Index v = 0; v < points_.size(); ++v) component_.push_back(static_cast<Index>(components.find(v)));
}

std::vector<Edge> CutRegion::unavoidable_cuts() const {
  const auto first = std::min_element(points_.begin(), points_.end(), lexicographically_less);
  const Index outer = component_[static_cast<std::size_t>(first - points_.begin())];
  std::vector<Index> inner;
  for (Index v = 0; v < points_.size(); ++v) {
    if (component_[v] != outer) inner.push_back(v);
  }
  std::optional<std::vector<Edge>> fewest;
  for (const auto is_before : {lexicographically_less, lies_below_or_left}) {
    const auto by_order = [&](Index a, Index b) { return is_before(points_[a], points_[b]); };
    const auto [least, most] = std::minmax_element(inner.begin(), inner.end(), by_order);
    for (const bool later : {false, true}) {
      const Index u = later ? *most : *least;
      std::vector<Edge> cuts;
      for (const Edge& edge : candidates_) {
        if (edge.a != u && edge.b != u) continue;
        const Index v = edge.a == u ? edge.b : edge.a;
        if (later ? by_order(u, v) : by_order(v, u))
          cuts.push_back({region_.vertices[edge.a], region_.vertices[edge.b]});
      }
      if (!fewest || cuts.size() < fewest->size()) fewest = std::move(cuts);
    }
  }
  return *fewest;
}

// Certain: boundary and cuts. Without the candidates that cross a cut.
CandidateGraph CutRegion::graph_with(std::span<const Edge> cuts) const {
  std::vector<Edge> certain = boundary_;
  for (const Edge& cut : cuts) certain.push_back({region_.place_of(cut.a), region_.place_of(cut.b)});
  std::sort(certain.begin(), certain.end());
  std::vector<Edge> edges = certain;
  for (const Edge& edge : candidates_) {
    const bool is_free = std::none_of(cuts.begin(), cuts.end(), [&](const Edge& cut) {
      const Edge c{region_.place_of(cut.a), region_.place_of(cut.b)};
      return c == edge || segments_cross(points_[edge.a], points_[edge.b], points_[c.a], points_[c.b]);
    });
    if (is_free) edges.push_back(edge);
  }
  return make_candidate_graph(points_, edges, certain);
}

PolygonFaceOutcome CutRegion::solve(std::span<const Edge> cuts, const Deadline& deadline, FaceTriangles& result) {
  const CandidateGraph graph = graph_with(cuts);
  const FaceWalker walker(graph);
  const Index from = region_.place_of(cuts.front().a), to = region_.place_of(cuts.front().b);
  const std::vector<Corner> corners = walker.corners_of_face(from, walker.corner_towards(from, to).halfedge);
  PolygonFaceSolver solver(graph);
  FaceTriangles found;
  const PolygonFaceOutcome outcome = solver.solve(corners, deadline, found);
  if (outcome != PolygonFaceOutcome::solved) return outcome;
  for (const auto& [a, b, c] : found.triangles) {
    result.triangles.push_back({region_.vertices[a], region_.vertices[b], region_.vertices[c]});
  }
  for (const Edge& cut : cuts) found.diagonals.add(points_[region_.place_of(cut.a)], points_[region_.place_of(cut.b)]);
  result.diagonals.add(found.diagonals);
  return outcome;
}

}  // namespace mwt
