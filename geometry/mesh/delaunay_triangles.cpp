#include "geometry/mesh/delaunay_triangles.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/mesh/in_circle.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::uint32_t triangle_of(Side side) { return side >> 2; }
constexpr std::uint32_t corner_of(Side side) { return side & 3; }
constexpr std::uint32_t after(std::uint32_t corner) { return corner == 2 ? 0 : corner + 1; }
constexpr Side next_side(Side side) { return (side & ~3U) | after(side & 3); }

// The round in which a point enters, counted from the last: each has a quarter of the points of the one after it.
int round_of(Index point) {
  std::uint64_t hash = point + 0x9e3779b97f4a7c15ULL;  // splitmix64, Steele, Lea, Flood, OOPSLA 2014
  hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ULL;
  hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebULL;
  return std::countr_zero(hash | (std::uint64_t{1} << 40)) / 2;
}

// All points, round by round, in their order within each round.
KeptVector<Index> insertion_order(Index point_count) {
  constexpr std::size_t kRounds = 21;
  std::array<std::size_t, kRounds + 1> place{};
  for (Index i = 0; i < point_count; ++i) ++place[kRounds - static_cast<std::size_t>(round_of(i))];
  for (std::size_t round = 1; round <= kRounds; ++round) place[round] += place[round - 1];
  KeptVector<Index> order(point_count);
  for (Index i = 0; i < point_count; ++i) order[place[kRounds - 1 - static_cast<std::size_t>(round_of(i))]++] = i;
  return order;
}

class DelaunayBuilder {
 public:
  // The last of the points is the one at infinity.
  explicit DelaunayBuilder(Points points) : points_(points), ghost_(static_cast<Index>(points.size() - 1)) {
    triangles_.reserve(2 * points.size());
  }

  KeptVector<LinkedTriangle> build() {
    KeptVector<Index> order = insertion_order(ghost_);
    start_with_a_triangle(order);
    for (std::size_t i = 3; i < order.size(); ++i) insert(order[i]);
    return std::move(triangles_);
  }

 private:
  // A side of the region that the new point replaces: its first corner and what lies beyond.
  struct Boundary {
    Index from;
    Side beyond;
  };

  [[nodiscard]] Index from(Side side) const { return triangles_[triangle_of(side)].corners[corner_of(side)]; }
  [[nodiscard]] Index to(Side side) const { return from(next_side(side)); }
  [[nodiscard]] Side twin(Side side) const { return triangles_[triangle_of(side)].twins[corner_of(side)]; }

  // Brings three points that span a triangle to the front of `order` and triangulates them.
  void start_with_a_triangle(KeptVector<Index>& order) {
    std::size_t third = 2;
    const Point& a = points_[order[0]];
    const Point& b = points_[order[1]];
    while (third < order.size() && orientation(a, b, points_[order[third]]) == 0) ++third;
    if (third >= order.size()) throw std::logic_error("delaunay_triangles: all points lie on one line");
    std::rotate(order.begin() + 2, order.begin() + static_cast<std::ptrdiff_t>(third),
                order.begin() + static_cast<std::ptrdiff_t>(third) + 1);
    Index u = order[0], v = order[1];
    const Index w = order[2];
    if (orientation(points_[u], points_[v], points_[w]) < 0) std::swap(u, v);
    triangles_ = {{{u, v, w}, {4, 8, 12}},
                  {{v, u, ghost_}, {0, 14, 9}},
                  {{w, v, ghost_}, {1, 6, 13}},
                  {{u, w, ghost_}, {2, 10, 5}}};
  }

  // Some triangle hit by p: the one that contains p or, outside the hull, a ghost whose hull edge is visible from p.
  [[nodiscard]] std::uint32_t find_hit(const Point& p) const {
    std::uint32_t triangle = last_;
    if (is_ghost(triangle)) triangle = triangle_of(hull_twin(triangle));
    std::uint32_t skipped = 3;  // the side through which the walk came
    while (true) {
      const LinkedTriangle& t = triangles_[triangle];
      std::uint32_t exit = 3;
      for (std::uint32_t i = 0; i < 3 && exit == 3; ++i) {
        if (i != skipped && orientation(points_[t.corners[i]], points_[t.corners[after(i)]], p) < 0) exit = i;
      }
      if (exit == 3) return triangle;
      triangle = triangle_of(t.twins[exit]);
      skipped = corner_of(t.twins[exit]);
      if (is_ghost(triangle)) return triangle;
    }
  }

