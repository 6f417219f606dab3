// The diamond test's inner loops, one point at a time: the definition of what diamond_kernels.cpp computes on vectors,
// function by function under the same names. `Rounding` is as in float_rounding.h.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "algorithms/exact/candidates/diamond_kernels.h"
#include "algorithms/exact/candidates/float_rounding.h"
#include "geometry/predicates.h"

namespace mwt {

/// Vectors no longer than this are too short for the diamond test.
inline constexpr float kMinSquare = kMinDistance * kMinDistance;

/// The tests compare products of an edge's vector with vectors of up to two edge lengths; their rounding errors are
/// under 1e-6 of the edge's square. This share of the square is the margin.
inline constexpr float kProductMargin = 4e-6F;

/// Makes a rounded length an upper bound, with room for the rounding of the boxes' distances that it is compared with.
inline constexpr float kLengthRoundUp = 1.0001F;

/// The difference of two coordinates, subtracted in double, in scaled units.
[[nodiscard]] inline float scaled_difference(double coordinate, double origin, double scale) {
  return static_cast<float>((coordinate - origin) * scale);
}

/// The distance that a code of DeadDistances encodes, and the code of a distance, rounded up.
[[nodiscard]] inline float distance_of(std::uint16_t code) { return std::bit_cast<float>(std::uint32_t{code} << 16); }
[[nodiscard]] inline std::uint16_t code_above(float distance) {
  return static_cast<std::uint16_t>((std::bit_cast<std::uint32_t>(distance) + 0xFFFF) >> 16);
}

/// Squared distance of the nearest blocking point per bin, with the bins around the first and the last one repeated.
struct NearestPerBin {
  static constexpr int kMargin = 8;                                    ///< >= kBlockingBins
  static constexpr int kDustbin = kMargin + kDirectionBins + kMargin;  ///< place of points that do not block
  static_assert(kMargin >= kBlockingBins);

  alignas(64) float square[kDustbin + 24];  ///< vectors may read past the end

  [[nodiscard]] float* of_bin(int bin) { return square + kMargin + bin; }
  [[nodiscard]] const float* of_bin(int bin) const { return square + kMargin + bin; }

  void clear() { std::fill(std::begin(square), std::end(square), std::numeric_limits<float>::infinity()); }
  void repeat_around_the_circle() {
    std::copy_n(of_bin(kDirectionBins - kMargin), kMargin, of_bin(-kMargin));
    std::copy_n(of_bin(0), kMargin, of_bin(kDirectionBins));
  }
};

/// An edge's vector and its square, in scaled units.
struct ScaledEdge {
  float x;
  float y;
  float square;
};

/// The near points, seen from one point of the leaf, in scaled units, and the centers of the near leaves' boxes.
struct View {
  alignas(64) float x[NearPoints::kCapacity];
  alignas(64) float y[NearPoints::kCapacity];
  alignas(64) float center_x[NearPoints::kBoxes];
  alignas(64) float center_y[NearPoints::kBoxes];
};

/// Which triangles of an edge are known to hold a near point, and whether one lies on the edge.
struct Blocking {
  bool left = false;
  bool right = false;
  bool on_edge = false;
};

/// Adds what a near point does that floats see too close to the line through edge pq. `is_low`: it surely lies under
/// the roof of the triangle on its side, whichever side that is.
inline void add_exactly(const CandidateSearch& search, std::size_t place, bool is_low, Index p, Index q,
                        Blocking& blocking) {
  const Point point{search.near.x[place], search.near.y[place]};
  const int side = orientation(search.points[p], search.points[q], point);
  blocking.left |= is_low && side > 0;
  blocking.right |= is_low && side < 0;
  blocking.on_edge |= side == 0 && in_segment_interior(point, search.points[p], search.points[q]);
}

template <class Rounding>
class ScalarDiamondTest {
 public:
  static void compute_dead_distances(const NearPoints& near, std::span<DeadDistances> of_leaf_points) {
    NearestPerBin nearest;
    for (int place = 0; place < near.leaf_size; ++place) {
      find_nearest_per_bin(near, static_cast<std::size_t>(place), nearest);
      store_dead_distances(nearest, of_leaf_points[static_cast<std::size_t>(place)]);
    }
  }

  static std::size_t append_candidates(const CandidateSearch& search, const PartnerLeaf& partners, CandidatePair* out) {
    CandidatePair* const begin = out;
    View view;
    for (int place = 0; place < search.near.leaf_size; ++place) {
      if ((partners.open >> place & 1U) == 0) continue;
      const Index p = search.leaf_first + static_cast<Index>(place);
      look_around(search.near, static_cast<std::size_t>(place), view);
      for (Index q = std::max(partners.first, p + 1); q < partners.last(); ++q) {
        const ScaledEdge edge = scaled_edge(search, p, q);
        const DeadDistances& dead_of_q = partners.dead[q - partners.first];
        if (is_within_dead_distances(search.dead[static_cast<std::size_t>(place)], dead_of_q, edge) &&
            !is_excluded(search, view, edge, p, q))
          *out++ = {p, q};
      }
    }
    return static_cast<std::size_t>(out - begin);
  }

