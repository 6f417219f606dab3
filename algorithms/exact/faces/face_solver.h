// The last stage of the exact solver: triangulates each face of the certain edges optimally with the candidates left.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/exact/candidates/candidate_graph.h"
#include "geometry/numbers/interval.h"
#include "geometry/triangulation.h"

namespace mwt {

struct FaceSolution {
  std::vector<Triangle> triangles;  ///< of all faces, in the graph's indices; a complete triangulation
  Interval optimum;                 ///< certified bounds on the weight of a minimum weight triangulation of the points
  bool proved = false;              ///< every face solved and relative width of `optimum` at most kProvedRelativeWidth

  std::uint64_t faces = 0;                ///< that are no triangles
  std::uint64_t max_face = 0;             ///< edges on the longest boundary walk, both sides of slits counted
  std::uint64_t dp_cells = 0;             ///< intervals whose optimum was computed
  std::uint64_t precise_comparisons = 0;  ///< comparisons of sums of roots that doubles could not decide
  std::uint64_t undecided_ties = 0;       ///< of these, sums that no available precision could compare
  std::uint64_t faces_with_holes = 0;     ///< or isolated vertices
  std::uint64_t reductions = 0;           ///< faces with holes, or parts of them, cut open and bounded
  std::uint64_t programs = 0;
  std::uint64_t branchings = 0;
  std::uint64_t unsolved_faces = 0;       ///< cut short by a limit; each contributes its own lower bound
  std::optional<StopReason> stop_reason;  ///< of these faces
};

/// Faces of one boundary component: interval dynamic program over candidates (polygon_face.h). With holes or isolated
/// vertices: holes/region_solver.h.
///
/// Precondition: the graph's properties (1) to (4); where a violation shows, std::logic_error. SearchStopped with a
/// lower bound, if the deadline passes before the faces are known.
/// Ties: equality of two triangulations of a face is decided exactly, and of equal ones always the same is kept. Uses
/// context.threads, but no more than there are cores; the triangles, their order and the bounds do not depend on it.
/// Failure mode: polygons of more than 32 edges and faces with holes that context.deadline leaves over are filled with
/// a constrained Delaunay triangulation, or the best one found, and contribute the bound reached: the result is valid,
/// `optimum` certified and wider, `proved` false. Until `bounds_deadline` these bounds are improved. Time for faces of
/// bounded size O(n), about a third of a Delaunay triangulation on two cores; an L-gon with all its diagonals takes
/// O(L^3). Space O(n + candidates).
[[nodiscard]] FaceSolution solve_faces(CandidateGraph graph, Context& context, const Deadline& bounds_deadline = {});

}  // namespace mwt
