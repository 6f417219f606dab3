#include "algorithms/exact/faces/polygon_face.h"

#include <algorithm>
#include <limits>

#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::uint32_t kNoPosition = std::numeric_limits<std::uint32_t>::max();

}  // namespace

PolygonFaceOutcome PolygonFaceSolver::solve(std::span<const Corner> corners, const Deadline& deadline,
                                            FaceTriangles& result) {
  corners_ = corners;
  if (!collect_cells()) return PolygonFaceOutcome::not_a_polygon;
  if (!program_.compute(/*is_closed=*/true, deadline)) return PolygonFaceOutcome::out_of_time;
  if (!program_.is_feasible(program_.closing_cell())) return PolygonFaceOutcome::no_triangulation;
  return emit(result) ? PolygonFaceOutcome::solved : PolygonFaceOutcome::not_a_polygon;
}

bool PolygonFaceSolver::turns_left(const Triangle& triangle) const {
  return orientation(graph_.points[triangle[0]], graph_.points[triangle[1]], graph_.points[triangle[2]]) > 0;
}

// Counter-clockwise around a corner its candidates end at ascending positions, those behind the corner's own last. If
// every candidate is found from its first end, the candidates' halfedges in all corners are twice as many.
bool PolygonFaceSolver::collect_cells() {
  const auto size = static_cast<Position>(corners_.size());
  collect_positions_of_vertices();
  passed_.assign(size, 0);
  program_.clear();
  std::uint64_t halfedges = 0;
  std::uint64_t diagonals = 0;
  for (Position from = 0; from < size; ++from) {
    const Corner& corner = corners_[from];
    program_.add_position(corner.vertex);
    Position last = from + 1;
    if (last < size) program_.add_cell(last);
    halfedges += corner.candidates;
    for (std::uint32_t i = 0; i < corner.candidates; ++i) {
      last = find_position(candidate_of(graph_, corner, i), last, corner.vertex);
      if (last == kNoPosition) break;
      program_.add_cell(last);
      ++diagonals;
    }
    if (from == 0) program_.add_cell(size - 1);
  }
  return size >= 4 && halfedges == 2 * diagonals;
}

void PolygonFaceSolver::collect_positions_of_vertices() {
  positions_.clear();
  for (Position p = 0; p < corners_.size(); ++p) positions_.emplace_back(corners_[p].vertex, p);
  std::sort(positions_.begin(), positions_.end());
}

// Callers visit candidates in corner order, so the search continues where it found the last one.
bool PolygonFaceSolver::leads_back(Position position, Index partner) {
  const Corner& corner = corners_[position];
  std::uint32_t& passed = passed_[position];
  for (std::uint32_t i = passed; i < corner.candidates; ++i) {
    if (candidate_of(graph_, corner, i) != partner) continue;
    passed = i + 1;
    return true;
  }
  return leads_to(graph_, corner, partner);
}

// The corner of `vertex` behind position `after` that the edge from `partner` reaches.
PolygonFaceSolver::Position PolygonFaceSolver::find_position(Index vertex, Position after, Index partner) {
  const auto first_behind = std::pair(vertex, after + 1);
  for (auto it = std::lower_bound(positions_.begin(), positions_.end(), first_behind);
       it != positions_.end() && it->first == vertex; ++it) {
    if (leads_back(it->second, partner)) return it->second;
  }
  return kNoPosition;
}

// Where a candidate crosses the face's boundary, the program's triangles may overlap or lie outside, but then some of
// them do not turn left: those that all do cover the face once (see polygon_dp.h).
bool PolygonFaceSolver::emit(FaceTriangles& result) {
  const std::size_t before = result.triangles.size();
  diagonals_.clear();
  const bool all_turn_left =
      program_.visit_triangles(0, program_.closing_cell(), [&](const Triangle& triangle, bool is_diagonal) {
        result.triangles.push_back(triangle);
        if (is_diagonal) diagonals_.push_back({triangle[0], triangle[2]});
        return turns_left(triangle);
      });
  if (!all_turn_left) {
    result.triangles.resize(before);
    return false;
  }
  for (const Edge& diagonal : diagonals_) result.diagonals.add(graph_.points[diagonal.a], graph_.points[diagonal.b]);
  return true;
}

}  // namespace mwt
