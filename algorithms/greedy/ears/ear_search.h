// Which ears belong to the greedy triangulation whatever comes later.
#pragma once

#include <array>
#include <cstddef>

#include "algorithms/greedy/faces/wedge.h"
#include "geometry/mesh/edge_order.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// A corner c of a face between its neighbours on the boundary: counter-clockwise around c, the wedge goes from the
/// edge to `next` to the edge to `previous`.
struct EarSite {
  Wedge wedge;
  Index apex;
  Index next;
  Index previous;
  std::array<Index, 2> beyond;  ///< the next but one on either side, likely to stand against the ear
};

/// Looks for what stands against ears; keeps count of its work.
class EarSearch {
 public:
  EarSearch(const PlanarMesh& mesh, const EdgeOrder& order) : mesh_(mesh), order_(order) {}

  /// Whether the wedge's third side ab is certainly greedy: the angle at its apex c is convex and not acute, the closed
  /// triangle abc holds no other point, and ab precedes every edge from c through ab to a point visible from c. Only
  /// such edges cross ab without crossing a fixed edge (lemma 3 in PROOFS.md).
  ///
  /// Searches the triangles behind ab that may come nearer to c than |ab|; gives up, with false, after `max_steps`.
  /// Exact where it returns true. Precondition: the mesh is a Delaunay triangulation constrained by the edges of
  /// kFixedMark, all greedy.
  [[nodiscard]] bool is_certain(const EarSite& site, std::size_t max_steps);

  /// Whether the last answer was false only because of `max_steps`.
  [[nodiscard]] bool gave_up() const { return gave_up_; }

  /// Triangles looked at so far.
  [[nodiscard]] std::size_t steps() const { return steps_; }

 private:
  /// Where a point lies with respect to the circle about c with radius |ab|. That of equal distance is inside if its
  /// edge to c precedes ab, outside otherwise.
  enum class Reach { inside, unclear, outside };
  /// As seen from c: 0 strictly inside the wedge, -1 on or beyond its first side, +1 its last.
  struct Sight {
    Index point;
    int side;
    Reach reach;
  };
  /// An edge to look through, away from c.
  struct Window {
    Halfedge inner;  // its half on the side of c, from `from` to `to`
    Sight from;
    Sight to;
  };
  static constexpr std::size_t kMaxWindows = 32;

  [[nodiscard]] bool is_convex_and_not_acute() const;
  [[nodiscard]] bool stands_against(Index v) const;
  [[nodiscard]] bool is_certain_among_spokes();
  [[nodiscard]] bool open_at_apex();
  [[nodiscard]] bool search();
  [[nodiscard]] bool open(const Window& window, Reach third);
  [[nodiscard]] bool give_up();
  [[nodiscard]] Sight sight(Index v) const;
  [[nodiscard]] int side_of(const Point& p) const;
  [[nodiscard]] Reach rounded_reach(const Point& p) const;
  [[nodiscard]] Reach exact_reach(Index v) const;

  const PlanarMesh& mesh_;
  const EdgeOrder& order_;
  std::size_t steps_ = 0;
  std::size_t last_step_ = 0;
  bool gave_up_ = false;
  EarSite site_{};
  Point apex_{}, a_{}, b_{};
  double squared_length_ = 0;
  std::array<Window, kMaxWindows> windows_{};  // still to be looked through
  std::size_t count_ = 0;
};

}  // namespace mwt
