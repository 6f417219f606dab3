// The universal cover of a face with one hole: a strip between two chains that repeat for ever.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/exact/faces/face_region.h"

namespace mwt {

/// A face with one hole or isolated vertex, cut open along an edge from the outer to the inner boundary and continued
/// by a copy of itself across the cut, and so on on both sides.
///
/// Outer places A count the corners of the outer boundary counter-clockwise, inner places S those of the inner boundary
/// in the same direction along the strip; place A + outer_period is the same corner in the next copy, S + inner_period
/// likewise (an isolated vertex has period 0 and the one place 0). The cut joins places 0 and 0. The strip is simply
/// connected, so that three edges of it that join three places pairwise bound a triangle without further points; and a
/// candidate, being straight, has one definite course in it, up to shifts by whole periods of both.
struct Strip {
  using Place = std::int32_t;

  /// One of the two chains and the candidates that join places of it.
  struct Chain {
    std::vector<Index> vertex;              ///< by place, for one period; one vertex if the period is 0
    std::vector<std::vector<Place>> chord;  ///< from each place to later ones, ascending; the boundary's edges too

    [[nodiscard]] Place period() const { return static_cast<Place>(chord.size()); }
    [[nodiscard]] Index vertex_at(Place place) const {
      return vertex[chord.empty() ? 0 : static_cast<std::size_t>(((place % period()) + period()) % period())];
    }
  };

  Chain outer;
  Chain inner;
  std::vector<std::vector<Place>> across;  ///< from each outer place of one period to inner places, ascending
};

/// The strip of a region with two boundary components. Nothing if the region is no such face: no candidate joins the
/// components, or some candidate leaves the face. `points` are those of the region's vertices, in their order; all
/// vertices by position in region.vertices. O(m log m) for m candidates.
[[nodiscard]] std::optional<Strip> make_strip(Points points, const FaceRegion& region);

/// A candidate across the strip: outer place 0 .. period - 1, any inner place.
struct CrossEdge {
  Strip::Place outer = 0;
  Strip::Place inner = 0;

  friend auto operator<=>(const CrossEdge&, const CrossEdge&) = default;
};

/// Candidates of which every triangulation contains at least one, in order.
///
/// The inner boundary's last point in lexicographic order, say, has all its boundary edges on one side. A triangulation
/// leaves no angle of 180 degrees there, so some edge leads to a later point, which is none of the inner boundary. The
/// same holds for the first point, and with x and y exchanged: the fewest edges of the four are taken.
[[nodiscard]] std::vector<CrossEdge> unavoidable_edges(Points points, const Strip& strip);

}  // namespace mwt
