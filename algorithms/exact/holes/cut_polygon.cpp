#include "algorithms/exact/holes/cut_polygon.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/faces/length_sum_comparison.h"
#include "geometry/predicates.h"
#include "geometry/undirected_edges.h"

namespace mwt {

namespace {

using Cell = IntervalProgram::Cell;
using Position = IntervalProgram::Position;

class Cutter {
 public:
  Cutter(Points points, const FaceRegion& region, std::vector<Edge> cuts, const Deadline& deadline)
      : boundary_(region.in_places(region.boundary)), deadline_(deadline) {
    std::sort(boundary_.begin(), boundary_.end());
    std::sort(cuts.begin(), cuts.end());
    polygon_.points = region.points_among(points);
    polygon_.cuts = std::move(cuts);
    polygon_.program = IntervalProgram(polygon_.points);
    make_graph(region.in_places(region.candidates));
  }

  std::optional<CutPolygon> run() {
    if (!walk() || !classify() || !collect_cells()) return {};
    if (!polygon_.program.compute(/*is_closed=*/true, deadline_)) return {};
    mark_chords_without_value();
    return std::move(polygon_);
  }

 private:
  void make_graph(std::vector<Edge> candidates) {
    std::vector<Edge> certain = undirected_edges(boundary_);
    certain.insert(certain.end(), polygon_.cuts.begin(), polygon_.cuts.end());
    std::sort(certain.begin(), certain.end());
    candidates.insert(candidates.end(), certain.begin(), certain.end());
    polygon_.graph = make_candidate_graph(polygon_.points, undirected_edges(std::move(candidates)), certain);
    const std::size_t halfedges = polygon_.graph.target.size();
    polygon_.twin.assign(halfedges, kNoIndex);
    polygon_.kind.assign(halfedges, SideKind::crossing);
    polygon_.cell.assign(halfedges, IntervalProgram::kNoCell);
    polygon_.is_lower.assign(halfedges, false);
    pair_halfedges();
  }

  // Edges reach their larger ends in the order of their smaller ones.
  void pair_halfedges() {
    const CandidateGraph& graph = polygon_.graph;
    std::vector<std::uint32_t> next(graph.first.begin(), graph.first.end() - 1);
    std::vector<std::uint32_t> by_target(graph.target.size());  // rows as in the graph, sorted by target
    for (Index v = 0; v < graph.points.size(); ++v) {
      for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h)
        by_target[next[graph.target[h]]++] = h;
    }
    // Row w of by_target: the halfedges that lead to w, by ascending origin. Those from w, sorted by target, match
    // them.
    std::vector<std::uint32_t> own;
    for (Index w = 0; w < graph.points.size(); ++w) {
      own.clear();
      for (std::uint32_t h = graph.first[w]; h < graph.first[w + std::size_t{1}]; ++h) own.push_back(h);
      std::sort(own.begin(), own.end(),
                [&](std::uint32_t g, std::uint32_t h) { return graph.target[g] < graph.target[h]; });
      for (std::size_t i = 0; i < own.size(); ++i) polygon_.twin[own[i]] = by_target[graph.first[w] + i];
    }
  }

  // From an edge of the region's boundary, which becomes the closing side. Whether that is the whole boundary.
  bool walk() {
    const FaceWalker walker(polygon_.graph);
    corners_ = walker.corners_of_face(boundary_.front());
    position_.assign(polygon_.graph.target.size(), kNoIndex);
    for (Position i = 0; i < corners_.size(); ++i) {
      std::uint32_t h = corners_[i].halfedge;
      const Index v = corners_[i].vertex;
      for (std::uint32_t step = 0; step <= corners_[i].candidates; ++step) {
        position_[h] = i;
        h = h + 1 < polygon_.graph.first[v + std::size_t{1}] ? h + 1 : polygon_.graph.first[v];
      }
    }
    return corners_.size() == boundary_.size() + 2 * polygon_.cuts.size();
  }