  [[nodiscard]] bool is_ghost(std::uint32_t triangle) const {
    const auto& corners = triangles_[triangle].corners;
    return corners[0] == ghost_ || corners[1] == ghost_ || corners[2] == ghost_;
  }

  // The side of a ghost that is an edge of the hull, seen from inside.
  [[nodiscard]] Side hull_twin(std::uint32_t ghost) const { return twin(hull_side(ghost)); }

  [[nodiscard]] Side hull_side(std::uint32_t ghost) const {
    const auto& corners = triangles_[ghost].corners;
    return 4 * ghost + (corners[0] == ghost_ ? 1U : corners[1] == ghost_ ? 2U : 0U);
  }

  // Whether p lies inside the triangle's circle; for a ghost: beyond its hull edge, or on that edge.
  [[nodiscard]] bool is_hit(std::uint32_t triangle, const Point& p) const {
    const auto& corners = triangles_[triangle].corners;
    if (corners[0] != ghost_ && corners[1] != ghost_ && corners[2] != ghost_) [[likely]] {
      return fast_in_circle(points_[corners[0]], points_[corners[1]], points_[corners[2]], p) > 0;
    }
    const Side hull = hull_side(triangle);
    const Point& a = points_[from(hull)];
    const Point& b = points_[to(hull)];
    const int turn = orientation(a, b, p);
    return turn > 0 || (turn == 0 && in_segment_interior(p, a, b));
  }

  // Walks through the triangles hit by p, which form a tree, in counter-clockwise order of their boundary.
  void collect_hit(std::uint32_t first, const Point& p) {
    hit_.assign(1, first);
    boundary_.clear();
    open_.assign({4 * first + 2, 4 * first + 1, 4 * first});
    while (!open_.empty()) {
      const Side side = open_.back();
      open_.pop_back();
      const Side beyond = twin(side);
      if (is_hit(triangle_of(beyond), p)) {
        hit_.push_back(triangle_of(beyond));
        const Side second = next_side(beyond);
        open_.push_back(next_side(second));
        open_.push_back(second);
      } else {
        boundary_.push_back({from(side), beyond});
      }
    }
  }

  // Joins p to every side of the boundary; reuses the triangles that were hit and appends two.
  void fill_with_star(Index p) {
    const std::size_t count = boundary_.size();
    for (std::size_t i = hit_.size(); i < count; ++i) {
      hit_.push_back(static_cast<std::uint32_t>(triangles_.size()));
      triangles_.emplace_back();
    }
    std::uint32_t previous = hit_[count - 1];
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t triangle = hit_[i];
      const std::size_t following = i + 1 == count ? 0 : i + 1;
      const Side beyond = boundary_[i].beyond;
      triangles_[triangle] = {{boundary_[i].from, boundary_[following].from, p},
                              {beyond, 4 * hit_[following] + 2, 4 * previous + 1}};
      triangles_[triangle_of(beyond)].twins[corner_of(beyond)] = 4 * triangle;
      previous = triangle;
    }
    last_ = previous;
  }

  void insert(Index p) {
    const Point& point = points_[p];
    collect_hit(find_hit(point), point);
    fill_with_star(p);
  }

  Points points_;
  Index ghost_;
  KeptVector<LinkedTriangle> triangles_;
  std::uint32_t last_ = 0;  // where the next walk starts
  std::vector<std::uint32_t> hit_;
  std::vector<Boundary> boundary_;
  std::vector<Side> open_;
};

}  // namespace

KeptVector<LinkedTriangle> delaunay_triangles(KeptVector<Point>& points) {
  // A NaN satisfies no filter, so that fast paths need no test for ghosts.
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  points.push_back({kNan, kNan});
  struct Restored {
    KeptVector<Point>& points;
    ~Restored() { points.pop_back(); }
  } const restored{points};
  return DelaunayBuilder(points).build();
}

}  // namespace mwt
