// Certified weights: sums of Euclidean lengths with an enclosure of the true value.
#pragma once

#include <cstdint>

#include "geometry/numbers/double_double.h"
#include "geometry/numbers/interval.h"
#include "geometry/triangulation.h"

namespace mwt {

/// A running sum of segment lengths in double-double arithmetic with a proven error bound.
/// Relative width of the enclosure: about 2.3e-16, and below 1e-13 for any number of terms up to 2^45; above 2^-970.
class LengthSum {
 public:
  void add(const Point& p, const Point& q) {
    sum_ += length(p, q);
    ++terms_;
  }

  /// Adds a sum made elsewhere (by another thread, say). The enclosure's proof does not depend on the order of
  /// additions.
  void add(const LengthSum& other) {
    sum_ += other.sum_;
    terms_ += other.terms_;
  }

  [[nodiscard]] Interval enclosure() const {
    return enclose(sum_, (static_cast<double>(terms_) + 8) * kDoubleDoubleError);
  }

 private:
  DoubleDouble sum_;
  std::uint64_t terms_ = 0;
};

/// The weight: the sum of all edges' lengths, every edge once. O(n).
/// Precondition: the triangulation's indices are in range of `points`.
[[nodiscard]] Interval weight(Points points, const Triangulation& triangulation);

/// The source report's other objective: the sum of the triangles' perimeters (= 2 weight - length of the hull). O(n).
[[nodiscard]] Interval perimeter_sum(Points points, const Triangulation& triangulation);

/// Length of the closed polygon through `cycle`.
[[nodiscard]] Interval cycle_length(Points points, std::span<const Index> cycle);

}  // namespace mwt
