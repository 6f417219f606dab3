// Stars: the candidate edges around each vertex, dense in memory, as the LMT stage works on them.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// One vertex's halfedges as structure of arrays: four rows of `capacity` words, of which the first `count` are in use.
/// Row 0: the other end, ascending. Rows 1, 2: the vector to it (see component()). Row 3: the edge's certificate, as
/// the positions in this star of its left and right apex (16 bits each).
struct Star {
  static constexpr std::uint32_t kNoCertificate = std::numeric_limits<std::uint32_t>::max();
  /// Positions fit into 16 bits; edges at larger stars are left as they are.
  static constexpr std::uint32_t kMaximumCount = 60000;
  /// So are edges between two stars larger than this: where long chains face each other nearly every edge has a
  /// certificate, and looking for them all takes cubic time.
  static constexpr std::uint32_t kWorthExamining = 512;

  /// A component of a vector: the difference of two coordinates times the scale (distance_scale() in near_points.h), as
  /// a float. Exact zeros stay; what is smaller than kMinComponent otherwise is not a number: no comparison with
  /// it holds, so none decides anything.
  ///
  /// So each component errs by 2^-24 of itself at most, and products of two are 0 or between 2^-100 and 2^123: sums of
  /// a few of them keep relative error bounds, as do margins down to 2^-26 of such products, which are normal numbers
  /// (at least 2^-126). The difference of two components may be as small as 2^-74, and products of two of these may
  /// underflow by 2^-150, which is nothing to a margin that is relative to the components' own squares.
  static constexpr float kMinComponent = 0x1p-50F;
  [[nodiscard]] static float component(double difference, double scale) {
    const double scaled = difference * scale;
    const bool is_lost = std::abs(scaled) < kMinComponent && difference != 0;
    return is_lost ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(scaled);
  }

  std::uint32_t* words = nullptr;
  std::uint32_t count = 0;
  std::uint32_t capacity = 0;

  [[nodiscard]] std::uint32_t* target() const { return words; }
  [[nodiscard]] float* x() const { return reinterpret_cast<float*>(words + capacity); }
  [[nodiscard]] float* y() const { return reinterpret_cast<float*>(words + 2 * std::size_t{capacity}); }
  [[nodiscard]] std::uint32_t* certificate() const { return words + 3 * std::size_t{capacity}; }

  [[nodiscard]] static std::size_t words_for(std::uint32_t capacity) { return 4 * std::size_t{capacity}; }
};

/// The stars of all vertices, and the memory behind them: one arena per block of vertices. Vectors may read up to
/// kSlack words past a star's end, but never write there.
struct StarTable {
  static constexpr std::size_t kSlack = 64;

  std::vector<Star> stars;
  std::vector<std::vector<std::uint32_t>> arenas;
};

}  // namespace mwt
