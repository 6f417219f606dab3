// What a region with holes shrinks to by bounds: cut open, dual values, and candidates that cost too much.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/faces/face_region.h"
#include "geometry/weight.h"

namespace mwt {

/// Every triangulation of the region by its candidates, of total length of diagonals at most `reach`, consists of
/// `candidates` and contains the certain ones among them.
struct ReducedRegion {
  std::vector<Triangle> triangles;  ///< the lightest triangulation that contains the cuts; none if there is none
  LengthSum diagonals;              ///< their total length
  double lower_bound = 0;           ///< certified, on the diagonals of any triangulation by the region's candidates
  double reach = 0;
  std::vector<Edge> candidates;  ///< of the instance, a < b, ascending
  std::vector<Edge> certain;     ///< of these, cuts that are in every triangulation in question

  /// There is nothing to be found that is lighter by more than rounding.
  [[nodiscard]] bool is_closed() const { return lower_bound >= reach * (1 - 1e-14); }
};

/// Joins the region's boundary components by cuts (cut_polygon.h); the best triangulation with all of them is an upper
/// bound. Dual values (cut_duals.h) bound all others from below, and show which candidates are in none that is as
/// light. `limit`: heavier triangulations are of no interest.
///
/// Nothing if the cuts admit no triangulation, the deadline passes before the program is finished, or more than 2^24
/// triangles would have to be looked at. Afterwards the deadline only stops improvements. Precondition: at least 2
/// components. Time: a polygon's program, and once or twice again for what it says about every chord.
[[nodiscard]] std::optional<ReducedRegion> reduce_region(Points points, const FaceRegion& region, double limit,
                                                         const Deadline& deadline);

}  // namespace mwt
