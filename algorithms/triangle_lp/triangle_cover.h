// The Dantzig-Hoffman-Hu model: a lightest set of triangles that covers a region exactly once, by linear programming.
//
// x_t in {0, 1} for each candidate triangle t. Every directed boundary edge is the side of exactly one chosen triangle;
// for every other edge, the chosen triangles on its left are as many as those on its right. The LP relaxation is solved
// with GLPK; a fractional optimum is branched on. A side costs half its length, on the boundary all of it (half again
// where the edge is part of the boundary in both directions), so that the objective is the sum of the lengths of the
// cover's edges, every edge once.
//
// G. B. Dantzig, A. J. Hoffman, T. C. Hu, "Triangulations (tilings) and certain block triangular matrices",
// Mathematical Programming 31 (1985).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/stop_reason.h"
#include "geometry/numbers/interval.h"
#include "geometry/triangulation.h"

namespace mwt {

/// A region to cover: connected, possibly with holes, slits and isolated points. Its boundary is given as directed
/// edges with the region on their left; an edge inside the region that must be part of the cover is given in both
/// directions.
struct TriangleCoverProblem {
  Points points;
  std::span<const Triangle> triangles;  ///< candidates, counter-clockwise, empty of points
  std::span<const Edge> boundary;       ///< directed a -> b (not ordered a < b)
  std::size_t triangle_count = 0;       ///< how many triangles every exact cover has
  Deadline deadline{};
  /// A cover by candidates (with the same order of corners), if one is known: it saves time.
  std::span<const Triangle> start{};
};

struct TriangleCover {
  std::vector<Triangle> triangles;  ///< the best cover found; empty if none was
  /// Certified bounds on the weight of the lightest cover by candidates, every edge once; infinite above without a
  /// cover.
  Interval optimum;
  bool proved = false;  ///< relative width of `optimum` at most kProvedRelativeWidth
  /// Why a cover was not proved lightest: the deadline, or rounding in the linear programs.
  std::optional<StopReason> stop_reason;
  std::uint64_t programs = 0;    ///< linear programs solved
  std::uint64_t branchings = 0;  ///< fractional optima that had to be branched on
};

/// Exact up to the stated interval, whatever GLPK's rounding: the lower end comes from dual values evaluated with
/// error bounds over all candidates, the upper end is the certified weight of `triangles`. Never throws for numerical
/// trouble: then the interval is wide. Deterministic, except for the deadline. Each thread may call it at the same time
/// as others.
///
/// Preconditions: candidates are counter-clockwise and closed triangles without further points; `triangle_count` is
/// right. Candidates outside the region do no harm. Without any cover by candidates the result has no triangles.
///
/// Dual values are balanced first (cover_balance.h), columns that no lighter cover can have are dropped, and the rest
/// is column generation (cover_program.h) and depth-first branching. Time: 0.1 s for the 17,000 empty triangles of 100
/// uniform points with a start; branching is exponential in the worst case.
[[nodiscard]] TriangleCover lightest_triangle_cover(const TriangleCoverProblem& problem);

}  // namespace mwt
