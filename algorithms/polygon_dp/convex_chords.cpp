#include "algorithms/polygon_dp/convex_chords.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/interval.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// An exponent e such that all coordinates differ by less than 2^e, and some by 2^(e - 4) at least.
int extent_exponent(Points points) {
  const Point& origin = points.front();
  double half = 0;  // halves do not overflow
  for (const Point& p : points) {
    half = std::max({half, std::abs(0.5 * p.x - 0.5 * origin.x), std::abs(0.5 * p.y - 0.5 * origin.y)});
  }
  return half > 0 ? std::ilogb(half) + 3 : 0;
}

}  // namespace

ConvexChords::ConvexChords(Points polygon, double weight_at_most)
    : size_(polygon.size()), exponent_(extent_exponent(polygon)), side_end_(polygon.size()) {
  for (std::size_t i = 0; i < 2 * size_ + kTile; ++i) {
    const Point& p = polygon[i % size_];
    x_.push_back(std::ldexp(p.x, -exponent_));
    y_.push_back(std::ldexp(p.y, -exponent_));
  }
  const int weight_exponent = std::ilogb(weight_at_most) + 1 - exponent_;
  units_exponent_ = std::ilogb(static_cast<double>(kMaxCost)) - weight_exponent;
  const auto corner = [&](std::size_t i) { return polygon[i % size_]; };
  side_end_[size_ - 1] = size_;  // vertex 0 is a strict corner
  for (std::size_t i = size_ - 1; i-- > 0;) {
    side_end_[i] = orientation(corner(i), corner(i + 1), corner(i + 2)) == 0 ? side_end_[i + 1] : i + 1;
  }
}

void ConvexChords::lengths_from(std::size_t i, std::size_t first, TileCost* lengths) const {
  chord_lengths({x_[i], y_[i], &x_[first], &y_[first], std::ldexp(1.0, units_exponent_)}, lengths);
  for (std::size_t j = std::max(i + 2, first); j < first + kTile && runs_along_side(i, j); ++j) {
    lengths[j - first] = kNoCost;
  }
}

TileCost ConvexChords::length(std::size_t i, std::size_t j) const {
  if (runs_along_side(i, j)) return kNoCost;
  return static_cast<TileCost>(std::ldexp(std::hypot(x_[j] - x_[i], y_[j] - y_[i]), units_exponent_));
}

TileCost ConvexChords::units_at_most(double local_length) const {
  const double certain = local_length * (1 - 0x1p-40) - 0x1p-45;
  return certain > 0 ? static_cast<TileCost>(std::ldexp(certain, units_exponent_)) : 0;
}

double ConvexChords::true_length_at_least(TileCost cost) const {
  const double lower = static_cast<double>(cost) * (1 - 0x1p-50);  // the conversion errs by 2^-53
  return std::max(0.0, next_down(std::ldexp(lower, exponent_ - units_exponent_)));
}

}  // namespace mwt
