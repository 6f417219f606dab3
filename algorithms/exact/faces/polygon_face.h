// Minimum weight triangulation of a face whose boundary is in one piece: interval dynamic program over candidates.
//
// The corners of such a face, in the order of the walk, are the positions 0 .. L-1 of a weakly simple polygon. A
// candidate joins two definite corners, and because the boundary is connected, three candidates or boundary edges
// between three positions bound an empty triangle; so the program over intervals of positions (P. D. Gilbert 1979, G.
// T. Klincsek 1980), restricted to candidates, is exact, with slits and repeated vertices as well.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/interval_program.h"
#include "geometry/weight.h"

namespace mwt {

/// Triangles and the total length of those of their sides that are no boundary edges.
struct FaceTriangles {
  std::vector<Triangle> triangles;
  LengthSum diagonals;
};

using PolygonFaceCounters = IntervalProgram::Counters;

enum class PolygonFaceOutcome {
  solved,
  not_a_polygon,     ///< candidates lead to other components (holes, isolated vertices) or cross the boundary
  no_triangulation,  ///< by candidates
  out_of_time,
};

/// Solves faces one after the other in the same memory. Not for concurrent use: one object per thread.
///
/// Exact, deterministic, time and space as IntervalProgram.
class PolygonFaceSolver {
 public:
  explicit PolygonFaceSolver(const CandidateGraph& graph) : graph_(graph), program_(graph.points) {}

  /// Adds the face's optimal triangulation to `result`, unless the outcome is another than `solved`.
  /// Precondition: at least 3 corners.
  PolygonFaceOutcome solve(std::span<const Corner> corners, const Deadline& deadline, FaceTriangles& result);

  [[nodiscard]] const PolygonFaceCounters& counters() const { return program_.counters(); }

 private:
  using Position = IntervalProgram::Position;

  [[nodiscard]] bool collect_cells();
  void collect_positions_of_vertices();
  [[nodiscard]] bool leads_back(Position position, Index partner);
  [[nodiscard]] Position find_position(Index vertex, Position after, Index partner);
  [[nodiscard]] bool emit(FaceTriangles& result);
  [[nodiscard]] bool turns_left(const Triangle& triangle) const;

  const CandidateGraph& graph_;
  IntervalProgram program_;

  std::span<const Corner> corners_;
  std::vector<std::pair<Index, Position>> positions_;  // of the vertices, sorted
  std::vector<std::uint32_t> passed_;                  // by position: its candidates up to the last one found
  std::vector<Edge> diagonals_;
};

}  // namespace mwt
