#include <array>
#include <cmath>
#include <cstddef>

#include "algorithms/greedy/certified_edges.h"
#include "algorithms/greedy/greedy_marks.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

double squared_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x, dy = p.y - q.y;
  return dx * dx + dy * dy;
}

// Whether segment uv is certainly farther than `squared` from c. Rounded towards no.
bool is_surely_beyond(const Point& c, const Point& u, const Point& v, double squared) {
  constexpr double kMargin = 1 + 1e-12;
  const double ux = u.x - c.x, uy = u.y - c.y, vx = v.x - c.x, vy = v.y - c.y;
  const double wx = vx - ux, wy = vy - uy;
  if (ux * wx + uy * wy >= 0) return ux * ux + uy * uy > squared * kMargin;
  if (vx * wx + vy * wy <= 0) return vx * vx + vy * vy > squared * kMargin;
  const double left = ux * vy, right = uy * vx;
  const double area = std::abs(left - right) - 8e-16 * (std::abs(left) + std::abs(right));
  return area > 0 && area * area > squared * (wx * wx + wy * wy) * kMargin;
}

class EarSearch {
 public:
  EarSearch(const PlanarMesh& mesh, const EdgeOrder& order, const Wedge& wedge)
      : mesh_(mesh),
        order_(order),
        wedge_(wedge),
        apex_(mesh.origin(wedge.first)),
        a_(mesh.target(wedge.first)),
        b_(mesh.target(wedge.last)),
        squared_length_(squared_distance(mesh.point(a_), mesh.point(b_))) {}

  bool is_certain() {
    const bool in_range = squared_length_ > 1e-200 && squared_length_ < 1e200;
    return in_range && is_certain_among_spokes() && open_at_apex() && search();
  }

 private:
  // Where a point lies as seen from c: 0 strictly inside the wedge, -1 on or beyond its first side, +1 its last.
  struct Corner {
    Index point;
    int side;
  };
  // An edge to look through, away from c.
  struct Window {
    Halfedge inner;  // its half on the side of c, from `from` to `to`
    Corner from;
    Corner to;
  };
  static constexpr std::size_t kMostWindows = 32;

  // Whether the points at the spokes lie beyond the ear and come after it: most wedges that are no certain ear fail
  // here.
  [[nodiscard]] bool is_certain_among_spokes() const {
    for (Halfedge spoke = mesh_.rotate_left(wedge_.first); spoke != wedge_.last; spoke = mesh_.rotate_left(spoke)) {
      const Index v = mesh_.target(spoke);
      if (!comes_after_ear(v) || !is_beyond_ear(v)) return false;
    }
    return true;
  }

  // Looks through the triangles at c.
  bool open_at_apex() {
    Corner from{a_, -1};
    for (Halfedge spoke = wedge_.first; spoke != wedge_.last;) {
      const Halfedge left = mesh_.rotate_left(spoke);
      const Corner to{mesh_.target(left), left == wedge_.last ? 1 : 0};
      if (!open({mesh_.next(spoke), from, to})) return false;
      from = to;
      spoke = left;
    }
    return true;
  }

  bool search() {
    for (std::size_t i = 0; i < count_; ++i) {
      const Window window = windows_[i];
      const Halfedge outer = twin(window.inner);
      const Corner corner = corner_at(mesh_.apex(outer));
      if (corner.side == 0 && !comes_after_ear(corner.point)) return false;
      // The triangle beyond: outer goes from `to` to `from`, its next one from `from` to the apex.
      if (!open({mesh_.next(outer), window.from, corner}) || !open({mesh_.previous(outer), corner, window.to}))
        return false;
    }
    return true;
  }

  // Remembers the window if something may be seen through it; false when there are too many.
  bool open(const Window& window) {
    const bool is_outside = window.from.side != 0 && window.from.side == window.to.side;
    if (is_outside || (mesh_.marks(edge_of(window.inner)) & kFixedMark) != 0) return true;
    const Point &from = mesh_.point(window.from.point), &to = mesh_.point(window.to.point);
    // The ends of the ear are nearer to c than they are to each other.
    const bool starts_near = window.from.point == a_ || window.to.point == b_;
    if (!starts_near && is_surely_beyond(mesh_.point(apex_), from, to, squared_length_)) return true;
    if (count_ == kMostWindows) return false;
    windows_[count_++] = window;
    return true;
  }

  [[nodiscard]] Corner corner_at(Index v) const {
    const Point &c = mesh_.point(apex_), &p = mesh_.point(v);
    if (orientation(c, mesh_.point(a_), p) <= 0) return {v, -1};
    return {v, orientation(c, p, mesh_.point(b_)) <= 0 ? 1 : 0};
  }

  [[nodiscard]] bool is_beyond_ear(Index v) const {
    return orientation(mesh_.point(a_), mesh_.point(b_), mesh_.point(v)) < 0;
  }

  [[nodiscard]] bool comes_after_ear(Index v) const {
    if (squared_distance(mesh_.point(apex_), mesh_.point(v)) > squared_length_ * (1 + 1e-14)) return true;
    return order_.precedes(order_.key(a_, b_), order_.key(apex_, v));
  }

  const PlanarMesh& mesh_;
  const EdgeOrder& order_;
  Wedge wedge_;
  Index apex_, a_, b_;
  double squared_length_;
  std::array<Window, kMostWindows> windows_;
  std::size_t count_ = 0;
};

}  // namespace

bool is_certain_ear(const PlanarMesh& mesh, const EdgeOrder& order, const Wedge& wedge) {
  const Point& apex = mesh.point(mesh.origin(wedge.first));
  const Point& from = mesh.point(mesh.target(wedge.first));
  const Point& to = mesh.point(mesh.target(wedge.last));
  if (orientation(apex, from, to) <= 0 || dot_sign(from, apex, to) > 0) return false;
  return EarSearch(mesh, order, wedge).is_certain();
}

}  // namespace mwt
