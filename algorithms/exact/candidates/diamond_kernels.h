// The diamond test's inner loops, on vectors: compiled once per instruction set, of which the program picks one when it
// runs (Google Highway). diamond_scalar.h is the same algorithm in plain loops.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "algorithms/exact/candidates/direction_bins.h"
#include "algorithms/exact/candidates/kd_order.h"

namespace mwt {

/// Shorter scaled distances are too short for the diamond test: such near points block nothing, such edges are kept,
/// and such boxes of the tree count as touching.
///
/// Scaled coordinates (see NearPoints::scale) are at most 2^61, so that no sum of their products exceeds 2^125 in
/// floats. At this distance and above, vectors err by 2^-24 of their length from rounding to float and by 2^-150 where
/// a component underflows, 2^-95 of that length; products of two components by 2^-24 of the square and by 2^-150,
/// 2^-40 of it. All margins of the test are relative to lengths and squares, and above 2^-20 of them.
inline constexpr float kMinDistance = 0x1p-55F;

/// Per direction bin, the distance beyond which no edge of a minimum weight triangulation leaves a point (or any point
/// of a tree node): the upper halves of floats, rounded up. Distances are in scaled units (see NearPoints::scale).
struct alignas(64) DeadDistances {
  static constexpr std::size_t kFarthest = kDirectionBins;

  std::array<std::uint16_t, 64> code{};  ///< by bin; then, at kFarthest, the largest of all

  [[nodiscard]] std::uint16_t farthest() const { return code[kFarthest]; }
};

/// The points near a leaf: those of the closest leaves, nearest first, starting with the leaf itself. Each near leaf
/// takes kMaxLeaf places, unused ones filled with NaN, which blocks nothing.
struct NearPoints {
  static constexpr int kLeaves = 14;
  static constexpr int kCapacity = kLeaves * static_cast<int>(KdOrder::kMaxLeaf);
  static constexpr int kSampleCapacity = 1024;
  static constexpr int kBoxes = 16;  ///< kLeaves, up to whole vectors

  double scale = 1;  ///< power of two that brings the instance's extent near 2^60, so that squares of floats keep range
  int leaf_size = 0;  ///< points of the leaf itself: the first places
  int leaves = 0;
  int samples = 0;                        ///< further points, sparse ones from far away: placed after the near leaves
  std::array<float, kLeaves> distance{};  ///< scaled lower bound of the distance of each near leaf's box
  /// The near leaves' boxes: centers, and what reaches from there to all points of the leaf, scaled and rounded up.
  alignas(64) std::array<double, kBoxes> center_x{}, center_y{};
  alignas(64) std::array<float, kBoxes> half_x{}, half_y{};
  alignas(64) std::array<double, kCapacity + kSampleCapacity> x{};
  alignas(64) std::array<double, kCapacity + kSampleCapacity> y{};

  [[nodiscard]] int places() const { return leaves * static_cast<int>(KdOrder::kMaxLeaf) + samples; }
};

/// An edge that may be in a minimum weight triangulation, smaller index first.
struct CandidatePair {
  Index p;
  Index q;
};

/// Fills the dead distances of the leaf's own points from the near points and samples.
void compute_dead_distances(const NearPoints& near, std::span<DeadDistances> of_leaf_points);

/// What append_candidates reads.
struct CandidateSearch {
  Points points;
  const NearPoints& near;
  Index leaf_first;                     ///< the leaf's points are leaf_first .. leaf_first + near.leaf_size
  std::span<const DeadDistances> dead;  ///< of the leaf's points
};

/// A leaf whose points are the other ends: first .. first + dead.size().
struct PartnerLeaf {
  Index first;
  std::span<const DeadDistances> dead;
  std::uint32_t open = ~0U;  ///< the points p, by their place in their leaf, that may have edges to it

  [[nodiscard]] Index last() const { return first + static_cast<Index>(dead.size()); }
};

/// Writes all pairs (p of the leaf, q of the partner leaf, p < q) that neither end's dead distances nor the near points
/// exclude by the diamond test, and that no near point occludes (lies on). Returns how many; `out` must have room for
/// all pairs.
std::size_t append_candidates(const CandidateSearch& search, const PartnerLeaf& partners, CandidatePair* out);

/// For tests: the same by the loops of diamond_scalar.h, with the rounding of the instruction set in use.
void compute_dead_distances_plainly(const NearPoints& near, std::span<DeadDistances> of_leaf_points);
std::size_t append_candidates_plainly(const CandidateSearch& search, const PartnerLeaf& partners, CandidatePair* out);

}  // namespace mwt
