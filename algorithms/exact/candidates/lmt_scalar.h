// The LMT-skeleton's inner loops, one halfedge at a time: the definition of what lmt_kernels.cpp computes on vectors,
// function by function under the same names. `Rounding` is as in float_rounding.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/exact/candidates/float_rounding.h"
#include "algorithms/exact/candidates/stars.h"

namespace mwt {

/// Relative rounding errors of the products and differences below stay under this margin, with room: vectors err by
/// 2^-24 in each component, differences of two vectors by 2^-23 of both lengths, and what is compared, products of two
/// of these, by 12 * 2^-24 < 8e-7 of the squares that the margin is relative to. No product that matters underflows
/// (Star::component). Comparisons with components that are not numbers are false; each is used so that false means not
/// sure.
inline constexpr float kLmtMargin = 2e-6F;

inline constexpr std::uint32_t kNotFound = std::numeric_limits<std::uint32_t>::max();

struct FloatVector {
  float x = 0;
  float y = 0;
};

/// An edge under examination, from its first end s.
struct ExaminedEdge {
  FloatVector vector;
  float square = 0;
};

/// Third corners of candidate triangles on one side of an edge s -> o, relative to s, in the order of the star of s.
struct Apexes {
  enum class Triangle : std::uint8_t { not_examined, open, blocked };

  std::vector<float> x, y;
  std::vector<std::uint32_t> position;  ///< in the star of s
  std::vector<Triangle> triangle;       ///< whether some point is known to lie in the apex's triangle with the edge
  std::uint32_t count = 0;
  float side = 0;  ///< +1 left, -1 right

  void start(std::size_t room, float on_side) {
    if (x.size() < room) {
      x.resize(room);
      y.resize(room);
      position.resize(room);
    }
    triangle.clear();
    count = 0;
    side = on_side;
  }

  void append(float at_x, float at_y, std::uint32_t at_position) {
    x[count] = at_x;
    y[count] = at_y;
    position[count++] = at_position;
  }
};

template <class Rounding>
struct ScalarStars {
  /// Position of `target` in the star, or kNotFound.
  static std::uint32_t position_of(const Star& star, Index target) {
    const auto targets = star.targets();
    const auto place = std::find(targets.begin(), targets.end(), target);
    return place == targets.end() ? kNotFound : static_cast<std::uint32_t>(place - targets.begin());
  }

  /// Takes one halfedge out of a star, renumbers the certificates, and calls broken(target) for each edge whose
  /// certificate used it, which then has none.
  template <class Broken>
  static void erase(Star& star, std::uint32_t position, const Broken& broken) {
    star.erase(position);
    for (std::uint32_t i = 0; i < star.count; ++i) {
      std::uint32_t& certificate = star.certificate()[i];
      if (certificate == Star::kNoCertificate) continue;
      const std::uint32_t left = certificate & 0xFFFF, right = certificate >> 16;
      if (left == position || right == position) {
        certificate = Star::kNoCertificate;
        broken(star.target()[i]);
      } else {
        certificate = (left - (left > position ? 1 : 0)) | ((right - (right > position ? 1 : 0)) << 16);
      }
    }
  }

  /// The common neighbours of both ends, by their side of the edge; those that floats see too close to its line by
  /// exact_side(neighbour): +1, -1, or 0 on the line. Both stars are sorted by target, so they are merged.
  template <class ExactSide>
  static void collect_apexes(const Star& star, const Star& other, const ExaminedEdge& edge, const ExactSide& exact_side,
                             Apexes& left, Apexes& right) {
    std::uint32_t k = 0;
    for (std::uint32_t i = 0; i < star.count; ++i) {
      const Index target = star.target()[i];
      while (k < other.count && other.target()[k] < target) ++k;
      if (k == other.count || other.target()[k] != target) continue;
      const float x = star.x()[i], y = star.y()[i];
      const float one = edge.vector.x * y, two = edge.vector.y * x;
      const float height = one - two, margin = (std::abs(one) + std::abs(two)) * kLmtMargin;
      const int side = height > margin ? 1 : height < -margin ? -1 : exact_side(target);
      if (side > 0) left.append(x, y, i);
      if (side < 0) right.append(x, y, i);
    }
  }

  /// Whether a neighbour lies certainly inside the triangle spanned at the star's center by two vectors, the second to
  /// the left of the first; both are given times `side`.
  static bool has_point_inside(const Star& star, const FloatVector& first, const FloatVector& second, float side) {
    const float one = first.x * second.y, two = first.y * second.x;
    const float area = side * (one - two) - kLmtMargin * (std::abs(one) + std::abs(two));
    const float error = kLmtMargin * (std::abs(first.x) + std::abs(first.y) + std::abs(second.x) + std::abs(second.y));
    for (std::uint32_t i = 0; i < star.count; ++i) {
      const float x = star.x()[i], y = star.y()[i];
      const float margin = error * (std::abs(x) + std::abs(y));
      const float left_of_first = first.x * y - first.y * x;
      const float right_of_second = x * second.y - y * second.x;
      if (left_of_first > margin && right_of_second > margin && left_of_first + right_of_second + margin < area)
        return true;
    }
    return false;
  }

  /// Calls visit(r) for each right apex r with which left apex `a` may make the edge locally minimal, in order, until
  /// visit returns true. The two do not if the quadrilateral is certainly convex and its other diagonal certainly
  /// shorter than the edge.
  template <class Visit>
  static void visit_certifying(const ExaminedEdge& edge, const Apexes& left, std::uint32_t a, const Apexes& right,
                               const Visit& visit) {
    const float lx = left.x[a], ly = left.y[a];
    const float left_square = Rounding::multiply_add(lx, lx, ly * ly);
    const float from_o_x = lx - edge.vector.x, from_o_y = ly - edge.vector.y;
    for (std::uint32_t r = 0; r < right.count; ++r) {
      const float x = right.x[r], y = right.y[r];
      const float reach = left_square + Rounding::multiply_add(x, x, y * y);
      const float slack = kLmtMargin * (reach + edge.square);
      const float at_s = x * ly - y * lx;
      const float at_o = from_o_x * (y - edge.vector.y) - from_o_y * (x - edge.vector.x);
      const float dx = lx - x, dy = ly - y;
      const float diagonal = Rounding::multiply_add(dx, dx, dy * dy) + slack;
      const bool is_convex = at_s > slack && at_o > slack;
      const bool is_shorter = diagonal < edge.square * (1 - kLmtMargin);
      if (!(is_convex && is_shorter) && visit(r)) return;
    }
  }
};

}  // namespace mwt
