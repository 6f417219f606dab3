// The edges of which every triangulation contains one, at an extreme point of a hole, and a ray that proves it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// Let u be a hole's last point in some direction. A triangulation leaves no angle of 180 degrees at u, so one of the
/// edges that lead from u farther in that direction is part of it. A point infinitesimally beyond u lies in exactly one
/// triangle, whose sides cross the ray from there in that direction once more outwards than inwards; those of every
/// other triangle cross it as often one way as the other.
class HoleCuts {
 public:
  /// Of the four directions of the axes, that with the fewest edges. `hole`: the points of a hole's boundary or an
  /// isolated one; `edges`: all that may be part of a triangulation. The points must stay alive.
  HoleCuts(Points points, std::span<const Index> hole, std::span<const Edge> edges);

  /// By position in `edges`, ascending.
  [[nodiscard]] const std::vector<std::uint32_t>& edges() const { return cuts_; }

  [[nodiscard]] Index from() const { return from_; }

  /// Of the side between two points, for the triangle on its left: 1 outwards, -1 inwards, 0 if it does not cross the
  /// ray. Of a triangle's three sides the sum is 1 if the point beyond u lies in it, else 0.
  [[nodiscard]] int crossing_of_ray(Index first, Index second) const;

 private:
  [[nodiscard]] Point turned(Index v) const;

  Points points_;
  int turns_ = 0;
  Index from_ = 0;
  std::vector<std::uint32_t> cuts_;
};

}  // namespace mwt