  // All but the chords' values. Whether every candidate lies in the face.
  bool classify() {
    const CandidateGraph& graph = polygon_.graph;
    std::vector<Edge> suspects;
    for (Index v = 0; v < graph.points.size(); ++v) {
      for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
        const Edge edge{v, graph.target[h]};
        if (graph.certain[h] == 0) {
          if (position_[h] == kNoIndex) return false;
          if (edge.a < edge.b) suspects.push_back(edge);
          continue;
        }
        const bool is_cut = std::binary_search(polygon_.cuts.begin(), polygon_.cuts.end(), make_edge(edge.a, edge.b));
        const bool is_boundary = std::binary_search(boundary_.begin(), boundary_.end(), edge);
        polygon_.kind[h] = is_cut ? SideKind::cut : is_boundary ? SideKind::boundary : SideKind::outside;
      }
    }
    const CandidateGraph cuts = make_candidate_graph(graph.points, polygon_.cuts, polygon_.cuts);
    auto crossing = find_crossing_candidates(cuts, suspects, deadline_);
    if (!crossing) return false;
    std::sort(crossing->begin(), crossing->end());
    for (Index v = 0; v < graph.points.size(); ++v) {
      for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
        if (graph.certain[h] != 0) continue;
        const bool crosses = std::binary_search(crossing->begin(), crossing->end(), make_edge(v, graph.target[h]));
        if (!crosses) polygon_.kind[h] = SideKind::chord;
      }
    }
    return true;
  }

  // Counter-clockwise around a corner its chords end at ascending positions, those behind the corner's own last.
  bool collect_cells() {
    IntervalProgram& program = polygon_.program;
    const CandidateGraph& graph = polygon_.graph;
    const auto size = static_cast<Position>(corners_.size());
    std::vector<std::pair<Position, std::uint32_t>> row;  // end, halfedge
    program.clear();
    for (Position from = 0; from < size; ++from) {
      program.add_position(corners_[from].vertex);
      row.clear();
      std::uint32_t h = corners_[from].halfedge;
      for (std::uint32_t step = 0; step < corners_[from].candidates; ++step) {
        h = h + 1 < graph.first[corners_[from].vertex + std::size_t{1}] ? h + 1 : graph.first[corners_[from].vertex];
        const Position to = position_[polygon_.twin[h]];
        if (polygon_.kind[h] == SideKind::chord && to > from) row.emplace_back(to, h);
      }
      std::sort(row.begin(), row.end());
      if (from + 1 < size) program.add_cell(from + 1);
      for (const auto& [to, halfedge] : row) {
        if (to == from + 1 || (from == 0 && to + 1 == size)) return false;
        polygon_.cell[halfedge] = polygon_.cell[polygon_.twin[halfedge]] = program.cell_count();
        polygon_.is_lower[halfedge] = true;
        program.add_cell(to);
      }
      if (from == 0) program.add_cell(size - 1);
    }
    return size >= 4;
  }

  void mark_chords_without_value() {
    for (std::uint32_t h = 0; h < polygon_.kind.size(); ++h) {
      if (polygon_.kind[h] == SideKind::chord && !polygon_.program.is_feasible(polygon_.cell[h])) {
        polygon_.kind[h] = SideKind::crossing;
      }
    }
  }

  std::vector<Edge> boundary_;  // directed, sorted
  const Deadline& deadline_;
  CutPolygon polygon_;
  Walk corners_;
  std::vector<Position> position_;  // by halfedge
};

}  // namespace

std::vector<Edge> shortest_cuts(Points points, const FaceRegion& region) {
  const std::vector<Point> own = region.points_among(points);
  DisjointSets components(own.size());
  for (const Edge& edge : region.in_places(region.boundary)) components.unite(edge.a, edge.b);
  std::vector<Edge> joining;
  for (const Edge& edge : region.in_places(region.candidates)) {
    if (components.find(edge.a) != components.find(edge.b)) joining.push_back(edge);
  }
  std::stable_sort(joining.begin(), joining.end(),
                   [&](const Edge& e, const Edge& f) { return compare_edge_lengths(own, e, f) < 0; });
  std::vector<Edge> cuts;
  for (const Edge& edge : joining) {
    const bool is_free = components.find(edge.a) != components.find(edge.b) &&
                         std::none_of(cuts.begin(), cuts.end(), [&](const Edge& cut) {
                           return segments_cross(own[edge.a], own[edge.b], own[cut.a], own[cut.b]);
                         });
    if (!is_free) continue;
    components.unite(edge.a, edge.b);
    cuts.push_back(edge);
  }
  return cuts;
}

std::optional<CutPolygon> cut_open(Points points, const FaceRegion& region, std::vector<Edge> cuts,
                                   const Deadline& deadline) {
  return Cutter(points, region, std::move(cuts), deadline).run();
}

}  // namespace mwt
