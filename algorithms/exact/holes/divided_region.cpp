#include "algorithms/exact/holes/divided_region.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/polygon_face.h"

namespace mwt {

namespace {

class DividedRegion {
 public:
  DividedRegion(CandidateGraph graph, std::span<const Edge> boundary, const RegionSearch& search)
      : boundary_(boundary.begin(), boundary.end()), search_(search), graph_(std::move(graph)), polygons_(graph_) {
    std::sort(boundary_.begin(), boundary_.end());
    result_.solved = true;
  }

  std::optional<RegionSolution> solve() {
    if (!collect_dividing_edges() || !remove_crossing_candidates()) return {};
    solve_faces();
    if (is_feasible_) solve_composite_faces();
    if (!is_feasible_) return RegionSolution::infeasible();
    if (is_too_heavy_) result_.triangles.clear();
    result_.diagonals.add(exact_);
    result_.lower_bound = next_down(result_.lower_bound + exact_.enclosure().lower);
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool on_boundary(const Edge& directed) const {
    return std::binary_search(boundary_.begin(), boundary_.end(), directed);
  }

  // Left of the halfedge: left of the boundary or on both sides of every other edge.
  [[nodiscard]] bool is_inside(const Edge& directed) const {
    return on_boundary(directed) || !on_boundary({directed.b, directed.a});
  }

  template <class Visit>  // visit(v, halfedge)
  void for_each_halfedge(Visit visit) const {
    for (Index v = 0; v < graph_.points.size(); ++v) {
      for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + std::size_t{1}]; ++h) visit(v, h);
    }
  }

  // Whether there are any. They are diagonals of the solution.
  bool collect_dividing_edges() {
    bool divides = false;
    for_each_halfedge([&](Index v, std::uint32_t h) {
      const Edge edge{v, graph_.target[h]};
      const bool is_inner = !on_boundary(edge) && !on_boundary({edge.b, edge.a});
      if (graph_.certain[h] == 0 || edge.a > edge.b || !is_inner) return;
      exact_.add(graph_.points[edge.a], graph_.points[edge.b]);
      divides = true;
    });
    return divides;
  }

  // Whether the deadline allowed it. No triangulation in question contains them.
  bool remove_crossing_candidates() {
    const auto crossing = find_crossing_candidates(graph_, edges_marked(graph_, 0), search_.deadline);
    if (crossing) remove_edges(graph_, *crossing);
    return crossing.has_value();
  }

  void solve_faces() {
    const FaceWalker walker(graph_);
    std::vector<bool> has_certain_edge(graph_.points.size());
    std::vector<bool> is_walked(graph_.target.size());
    for_each_halfedge([&](Index v, std::uint32_t h) {
      if (graph_.certain[h] == 0) return;
      has_certain_edge[v] = true;
      if (is_walked[h] || !is_inside({v, graph_.target[h]})) return;
      const Walk walk = walker.corners_of_face(v, h);
      for (const Corner& corner : walk) is_walked[corner.halfedge] = true;
      solve_walk(walk);
    });
    for (Index v = 0; v < graph_.points.size(); ++v) {
      if (!has_certain_edge[v]) isolated_.push_back(v);
    }
  }

  void solve_walk(const Walk& walk) {
    if (is_triangle(walk)) {
      result_.triangles.push_back({walk[0].vertex, walk[1].vertex, walk[2].vertex});
      return;
    }
    FaceTriangles found;
    switch (polygons_.solve(walk, search_.deadline, found)) {
      case PolygonFaceOutcome::solved:
        exact_.add(found.diagonals);
        result_.triangles.insert(result_.triangles.end(), found.triangles.begin(), found.triangles.end());
        break;
      case PolygonFaceOutcome::not_a_polygon: composite_.push_back(walk); break;
      case PolygonFaceOutcome::out_of_time:
        add(leave_unsolved(graph_.points, make_region(graph_, {&walk}, {}), StopReason::deadline,
                           search_.bounds_deadline));
        break;
      case PolygonFaceOutcome::no_triangulation: is_feasible_ = false; break;
    }
  }

  void solve_composite_faces() {
    RegionSearch search = search_;
    search.limit = next_up(search_.limit - exact_.enclosure().lower);
    for (const FaceRegion& region : group_into_regions(graph_, FaceWalker(graph_), composite_, isolated_)) {
      const RegionSolution part = solve_region(graph_.points, region, search);
      is_feasible_ = is_feasible_ && part.is_feasible();
      if (!is_feasible_) return;
      add(part);
      is_too_heavy_ = is_too_heavy_ || part.triangles.empty();
    }
  }

  void add(const RegionSolution& part) {
    result_.triangles.insert(result_.triangles.end(), part.triangles.begin(), part.triangles.end());
    result_.diagonals.add(part.diagonals);
    result_.lower_bound = next_down(result_.lower_bound + part.lower_bound);
    result_.solved = result_.solved && part.solved;
    result_.stop_reason = combined(result_.stop_reason, part.stop_reason);
    result_.counters.add(part.counters);
  }

  std::vector<Edge> boundary_;  // sorted
  const RegionSearch& search_;
  CandidateGraph graph_;
  PolygonFaceSolver polygons_;
  LengthSum exact_;  // of the dividing edges and the polygons' diagonals
  std::vector<Walk> composite_;
  std::vector<Index> isolated_;
  bool is_feasible_ = true;
  bool is_too_heavy_ = false;  // a part has no triangulation below the limit
  RegionSolution result_;
};

}  // namespace

std::optional<RegionSolution> solve_divided_region(CandidateGraph graph, std::span<const Edge> boundary,
                                                   const RegionSearch& search) {
  return DividedRegion(std::move(graph), boundary, search).solve();
}

}  // namespace mwt
