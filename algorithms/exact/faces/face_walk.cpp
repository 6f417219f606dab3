#include "algorithms/exact/faces/face_walk.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "geometry/predicates.h"

namespace mwt {

bool leads_to(const CandidateGraph& graph, const Corner& corner, Index target) {
  for (std::uint32_t position = 0; position < corner.candidates; ++position) {
    if (candidate_of(graph, corner, position) == target) return true;
  }
  return false;
}

std::uint32_t FaceWalker::halfedge_between(Index vertex, Index neighbour) const {
  const auto star = graph_.star(vertex);
  const auto place = std::find(star.begin(), star.end(), neighbour);
  if (place == star.end()) throw std::logic_error("candidate graph: an edge is in the star of one of its ends only");
  return graph_.first[vertex] + static_cast<std::uint32_t>(place - star.begin());
}

// The next corner of a walk that arrives at `to`: clockwise from the edge it came by to the next certain one.
Corner FaceWalker::corner_after(Index from, Index to) const {
  const std::uint32_t begin = graph_.first[to];
  const std::uint32_t end = graph_.first[to + 1];
  std::uint32_t h = halfedge_between(to, from);
  std::uint32_t passed = 0;
  for (;; ++passed) {
    h = (h == begin ? end : h) - 1;
    if (graph_.certain[h] != 0) return {to, h, passed};
  }
}

WalkEnd FaceWalker::walk(Index from, std::uint32_t start, std::size_t limit, Walk& corners) const {
  corners.clear();
  Corner last{from, start, 0};
  do {
    const Index to = graph_.target[last.halfedge];
    if (to < from) return WalkEnd::no_owner;
    last = corner_after(last.vertex, to);
    if (last.halfedge < start) return WalkEnd::no_owner;
    if (corners.size() == limit) return WalkEnd::too_long;
    corners.push_back(last);
  } while (last.halfedge != start);
  return WalkEnd::closed;
}

Walk FaceWalker::corners_of_face(Index from, std::uint32_t start) const {
  Walk corners;
  Corner last{from, start, 0};
  do {
    last = corner_after(last.vertex, graph_.target[last.halfedge]);
    corners.push_back(last);
  } while (last.halfedge != start);
  return corners;
}

Corner FaceWalker::corner_towards(Index vertex, Index neighbour) const {
  const std::uint32_t begin = graph_.first[vertex];
  const std::uint32_t end = graph_.first[vertex + 1];
  std::uint32_t h = halfedge_between(vertex, neighbour);
  while (graph_.certain[h] == 0) h = (h == begin ? end : h) - 1;
  return {vertex, h, 0};
}

// At the lexicographically smallest point, which is a strict corner of the hull, the outer face fills the one sector
// of more than 180 degrees.
Corner FaceWalker::some_corner_of_outer_face() const {
  const Points points = graph_.points;
  const auto smallest = std::min_element(points.begin(), points.end(), lexicographically_less);
  const auto v = static_cast<Index>(smallest - points.begin());
  std::vector<std::uint32_t> certain;
  for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + 1]; ++h) {
    if (graph_.certain[h] != 0) certain.push_back(h);
  }
  for (std::size_t i = 0; i < certain.size(); ++i) {
    const std::uint32_t next = certain[(i + 1) % certain.size()];
    const int turn = orientation(points[v], points[graph_.target[certain[i]]], points[graph_.target[next]]);
    if (turn < 0) return {v, certain[i], 0};
  }
  throw std::logic_error("candidate graph: a hull edge is not certain");
}

std::size_t FaceWalker::outer_face_size() const {
  const Corner start = some_corner_of_outer_face();
  return corners_of_face(start.vertex, start.halfedge).size();
}

std::uint32_t FaceWalker::owner_of_outer_face() const {
  const Corner start = some_corner_of_outer_face();
  std::uint32_t owner = start.halfedge;
  for (const Corner& corner : corners_of_face(start.vertex, start.halfedge)) owner = std::min(owner, corner.halfedge);
  return owner;
}

}  // namespace mwt
