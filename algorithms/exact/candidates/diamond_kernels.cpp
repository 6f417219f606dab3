#include "algorithms/exact/candidates/diamond_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/exact/candidates/diamond_scalar.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "algorithms/exact/candidates/diamond_kernels.cpp"
#include <hwy/foreach_target.h>  // compiles this file once per instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace mwt {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Float = hn::CappedTag<float, 16>;
using Int = hn::RebindToSigned<Float>;
using VectorF = hn::Vec<Float>;
using VectorI = hn::Vec<Int>;

constexpr Float kFloat;
constexpr Int kInt;

// diamond_scalar.h has each of the functions below for one place, with comments on what is computed; those here are for
// one vector of places, whose lanes compute exactly the same.

struct MachineRounding {
  static float multiply_add(float a, float b, float c) {
    const hn::CappedTag<float, 1> one;
    return hn::GetLane(hn::MulAdd(hn::Set(one, a), hn::Set(one, b), hn::Set(one, c)));
  }
};

HWY_INLINE VectorF scaled_difference(const double* coordinates, double origin, double scale) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(kFloat, static_cast<float>((*coordinates - origin) * scale));
#else
  const hn::Half<Float> half;
  const hn::Rebind<double, hn::Half<Float> > d;
  const auto base = hn::Set(d, origin);
  const auto factor = hn::Set(d, scale);
  const auto low = hn::Mul(hn::Sub(hn::LoadU(d, coordinates), base), factor);
  const auto high = hn::Mul(hn::Sub(hn::LoadU(d, coordinates + hn::Lanes(d)), base), factor);
  return hn::Combine(kFloat, hn::DemoteTo(half, high), hn::DemoteTo(half, low));
#endif
}

// Anything for the zero vector or NaN.
HWY_INLINE VectorF bin_position(VectorF raw_x, VectorF raw_y) {
  const auto cosine = hn::Set(kFloat, kBinTurnCosine), sine = hn::Set(kFloat, kBinTurnSine);
  const auto x = hn::NegMulAdd(sine, raw_y, hn::Mul(cosine, raw_x));
  const auto y = hn::MulAdd(sine, raw_x, hn::Mul(cosine, raw_y));
  const auto ax = hn::Abs(x), ay = hn::Abs(y);
  const auto t = hn::Div(hn::Min(ax, ay), hn::Max(ax, ay));
  const auto curve = hn::NegMulAdd(hn::Set(kFloat, kBinCurve), t, hn::Set(kFloat, kBinSlope));
  auto position = hn::Mul(hn::Mul(t, curve), hn::Set(kFloat, static_cast<float>(kBinsPerOctant)));
  const auto quarter = hn::Set(kFloat, 2.0F * kBinsPerOctant);
  position = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(quarter, position), position);
  position = hn::IfThenElse(hn::Lt(x, hn::Zero(kFloat)), hn::Sub(hn::Add(quarter, quarter), position), position);
  const auto whole = hn::Set(kFloat, static_cast<float>(kDirectionBins));
  return hn::IfThenElse(hn::Lt(y, hn::Zero(kFloat)), hn::Sub(whole, position), position);
}

HWY_INLINE VectorI wrapped_bin(VectorF position) {
  const auto bin = hn::ConvertTo(kInt, position);
  const auto past_last = hn::Gt(bin, hn::Set(kInt, kDirectionBins - 1));
  return hn::IfThenElse(past_last, hn::Sub(bin, hn::Set(kInt, kDirectionBins)), bin);
}

