#include "algorithms/exact/candidates/diamond_kernels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/predicates.h"

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

constexpr float kMinSquare = kMinDistance * kMinDistance;

// scale * (coordinates[i] - origin) for one vector of places, subtracted in double.
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

// Position of direction (x, y) on the circle of bins, in [0, kDirectionBins]; anything for the zero vector or NaN.
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

// Squared distance of the nearest blocking point per bin, with kBlockingBins of the circle repeated before and after.
struct NearestPerBin {
  static constexpr int kMargin = 8;  // >= kBlockingBins
  static constexpr int kDustbin = kMargin + kDirectionBins + kMargin;
  alignas(64) float square[kDustbin + 24];
};

HWY_INLINE void find_nearest_per_bin(const NearPoints& near, int place, NearestPerBin& nearest) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::fill(std::begin(nearest.square), std::end(nearest.square), kInfinity);
  alignas(64) float squares[16];
  alignas(64) std::int32_t bins[16];
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  const double px = near.x[static_cast<std::size_t>(place)], py = near.y[static_cast<std::size_t>(place)];
  float* const bin_square = nearest.square + NearestPerBin::kMargin;
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
  for (int i = 0; i < NearestPerBin::kMargin; ++i) {
    nearest.square[i] = bin_square[kDirectionBins - NearestPerBin::kMargin + i];
    bin_square[kDirectionBins + i] = bin_square[i];
  }
}

