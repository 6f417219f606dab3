// Stars: the candidate edges around each vertex, dense in memory, as the LMT stage works on them.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// One vertex's halfedges as structure of arrays: four rows of `capacity` words, of which the first `count` are in use.
/// Row 0: the other end, ascending. Rows 1, 2: the vector to it (floats, scaled; subtracted in double, so relatively
/// precise at every distance). Row 3: the edge's certificate, as the positions in this star of its left and right apex
/// (16 bits each).
struct Star {
  static constexpr std::uint32_t kNoCertificate = std::numeric_limits<std::uint32_t>::max();
  /// Positions fit into 16 bits; edges at larger stars are left as they are.
  static constexpr std::uint32_t kMaximumCount = 60000;
  /// So are edges between two stars larger than this: where long chains face each other nearly every edge has a
  /// certificate, and looking for them all takes cubic time.
  static constexpr std::uint32_t kWorthExamining = 512;

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
