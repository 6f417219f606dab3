#include "algorithms/exact/holes/certain_sides.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/common/rows.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

// Counts for each halfedge the triangles' angles that contain it, borders excluded.
class StraddleCount {
 public:
  explicit StraddleCount(const CandidateGraph& graph)
      : graph_(graph), place_(graph.points.size()), count_(graph.target.size(), 0) {}

  std::vector<std::uint32_t> run(std::span<const Triangle> triangles) {
    const Rows<Edge> angles = angles_at_corners(triangles);
    for (Index v = 0; v < graph_.points.size(); ++v) {
      const auto star = graph_.star(v);
      for (std::uint32_t i = 0; i < star.size(); ++i) place_[star[i]] = i;
      for (const Edge& angle : angles[v]) count_inside(v, angle);
    }
    return std::move(count_);
  }

 private:
  // At a corner: from the edge to a counter-clockwise to the edge to b.
  [[nodiscard]] Rows<Edge> angles_at_corners(std::span<const Triangle> triangles) const {
    return file_in_rows<Edge>(graph_.points.size(), [&](const auto& file) {
      for (const Triangle& triangle : triangles) {
        for (int i = 0; i < 3; ++i) file(triangle[static_cast<std::size_t>(i)], directed_edge(triangle, i));
      }
    });
  }

  void count_inside(Index v, const Edge& angle) {
    const auto degree = static_cast<std::uint32_t>(graph_.star(v).size());
    const std::uint32_t end = place_[angle.b];
    for (std::uint32_t i = (place_[angle.a] + 1) % degree; i != end; i = (i + 1) % degree)
      ++count_[graph_.first[v] + i];
  }

  const CandidateGraph& graph_;
  std::vector<std::uint32_t> place_;  // in the star at hand, by the other end
  std::vector<std::uint32_t> count_;
};

}  // namespace

CandidateGraph graph_of_sides(Points points, std::span<const Triangle> triangles, std::span<const Edge> boundary) {
  std::vector<Edge> certain(boundary.begin(), boundary.end());
  std::vector<Edge> sides = certain;
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) sides.push_back(directed_edge(triangle, i));
  }
  CandidateGraph graph = make_candidate_graph(points, undirected_edges(std::move(sides)), {});
  const std::vector<std::uint32_t> straddles = StraddleCount(graph).run(triangles);
  for (Index v = 0; v < points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
      if (straddles[h] == 0) certain.push_back({v, graph.target[h]});
    }
  }
  certain = undirected_edges(std::move(certain));
  for (Index v = 0; v < points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
      const bool is_certain = std::binary_search(certain.begin(), certain.end(), make_edge(v, graph.target[h]));
      graph.certain[h] = is_certain ? 1 : 0;
    }
  }
  return graph;
}

}  // namespace mwt