HWY_INLINE void find_nearest_per_bin(const NearPoints& near, int place, NearestPerBin& nearest) {
  nearest.clear();
  alignas(64) float squares[16];
  alignas(64) std::int32_t bins[16];
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  const double px = near.x[static_cast<std::size_t>(place)], py = near.y[static_cast<std::size_t>(place)];
  float* const bin_square = nearest.of_bin(0);
  for (int i = 0; i < near.places(); i += lanes) {
    const auto dx = scaled_difference(near.x.data() + i, px, near.scale);
    const auto dy = scaled_difference(near.y.data() + i, py, near.scale);
    const auto square = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
    const auto position = bin_position(dx, dy);
    const auto floor = hn::Floor(position);
    const auto within = hn::Sub(position, floor);
    const auto guard = hn::Set(kFloat, kBinGuard);
    const auto blocks = hn::And(hn::Gt(square, hn::Set(kFloat, kMinSquare)),
                                hn::And(hn::Gt(within, guard), hn::Lt(within, hn::Sub(hn::Set(kFloat, 1.0F), guard))));
    const auto dustbin = hn::Set(kInt, NearestPerBin::kDustbin - NearestPerBin::kMargin);
    const auto bin = hn::IfThenElse(hn::RebindMask(kInt, blocks), wrapped_bin(floor), dustbin);
    hn::Store(square, kFloat, squares);
    hn::Store(bin, kInt, bins);
    for (int lane = 0; lane < lanes; ++lane) {
      float& known = bin_square[bins[lane]];
      known = squares[lane] < known ? squares[lane] : known;
    }
  }
  nearest.repeat_around_the_circle();
}

HWY_INLINE void store_dead_distances(const NearestPerBin& nearest, DeadDistances& dead) {
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  alignas(64) std::uint32_t codes[64];
  for (int bin = 0; bin < kDirectionBins; bin += lanes) {
    const float* const here = nearest.of_bin(bin);
    auto left = hn::Set(kFloat, std::numeric_limits<float>::infinity());
    auto right = left;
    for (int j = 1; j <= kBlockingBins; ++j) {
      const float factor = kBlockingFactor[static_cast<std::size_t>(j)];
      const auto square_factor = hn::Set(kFloat, factor * factor);
      left = hn::Min(left, hn::Mul(hn::LoadU(kFloat, here + j), square_factor));
      right = hn::Min(right, hn::Mul(hn::LoadU(kFloat, here - j), square_factor));
    }
    const hn::RebindToUnsigned<Float> bits;
    const auto distance = hn::BitCast(bits, hn::Sqrt(hn::Max(left, right)));
    hn::StoreU(hn::ShiftRight<16>(hn::Add(distance, hn::Set(bits, 0xFFFF))), bits, codes + bin);
  }
  std::uint16_t farthest = 0;
  for (std::size_t bin = 0; bin < kDirectionBins; ++bin) {
    dead.code[bin] = static_cast<std::uint16_t>(codes[bin]);
    farthest = std::max(farthest, dead.code[bin]);
  }
  dead.code[DeadDistances::kFarthest] = farthest;
}

void ComputeDeadDistances(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
  NearestPerBin nearest;
  for (int place = 0; place < near.leaf_size; ++place) {
    find_nearest_per_bin(near, place, nearest);
    store_dead_distances(nearest, of_leaf_points[static_cast<std::size_t>(place)]);
  }
}

HWY_INLINE void look_around(const NearPoints& near, int place, View& view) {
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  const double px = near.x[static_cast<std::size_t>(place)], py = near.y[static_cast<std::size_t>(place)];
  for (int i = 0; i < near.leaves * static_cast<int>(KdOrder::kMaxLeaf); i += lanes) {
    hn::Store(scaled_difference(near.x.data() + i, px, near.scale), kFloat, view.x + i);
    hn::Store(scaled_difference(near.y.data() + i, py, near.scale), kFloat, view.y + i);
  }
  for (int i = 0; i < NearPoints::kBoxes; i += lanes) {
    hn::Store(scaled_difference(near.center_x.data() + i, px, near.scale), kFloat, view.center_x + i);
    hn::Store(scaled_difference(near.center_y.data() + i, py, near.scale), kFloat, view.center_y + i);
  }
}

