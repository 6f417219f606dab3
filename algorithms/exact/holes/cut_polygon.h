// A face with holes, cut open along candidates until its boundary is in one piece.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/interval_program.h"

namespace mwt {

/// What a halfedge v -> w is to the triangle on its left.
enum class SideKind : std::uint8_t {
  outside,   ///< of the region: there is no such triangle
  boundary,  ///< of the region
  cut,
  chord,    ///< a candidate that crosses no cut and has a finite value in the polygon's program
  crossing  ///< a candidate that crosses a cut, or whose part of the polygon cannot be triangulated without crossing
            ///< one
};

/// The polygon that a region becomes by cuts, and the lightest triangulation of the region that contains them all.
///
/// Vertices are positions in region.vertices. Certain edges of `graph` are the region's boundary and the cuts;
/// candidates that cross cuts are in it as well. The polygon's positions are those of `program`; its closing side is an
/// edge of the region's boundary.
struct CutPolygon {
  using Cell = IntervalProgram::Cell;

  std::vector<Point> points;
  CandidateGraph graph;             ///< of these points
  std::vector<Edge> cuts;           ///< a < b
  std::vector<std::uint32_t> twin;  ///< by halfedge
  std::vector<SideKind> kind;       ///< by halfedge
  std::vector<Cell> cell;           ///< by halfedge of chords, whichever direction
  std::vector<bool> is_lower;       ///< by halfedge of chords: from the lower position to the higher one
  IntervalProgram program;

  CutPolygon() : program({}) {}
};

/// The shortest candidates that join all boundary components of the region to one and do not cross each other, by
/// Kruskal's rule; ends by position in region.vertices, a < b. Fewer than components - 1 if there are no more.
[[nodiscard]] std::vector<Edge> shortest_cuts(Points points, const FaceRegion& region);

/// The polygon and its program, computed. Nothing if the deadline passes or candidates leave the face. The region's
/// candidates must not cross its boundary. Precondition: the cuts join all components, without a cycle or a crossing.
/// Time: that of the program and O(m log m) for m candidates.
[[nodiscard]] std::optional<CutPolygon> cut_open(Points points, const FaceRegion& region, std::vector<Edge> cuts,
                                                 const Deadline& deadline);

}  // namespace mwt
