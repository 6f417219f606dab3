#include "algorithms/exact/candidates/long_edge_kernels.h"

#include "geometry/predicates.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/exact/candidates/long_edge_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mwt {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Double = hn::CappedTag<double, PointColumns::kWidth>;
constexpr Double kDouble;

HWY_INLINE std::uint64_t bits_of(hn::Mask<Double> mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(kDouble, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits & ((std::uint64_t{1} << hn::Lanes(kDouble)) - 1);
}

// Points below a roof whose side of the edge doubles cannot tell.
void look_exactly(const PointColumns& points, std::size_t first, std::uint64_t unsure, const Point& p, const Point& q,
                  DiamondOccupancy& occupancy) {
  for (; unsure != 0; unsure &= unsure - 1) {
    const std::size_t i = first + static_cast<std::size_t>(__builtin_ctzll(unsure));
    const int side = orientation(p, q, {points.x[i], points.y[i]});
    occupancy.left |= side > 0;
    occupancy.right |= side < 0;
    occupancy.on_edge |= side == 0;
  }
}

DiamondOccupancy FindOccupancy(const PointColumns& points, const Point& p, const Point& q, double scale) {
  const auto px = hn::Set(kDouble, p.x), py = hn::Set(kDouble, p.y);
  const auto qx = hn::Set(kDouble, q.x), qy = hn::Set(kDouble, q.y);
  const auto factor = hn::Set(kDouble, scale), tangent = hn::Set(kDouble, kTangentForDoubles);
  const auto ex = hn::Mul(hn::Sub(qx, px), factor), ey = hn::Mul(hn::Sub(qy, py), factor);
  const auto half = hn::Mul(hn::Set(kDouble, 0.5), hn::Add(hn::Mul(ex, ex), hn::Mul(ey, ey)));
  DiamondOccupancy occupancy;
  for (std::size_t i = 0; i < points.count && !occupancy.excludes(); i += hn::Lanes(kDouble)) {
    const auto point_x = hn::LoadU(kDouble, points.x + i), point_y = hn::LoadU(kDouble, points.y + i);
    auto x = hn::Mul(hn::Sub(point_x, px), factor), y = hn::Mul(hn::Sub(point_y, py), factor);
    auto along = hn::Add(hn::Mul(ex, x), hn::Mul(ey, y));
    // Measured from the nearer end, lengths keep their relative precision.
    const auto is_nearer_to_q = hn::Gt(along, half);
    x = hn::IfThenElse(is_nearer_to_q, hn::Mul(hn::Sub(point_x, qx), factor), x);
    y = hn::IfThenElse(is_nearer_to_q, hn::Mul(hn::Sub(point_y, qy), factor), y);
    along = hn::IfThenElse(is_nearer_to_q, hn::Neg(hn::Add(hn::Mul(ex, x), hn::Mul(ey, y))), along);
    const auto one = hn::Mul(ex, y), two = hn::Mul(ey, x);
    const auto height = hn::Sub(one, two), magnitude = hn::Add(hn::Abs(one), hn::Abs(two));
    const auto is_below_roof =
        hn::And(hn::Lt(hn::Abs(height), hn::Mul(tangent, along)), hn::Gt(along, hn::Set(kDouble, kTrustedProduct)));
    if (hn::AllFalse(kDouble, is_below_roof)) continue;
    // The product of two rounded differences, rounded, and their difference: 3 * 2^-53 of the magnitude, and its
    // square.
    const auto is_sure = hn::And(hn::Gt(hn::Abs(height), hn::Mul(magnitude, hn::Set(kDouble, 1e-15))),
                                 hn::Gt(magnitude, hn::Set(kDouble, kTrustedProduct)));
    const auto is_inside = hn::And(is_below_roof, is_sure);
    const auto is_left = hn::Gt(height, hn::Zero(kDouble));
    occupancy.left |= !hn::AllFalse(kDouble, hn::And(is_inside, is_left));
    occupancy.right |= !hn::AllFalse(kDouble, hn::AndNot(is_left, is_inside));
    const auto unsure = hn::AndNot(is_sure, is_below_roof);
    if (!hn::AllFalse(kDouble, unsure)) look_exactly(points, i, bits_of(unsure), p, q, occupancy);
  }
  return occupancy;
}

}  // namespace HWY_NAMESPACE
}  // namespace mwt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mwt {

HWY_EXPORT(FindOccupancy);

DiamondOccupancy find_occupancy(const PointColumns& points, const Point& p, const Point& q, double scale) {
  return HWY_DYNAMIC_DISPATCH(FindOccupancy)(points, p, q, scale);
}

}  // namespace mwt
#endif