// dead = the larger of what blocks on the left and on the right, as upper half of a float, rounded up.
HWY_INLINE void store_dead_distances(const NearestPerBin& nearest, DeadDistances& dead) {
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  alignas(64) std::uint32_t codes[64];
  for (int bin = 0; bin < kDirectionBins; bin += lanes) {
    const float* const here = nearest.square + NearestPerBin::kMargin + bin;
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
  for (std::size_t bin = 0; bin < kDirectionBins; ++bin) dead.code[bin] = static_cast<std::uint16_t>(codes[bin]);
}

void ComputeDeadDistances(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
  NearestPerBin nearest;
  for (int place = 0; place < near.leaf_size; ++place) {
    find_nearest_per_bin(near, place, nearest);
    store_dead_distances(nearest, of_leaf_points[static_cast<std::size_t>(place)]);
  }
}

// The near points seen from one point p of the leaf.
struct View {
  alignas(64) float x[NearPoints::kCapacity];
  alignas(64) float y[NearPoints::kCapacity];
};

HWY_INLINE void look_around(const NearPoints& near, int place, View& view) {
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  const double px = near.x[static_cast<std::size_t>(place)], py = near.y[static_cast<std::size_t>(place)];
  for (int i = 0; i < near.leaves * static_cast<int>(KdOrder::kMaxLeaf); i += lanes) {
    hn::Store(scaled_difference(near.x.data() + i, px, near.scale), kFloat, view.x + i);
    hn::Store(scaled_difference(near.y.data() + i, py, near.scale), kFloat, view.y + i);
  }
}

struct ScaledEdge {
  float x;
  float y;
  float square;
};

// What near points too close to the line through an edge for floats do to it.
struct ExactView {
  bool is_occluded = false;  // one of them lies on the edge
  bool blocks_left = false;
  bool blocks_right = false;
};

// `suspects`: lanes with points whose distance from the line through pq is uncertain; `low`: those of them that surely
// lie under the roof of the triangle on their side, whichever that is.
ExactView look_exactly(const CandidateSearch& search, int first_place, std::uint64_t suspects, std::uint64_t low,
                       Index p, Index q) {
  ExactView view;
  for (; suspects != 0 && !view.is_occluded; suspects &= suspects - 1) {
    const int lane = __builtin_ctzll(suspects);
    const auto place = static_cast<std::size_t>(first_place + lane);
    const Point point{search.near.x[place], search.near.y[place]};
    const int side = orientation(search.points[p], search.points[q], point);
    const bool is_low = ((low >> lane) & 1U) != 0;
    view.blocks_left |= is_low && side > 0;
    view.blocks_right |= is_low && side < 0;
    view.is_occluded = side == 0 && in_segment_interior(point, search.points[p], search.points[q]);
  }
  return view;
}

HWY_INLINE std::uint64_t bits_of(hn::Mask<Float> mask) {
  std::uint64_t bits = 0;
  hn::StoreMaskBits(kFloat, mask, reinterpret_cast<std::uint8_t*>(&bits));
  return bits & ((std::uint64_t{1} << hn::Lanes(kFloat)) - 1);
}

// Whether both triangles of the edge are occupied, or a near point lies on it; never for edges too short to say. Near
// leaves farther than the edge is long cannot matter.
HWY_INLINE bool is_excluded(const CandidateSearch& search, const View& view, const ScaledEdge& edge, Index p, Index q) {
  if (edge.square <= kMinSquare) return false;
  const NearPoints& near = search.near;
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  const auto ex = hn::Set(kFloat, edge.x), ey = hn::Set(kFloat, edge.y), square = hn::Set(kFloat, edge.square);
  // Rounding errors of the products below are under 1e-6 of the edge's square for points within two edge lengths.
  const auto margin = hn::Set(kFloat, 4e-6F * edge.square);
  const auto tangent = hn::Set(kFloat, static_cast<float>(kTangentOfDiamondAngle));
  const float length = std::sqrt(edge.square) * 1.0001F;
  auto left = hn::FirstN(kFloat, 0), right = left;
  bool blocks_left = false, blocks_right = false;
  for (int leaf = 0; leaf < near.leaves && near.distance[static_cast<std::size_t>(leaf)] < length; ++leaf) {
    const int end = (leaf + 1) * static_cast<int>(KdOrder::kMaxLeaf);
    for (int i = leaf * static_cast<int>(KdOrder::kMaxLeaf); i < end; i += lanes) {
      const auto x = hn::Load(kFloat, view.x + i), y = hn::Load(kFloat, view.y + i);
      const auto along = hn::MulAdd(ex, x, hn::Mul(ey, y));
      const auto height = hn::NegMulAdd(ey, x, hn::Mul(ex, y));
      const auto nearer_end = hn::Min(along, hn::Sub(square, along));
      const auto roof = hn::Sub(hn::Mul(nearer_end, tangent), margin);
      left = hn::Or(left, hn::And(hn::Gt(height, margin), hn::Lt(height, roof)));
      const auto depth = hn::Neg(height);
      right = hn::Or(right, hn::And(hn::Gt(depth, margin), hn::Lt(depth, roof)));
      const auto suspects = hn::And(hn::Le(hn::Abs(height), margin), hn::Gt(nearer_end, hn::Zero(kFloat)));
      if (hn::AllFalse(kFloat, suspects)) continue;
      // Twice the margin under the roof: what is uncertain about the height does not matter there.
      const ExactView exact = look_exactly(search, i, bits_of(suspects), bits_of(hn::Gt(roof, margin)), p, q);
      if (exact.is_occluded) return true;
      blocks_left |= exact.blocks_left;
      blocks_right |= exact.blocks_right;
    }
    blocks_left |= !hn::AllFalse(kFloat, left);
    blocks_right |= !hn::AllFalse(kFloat, right);
    if (blocks_left && blocks_right) return true;
  }
  return false;
}

// Distances in bin of direction, for all lanes, from rows of codes.
HWY_INLINE VectorF dead_distance(const std::uint16_t* codes, VectorI offset) {
  const auto bytes = hn::ShiftLeft<1>(offset);
  const auto pair = hn::GatherOffset(kInt, reinterpret_cast<const std::int32_t*>(codes), bytes);
  return hn::BitCast(kFloat, hn::ShiftLeft<16>(pair));
}

std::size_t AppendCandidates(const CandidateSearch& search, Index first, Index last, CandidatePair* out) {
  const NearPoints& near = search.near;
  CandidatePair* const begin = out;
  const int lanes = static_cast<int>(hn::Lanes(kFloat));
  // The partners, as structure of arrays; lanes past the end are NaN and so never candidates.
  alignas(64) double x[16], y[16];
  const int partners = static_cast<int>(last - first);
  for (int i = 0; i < 16; ++i) {
    const bool exists = i < partners;
    x[i] = exists ? search.points[first + static_cast<Index>(i)].x : std::numeric_limits<double>::quiet_NaN();
    y[i] = exists ? search.points[first + static_cast<Index>(i)].y : std::numeric_limits<double>::quiet_NaN();
  }
  View view;
  for (int place = 0; place < near.leaf_size; ++place) {
    const Index p = search.leaf_first + static_cast<Index>(place);
    bool has_looked = false;
    for (int i = 0; i < partners; i += lanes) {
      const auto dx = scaled_difference(x + i, search.points[p].x, near.scale);
      const auto dy = scaled_difference(y + i, search.points[p].y, near.scale);
      const auto square = hn::MulAdd(dx, dx, hn::Mul(dy, dy));
      const auto distance = hn::Sqrt(square);
      // NaN lanes convert to any integer: clamp.
      const auto bin =
          hn::Min(hn::Max(wrapped_bin(bin_position(dx, dy)), hn::Zero(kInt)), hn::Set(kInt, kDirectionBins - 1));
      const auto opposite = hn::IfThenElse(hn::Lt(bin, hn::Set(kInt, kDirectionBins / 2)),
                                           hn::Add(bin, hn::Set(kInt, kDirectionBins / 2)),
                                           hn::Sub(bin, hn::Set(kInt, kDirectionBins / 2)));
      const auto row = hn::Min(hn::Iota(kInt, i), hn::Set(kInt, partners - 1));
      const auto dead_here = dead_distance(search.dead[p].code.data(), bin);
      const auto dead_there = dead_distance(search.dead[first].code.data(), hn::Add(hn::ShiftLeft<6>(row), opposite));
      const auto is_close = hn::Lt(distance, hn::Min(dead_here, dead_there));
      const auto is_tiny = hn::Le(square, hn::Set(kFloat, kMinSquare));
      const auto alive = hn::Or(is_close, is_tiny);
      if (hn::AllFalse(kFloat, alive)) continue;
      if (!has_looked) look_around(near, place, view);
      has_looked = true;
      alignas(64) float dx_of[16], dy_of[16], square_of[16];
      hn::Store(dx, kFloat, dx_of);
      hn::Store(dy, kFloat, dy_of);
      hn::Store(square, kFloat, square_of);
      for (std::uint64_t bits = bits_of(alive); bits != 0; bits &= bits - 1) {
        const int lane = __builtin_ctzll(bits);
        const Index q = first + static_cast<Index>(i + lane);
        if (q <= p || q >= last) continue;
        if (!is_excluded(search, view, {dx_of[lane], dy_of[lane], square_of[lane]}, p, q)) *out++ = {p, q};
      }
    }
  }
  return static_cast<std::size_t>(out - begin);
}

}  // namespace HWY_NAMESPACE
}  // namespace mwt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace mwt {

HWY_EXPORT(ComputeDeadDistances);
HWY_EXPORT(AppendCandidates);

void compute_dead_distances(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
  HWY_DYNAMIC_DISPATCH(ComputeDeadDistances)(near, of_leaf_points);
}

std::size_t append_candidates(const CandidateSearch& search, Index first, Index last, CandidatePair* out) {
  return HWY_DYNAMIC_DISPATCH(AppendCandidates)(search, first, last, out);
}

}  // namespace mwt
#endif
