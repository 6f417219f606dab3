// What the triangles at given edges cost at least, from the points alone.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/candidates/kd_order.h"
#include "geometry/triangulation.h"

namespace mwt {

/// One side of an edge pq: every triangulation that contains the edge has a triangle pqz there. All lengths are rounded
/// so that the costs are never too large; infinite: there is no such z.
struct SideCost {
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  double edge = 0;          ///< |pq|
  double detour = kNone;    ///< least |pz| + |qz|
  double diagonal = kNone;  ///< the same of one diagonal, if the third side is one of the given edges
  bool is_free = false;     ///< whether the triangle may consist of given edges

  /// What a triangulation pays at this side: half the length of the triangle's sides that are none of the given edges,
  /// shared among those that are; of each length, no more than the first `cap` counts. 0 if there is no triangle.
  [[nodiscard]] double capped(double cap) const;
};

/// The sides of these edges, which must not cross each other (ends by position in the order, a < b, ascending): left
/// and right of each in turn. Runs on the threads of the enclosing task arena; sides that the deadline leaves over cost
/// nothing.
///
/// Neither emptiness of a triangle nor visibility of its apex is looked for: leaving that out only lowers the costs.
/// O(log n) for each side where the nearest points beside an edge are no farther than points along it.
[[nodiscard]] std::vector<SideCost> side_costs(const KdOrder& order, std::span<const Edge> edges,
                                               const Deadline& deadline);

}  // namespace mwt
