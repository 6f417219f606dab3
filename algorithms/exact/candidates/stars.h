// Stars: the candidate edges around each vertex, dense in memory, as the LMT stage works on them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// One vertex's halfedges as structure of arrays: rows of `capacity` places, of which the first `count` are in use. Two
/// rows of words: the other end, ascending; and the edge's certificate, as the positions in this star of its left and
/// right apex (16 bits each). Two rows of components: the vector to the other end (see component()).
struct Star {
  static constexpr std::uint32_t kNoCertificate = std::numeric_limits<std::uint32_t>::max();
  /// Positions fit into 16 bits; edges at larger stars are left as they are.
  static constexpr std::uint32_t kMaxCount = 60000;
  /// So are edges between two stars larger than this: where long chains face each other nearly every edge has a
  /// certificate, and looking for them all takes cubic time.
  static constexpr std::uint32_t kMaxExamined = 128;
  /// If points are left apart from others, edges are examined unless both stars are larger than this.
  static constexpr std::uint32_t kMaxExaminedAtLast = 512;

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
  float* components = nullptr;
  std::uint32_t count = 0;
  std::uint32_t capacity = 0;

  [[nodiscard]] std::uint32_t* target() const { return words; }
  [[nodiscard]] std::uint32_t* certificate() const { return words + capacity; }
  [[nodiscard]] float* x() const { return components; }
  [[nodiscard]] float* y() const { return components + capacity; }

  [[nodiscard]] std::span<const std::uint32_t> targets() const { return {words, count}; }

  /// Precondition: count < capacity.
  void append(std::uint32_t to, float dx, float dy) {
    target()[count] = to;
    certificate()[count] = kNoCertificate;
    x()[count] = dx;
    y()[count] = dy;
    ++count;
  }

  /// Takes one halfedge out and moves those after it up by one place. Certificates keep their positions.
  void erase(std::uint32_t position) {
    const auto close_gap = [&](auto* row) { std::copy(row + position + 1, row + count, row + position); };
    close_gap(target());
    close_gap(certificate());
    close_gap(x());
    close_gap(y());
    --count;
  }
};

/// Memory for the stars of some vertices. Vectors may read up to kSlack places past a star's rows, but never write
/// there.
class StarArena {
 public:
  static constexpr std::size_t kSlack = 64;

  StarArena() = default;
  explicit StarArena(std::size_t halfedges) { reset(halfedges); }

  /// Empties the arena and makes room: in the same memory, if that is large enough.
  void reset(std::size_t halfedges) {
    words_.resize(std::max(words_.size(), 2 * halfedges + kSlack));
    components_.resize(words_.size());
    used_ = 0;
  }

  /// An empty star with room for `capacity` halfedges. Precondition: all stars together have no more than the arena.
  [[nodiscard]] Star allot(std::uint32_t capacity) {
    const std::size_t place = std::exchange(used_, used_ + 2 * std::size_t{capacity});
    return {words_.data() + place, components_.data() + place, 0, capacity};
  }

 private:
  std::vector<std::uint32_t> words_;
  std::vector<float> components_;
  std::size_t used_ = 0;
};

/// A copy of the star that has no room to grow.
[[nodiscard]] inline Star compact_copy(const Star& star, StarArena& arena) {
  Star copy = arena.allot(star.count);
  copy.count = star.count;
  std::copy_n(star.target(), star.count, copy.target());
  std::copy_n(star.certificate(), star.count, copy.certificate());
  std::copy_n(star.x(), star.count, copy.x());
  std::copy_n(star.y(), star.count, copy.y());
  return copy;
}

/// The stars of all vertices, and the memory behind them: one arena per block of vertices.
struct StarTable {
  std::vector<Star> stars;
  std::vector<StarArena> arenas;
};

}  // namespace mwt