HWY_INLINE std::uint64_t bits_of(hn::Mask<Float> mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(kFloat, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits & ((std::uint64_t{1} << hn::Lanes(kFloat)) - 1);
}

// Adds the near points in `unsure` lanes, which start at `first_place`, one after the other.
void add_exactly_each(const CandidateSearch& search, int first_place, std::uint64_t unsure, std::uint64_t low, Index p,
                      Index q, Blocking& blocking) {
  for (; unsure != 0; unsure &= unsure - 1) {
    const int lane = __builtin_ctzll(unsure);
    add_exactly(search, static_cast<std::size_t>(first_place + lane), ((low >> lane) & 1U) != 0, p, q, blocking);
  }
}

HWY_INLINE void add_near_points(const CandidateSearch& search, const View& view, const ScaledEdge& edge, int place,
                                Index p, Index q, Blocking& blocking) {
  const auto ex = hn::Set(kFloat, edge.x), ey = hn::Set(kFloat, edge.y), square = hn::Set(kFloat, edge.square);
  const auto margin = hn::Set(kFloat, kProductMargin * edge.square);
  const auto tangent = hn::Set(kFloat, static_cast<float>(kTangentOfDiamondAngle));
  const auto x = hn::Load(kFloat, view.x + place), y = hn::Load(kFloat, view.y + place);
  const auto along = hn::MulAdd(ex, x, hn::Mul(ey, y));
  const auto height = hn::NegMulAdd(ey, x, hn::Mul(ex, y));
  const auto nearer_end = hn::Min(along, hn::Sub(square, along));
  const auto roof = hn::Sub(hn::Mul(nearer_end, tangent), margin);
  const auto depth = hn::Neg(height);
  blocking.left |= !hn::AllFalse(kFloat, hn::And(hn::Gt(height, margin), hn::Lt(height, roof)));
  blocking.right |= !hn::AllFalse(kFloat, hn::And(hn::Gt(depth, margin), hn::Lt(depth, roof)));
  const auto unsure = hn::And(hn::Le(hn::Abs(height), margin), hn::Gt(nearer_end, hn::Zero(kFloat)));
  if (hn::AllFalse(kFloat, unsure)) return;
  add_exactly_each(search, place, bits_of(unsure), bits_of(hn::Gt(roof, margin)), p, q, blocking);
}

// The near leaves whose boxes meet the edge's triangles, as bits. Along the edge's line and above it, a box reaches as
// far from its center as the sums `reach` and `rise`: the nearest to the middle of the line at the least height count.
//
// A box with a point that matters is at most an edge and its own size away, so that floats lose less than 1e-6 of the
// edge's square and of the sums. That is far less than the margin, and than what the sums are rounded up by.
HWY_INLINE std::uint64_t leaves_at(const NearPoints& near, const View& view, const ScaledEdge& edge) {
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  const auto ex = hn::Set(kFloat, edge.x), ey = hn::Set(kFloat, edge.y), square = hn::Set(kFloat, edge.square);
  const auto tangent = hn::Set(kFloat, static_cast<float>(kTangentOfDiamondAngle));
  const auto margin = hn::Set(kFloat, 4 * kProductMargin * edge.square);
  std::uint64_t outside = 0;
  for (int i = 0; i < NearPoints::kBoxes; i += lanes) {
    const auto x = hn::Load(kFloat, view.center_x + i), y = hn::Load(kFloat, view.center_y + i);
    const auto half_x = hn::Load(kFloat, near.half_x.data() + i), half_y = hn::Load(kFloat, near.half_y.data() + i);
    const auto along = hn::MulAdd(ex, x, hn::Mul(ey, y));
    const auto height = hn::Abs(hn::NegMulAdd(ey, x, hn::Mul(ex, y)));
    const auto reach = hn::MulAdd(hn::Abs(ex), half_x, hn::Mul(hn::Abs(ey), half_y));
    const auto rise = hn::MulAdd(hn::Abs(ey), half_x, hn::Mul(hn::Abs(ex), half_y));
    const auto nearer_end = hn::Add(hn::Min(along, hn::Sub(square, along)), reach);
    const auto lowest = hn::Max(hn::Sub(height, rise), hn::Zero(kFloat));
    outside |= bits_of(hn::Gt(lowest, hn::MulAdd(nearer_end, tangent, margin))) << i;
  }
  return ~outside & ((std::uint64_t{1} << near.leaves) - 1);
}

HWY_INLINE bool is_excluded(const CandidateSearch& search, const View& view, const ScaledEdge& edge, Index p, Index q) {
  if (edge.square <= kMinSquare) return false;
  const NearPoints& near = search.near;
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  Blocking blocking;
  for (std::uint64_t leaves = leaves_at(near, view, edge); leaves != 0; leaves &= leaves - 1) {
    const int leaf = __builtin_ctzll(leaves);
    const int end = (leaf + 1) * static_cast<int>(KdOrder::kMaxLeaf);
    for (int i = leaf * static_cast<int>(KdOrder::kMaxLeaf); i < end; i += lanes) {
      add_near_points(search, view, edge, i, p, q, blocking);
    }
    if (blocking.on_edge || (blocking.left && blocking.right)) return true;
  }
  return false;
}

// The dead distances at these offsets from the first code.
HWY_INLINE VectorF dead_distances(const std::uint16_t* codes, VectorI offset) {
  const auto bytes = hn::ShiftLeft<1>(offset);
  const auto pair = hn::GatherOffset(kInt, reinterpret_cast<const std::int32_t*>(codes), bytes);
  return hn::BitCast(kFloat, hn::ShiftLeft<16>(pair));
}

// The points of a leaf as structure of arrays. Places past the last one are NaN and so never part of a candidate.
struct Partners {
  alignas(64) double x[KdOrder::kMaxLeaf];
  alignas(64) double y[KdOrder::kMaxLeaf];
  alignas(64) float farthest[KdOrder::kMaxLeaf];
  int count;

  Partners(Points points, const PartnerLeaf& leaf) : count(static_cast<int>(leaf.dead.size())) {
    std::fill(std::begin(x), std::end(x), std::numeric_limits<double>::quiet_NaN());
    std::fill(std::begin(y), std::end(y), std::numeric_limits<double>::quiet_NaN());
    std::fill(std::begin(farthest), std::end(farthest), 0.0F);
    for (Index i = 0; i < leaf.dead.size(); ++i) {
      x[i] = points[leaf.first + i].x;
      y[i] = points[leaf.first + i].y;
      farthest[i] = distance_of(leaf.dead[i].farthest());
    }
  }
};

// Edges that no direction excludes. Codes have 8 significant bits: the square of one is exact (or infinite).
HWY_INLINE hn::Mask<Float> is_within_farthest(const DeadDistances& of_p, const float* partners, VectorF square) {
  const auto here = hn::Set(kFloat, distance_of(of_p.farthest()));
  const auto farthest = hn::Min(here, hn::Load(kFloat, partners));
  return hn::Or(hn::Lt(square, hn::Mul(farthest, farthest)), hn::Le(square, hn::Set(kFloat, kMinSquare)));
}

// Edges from p to the partners from `place` on.
HWY_INLINE hn::Mask<Float> is_within_dead_distances(const DeadDistances& of_p,
                                                    std::span<const DeadDistances> of_partners, int place, VectorF dx,
                                                    VectorF dy, VectorF square) {
  // NaN lanes convert to any integer: clamp.
  const auto bin =
      hn::Min(hn::Max(wrapped_bin(bin_position(dx, dy)), hn::Zero(kInt)), hn::Set(kInt, kDirectionBins - 1));
  const auto half = hn::Set(kInt, kDirectionBins / 2);
  const auto opposite = hn::IfThenElse(hn::Lt(bin, half), hn::Add(bin, half), hn::Sub(bin, half));
  const auto row = hn::Min(hn::Iota(kInt, place), hn::Set(kInt, static_cast<int>(of_partners.size()) - 1));
  const auto here = dead_distances(of_p.code.data(), bin);
  const auto there = dead_distances(of_partners[0].code.data(), hn::Add(hn::ShiftLeft<6>(row), opposite));
  const auto is_close = hn::Lt(hn::Sqrt(square), hn::Min(here, there));
  return hn::Or(is_close, hn::Le(square, hn::Set(kFloat, kMinSquare)));
}

std::size_t AppendCandidates(const CandidateSearch& search, const PartnerLeaf& leaf, CandidatePair* out) {
  const NearPoints& near = search.near;
  const Partners partners(search.points, leaf);
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  CandidatePair* const begin = out;
  View view;
  for (int place = 0; place < near.leaf_size; ++place) {
    if ((leaf.open >> place & 1U) == 0) continue;
    const Index p = search.leaf_first + static_cast<Index>(place);
    const DeadDistances& dead = search.dead[static_cast<std::size_t>(place)];
    bool has_view = false;
    for (int i = 0; i < partners.count; i += lanes) {
      const auto dx = scaled_difference(partners.x + i, search.points[p].x, near.scale);
      const auto dy = scaled_difference(partners.y + i, search.points[p].y, near.scale);
      const auto square = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
      if (hn::AllFalse(kFloat, is_within_farthest(dead, partners.farthest + i, square))) continue;
      const auto alive = is_within_dead_distances(dead, leaf.dead, i, dx, dy, square);
      if (hn::AllFalse(kFloat, alive)) continue;
      if (!std::exchange(has_view, true)) look_around(near, place, view);
      alignas(64) float dx_of[16], dy_of[16], square_of[16];
      hn::Store(dx, kFloat, dx_of);
      hn::Store(dy, kFloat, dy_of);
      hn::Store(square, kFloat, square_of);
      for (std::uint64_t bits = bits_of(alive); bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctzll(bits);
        const Index q = leaf.first + static_cast<Index>(i + lane);
        if (q <= p || q >= leaf.last()) continue;
        if (!is_excluded(search, view, {dx_of[lane], dy_of[lane], square_of[lane]}, p, q)) *out++ = {p, q};
      }
    }
  }
  return static_cast<std::size_t>(out - begin);
}

void ComputeDeadDistancesPlainly(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
  ScalarDiamondTest<MachineRounding>::compute_dead_distances(near, of_leaf_points);
}

std::size_t AppendCandidatesPlainly(const CandidateSearch& search, const PartnerLeaf& partners, CandidatePair* out) {
  return ScalarDiamondTest<MachineRounding>::append_candidates(search, partners, out);
}

}  // namespace HWY_NAMESPACE
}  // namespace mwt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mwt {

HWY_EXPORT(ComputeDeadDistances);
HWY_EXPORT(AppendCandidates);
HWY_EXPORT(ComputeDeadDistancesPlainly);
HWY_EXPORT(AppendCandidatesPlainly);

void compute_dead_distances(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
  HWY_DYNAMIC_DISPATCH(ComputeDeadDistances)(near, of_leaf_points);
}

std::size_t append_candidates(const CandidateSearch& search, const PartnerLeaf& partners, CandidatePair* out) {
  return HWY_DYNAMIC_DISPATCH(AppendCandidates)(search, partners, out);
}

void compute_dead_distances_plainly(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
  HWY_DYNAMIC_DISPATCH(ComputeDeadDistancesPlainly)(near, of_leaf_points);
}

std::size_t append_candidates_plainly(const CandidateSearch& search, const PartnerLeaf& partners, CandidatePair* out) {
  return HWY_DYNAMIC_DISPATCH(AppendCandidatesPlainly)(search, partners, out);
}

}  // namespace mwt
#endif