 private:
  static float square_of(float x, float y) { return Rounding::multiply_add(x, x, y * y); }

  static int bin_of(float x, float y) { return static_cast<int>(bin_position<Rounding>(x, y)) % kDirectionBins; }

  static void find_nearest_per_bin(const NearPoints& near, std::size_t place, NearestPerBin& nearest) {
    nearest.clear();
    for (std::size_t i = 0; i < static_cast<std::size_t>(near.places()); ++i) {
      const float dx = scaled_difference(near.x[i], near.x[place], near.scale);
      const float dy = scaled_difference(near.y[i], near.y[place], near.scale);
      const float square = square_of(dx, dy);
      if (!(square > kMinSquare)) continue;  // the point itself, one too near, or an unused place
      const float position = bin_position<Rounding>(dx, dy);
      const float within = position - std::floor(position);
      const bool blocks = within > kBinGuard && within < 1 - kBinGuard;
      if (!blocks) continue;
      float& known = *nearest.of_bin(static_cast<int>(position) % kDirectionBins);
      known = std::min(known, square);
    }
    nearest.repeat_around_the_circle();
  }

  // Beyond the larger of what blocks on the left and on the right, no edge survives.
  static void store_dead_distances(const NearestPerBin& nearest, DeadDistances& dead) {
    std::uint16_t farthest = 0;
    for (int bin = 0; bin < kDirectionBins; ++bin) {
      const float* const here = nearest.of_bin(bin);
      float left = std::numeric_limits<float>::infinity(), right = left;
      for (int j = 1; j <= kBlockingBins; ++j) {
        const float factor = kBlockingFactor[static_cast<std::size_t>(j)];
        left = std::min(left, here[j] * (factor * factor));
        right = std::min(right, here[-j] * (factor * factor));
      }
      const std::uint16_t code = code_above(std::sqrt(std::max(left, right)));
      dead.code[static_cast<std::size_t>(bin)] = code;
      farthest = std::max(farthest, code);
    }
    dead.code[DeadDistances::kFarthest] = farthest;
  }

  static void look_around(const NearPoints& near, std::size_t place, View& view) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(near.leaves) * KdOrder::kMaxLeaf; ++i) {
      view.x[i] = scaled_difference(near.x[i], near.x[place], near.scale);
      view.y[i] = scaled_difference(near.y[i], near.y[place], near.scale);
    }
  }

  static ScaledEdge scaled_edge(const CandidateSearch& search, Index p, Index q) {
    const float x = scaled_difference(search.points[q].x, search.points[p].x, search.near.scale);
    const float y = scaled_difference(search.points[q].y, search.points[p].y, search.near.scale);
    return {x, y, square_of(x, y)};
  }

  // Edges too short for the test count as within.
  static bool is_within_dead_distances(const DeadDistances& of_p, const DeadDistances& of_q, const ScaledEdge& edge) {
    if (edge.square <= kMinSquare) return true;
    const int bin = bin_of(edge.x, edge.y), opposite = (bin + kDirectionBins / 2) % kDirectionBins;
    const float here = distance_of(of_p.code[static_cast<std::size_t>(bin)]);
    const float there = distance_of(of_q.code[static_cast<std::size_t>(opposite)]);
    return std::sqrt(edge.square) < std::min(here, there);
  }

  // Whether both triangles of the edge are occupied, or a near point lies on it; never for edges too short to say. Near
  // leaves farther away than the edge is long cannot matter.
  static bool is_excluded(const CandidateSearch& search, const View& view, const ScaledEdge& edge, Index p, Index q) {
    if (edge.square <= kMinSquare) return false;
    const float length = std::sqrt(edge.square) * kLengthRoundUp;
    Blocking blocking;
    for (int leaf = 0; leaf < search.near.leaves; ++leaf) {
      if (!(search.near.distance[static_cast<std::size_t>(leaf)] < length)) break;
      for (std::size_t i = 0; i < KdOrder::kMaxLeaf; ++i) {
        add_near_point(search, view, edge, static_cast<std::size_t>(leaf) * KdOrder::kMaxLeaf + i, p, q, blocking);
      }
      if (blocking.on_edge || (blocking.left && blocking.right)) return true;
    }
    return false;
  }

  static void add_near_point(const CandidateSearch& search, const View& view, const ScaledEdge& edge, std::size_t place,
                             Index p, Index q, Blocking& blocking) {
    constexpr auto kTangent = static_cast<float>(kTangentOfDiamondAngle);
    const float x = view.x[place], y = view.y[place], margin = kProductMargin * edge.square;
    const float along = Rounding::multiply_add(edge.x, x, edge.y * y);    // from p, times the edge's length
    const float height = Rounding::multiply_add(-edge.y, x, edge.x * y);  // above the edge, times its length
    const float nearer_end = std::min(along, edge.square - along);
    const float roof = nearer_end * kTangent - margin;
    blocking.left |= height > margin && height < roof;
    blocking.right |= -height > margin && -height < roof;
    const bool is_unsure = std::abs(height) <= margin && nearer_end > 0;
    // Twice the margin under the roof: the error of the height does not matter there.
    if (is_unsure) add_exactly(search, place, roof > margin, p, q, blocking);
  }
};

}  // namespace mwt
