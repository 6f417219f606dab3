#include "geometry/mesh/spatial_order.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "geometry/mesh/radix_sort.h"

namespace mwt {

namespace {

// A cell of the curve visits its four quadrants (numbered x + 2 y) in an order that depends on its state, and each
// quadrant is a cell in a state of its own.
constexpr int kStates = 4;
struct Quadrant {
  std::uint8_t place;  // when this quadrant is visited: 0 .. 3
  std::uint8_t state;  // how it is visited
};
constexpr Quadrant kCurve[kStates][4] = {
    {{0, 1}, {3, 2}, {1, 0}, {2, 0}},  // up, right, down
    {{0, 0}, {1, 1}, {3, 3}, {2, 1}},  // right, up, left
    {{2, 2}, {3, 0}, {1, 2}, {0, 3}},  // left, down, right
    {{2, 3}, {1, 3}, {3, 1}, {0, 2}},  // down, left, up
};

// Four steps of the curve at once: indexed by state, 4 bits of x, 4 bits of y.
constexpr int kStepBits = 4;
struct FourSteps {
  std::uint8_t place;
  std::uint8_t state;
};

constexpr std::array<FourSteps, kStates << (2 * kStepBits)> make_steps() {
  std::array<FourSteps, kStates << (2 * kStepBits)> steps{};
  for (unsigned i = 0; i < steps.size(); ++i) {
    const unsigned x = (i >> kStepBits) & 15U, y = i & 15U;
    unsigned state = i >> (2 * kStepBits), place = 0;
    for (int bit = kStepBits - 1; bit >= 0; --bit) {
      const Quadrant quadrant = kCurve[state][((x >> bit) & 1U) + 2 * ((y >> bit) & 1U)];
      place = 4 * place + quadrant.place;
      state = quadrant.state;
    }
    steps[i] = {static_cast<std::uint8_t>(place), static_cast<std::uint8_t>(state)};
  }
  return steps;
}

constexpr auto kSteps = make_steps();
constexpr int kGridBits = 16;  // cells per side of one level: 2^16

std::uint32_t hilbert_place(std::uint32_t x, std::uint32_t y) {
  std::uint32_t place = 0, state = 0;
  for (int bit = kGridBits - kStepBits; bit >= 0; bit -= kStepBits) {
    const FourSteps step = kSteps[(state << (2 * kStepBits)) | (((x >> bit) & 15U) << kStepBits) | ((y >> bit) & 15U)];
    place = (place << (2 * kStepBits)) | step.place;
    state = step.state;
  }
  return place;
}

// The bounding square of some points, as a map onto the grid's cells.
class Grid {
 public:
  Grid(Points points, std::span<const Index> members) {
    Point top{points[members[0]]};
    corner_ = top;
    for (const Index i : members) {
      corner_ = {std::min(corner_.x, points[i].x), std::min(corner_.y, points[i].y)};
      top = {std::max(top.x, points[i].x), std::max(top.y, points[i].y)};
    }
    half_side_ = std::max(top.x / 2 - corner_.x / 2, top.y / 2 - corner_.y / 2);  // halves: the side may overflow
    const double inverse = 0.5 / half_side_;
    multiply_ = half_side_ > kMinHalfSide && half_side_ < kMaxHalfSide;
    scale_ = multiply_ ? kLastCell * inverse : 0;
  }

  [[nodiscard]] std::uint32_t place(const Point& p) const {
    return hilbert_place(cell(p.x, corner_.x), cell(p.y, corner_.y));
  }

 private:
  static constexpr double kLastCell = (1 << kGridBits) - 1;
  // Between these neither the inverse, nor its multiple by kLastCell, nor the whole side overflows or is denormal.
  static constexpr double kMinHalfSide = 1e-290, kMaxHalfSide = 1e290;

  [[nodiscard]] std::uint32_t cell(double coordinate, double start) const {
    if (multiply_) return static_cast<std::uint32_t>(std::min((coordinate - start) * scale_, kLastCell));
    if (half_side_ == 0) return 0;
    const double share = (coordinate / 2 - start / 2) / half_side_;
    return static_cast<std::uint32_t>(std::clamp(share, 0.0, 1.0) * kLastCell);
  }

  Point corner_;
  double half_side_ = 0;
  double scale_ = 0;
  bool multiply_ = false;
};

constexpr std::size_t kSmallCell = 4;  // so few points stay as they are

class SpatialOrder {
 public:
  explicit SpatialOrder(Points points) : points_(points) {}

  // Orders `members` in place; cells that stay crowded are left in pending_.
  void arrange(std::span<Index> members) {
    const Grid grid(points_, members);
    keys_.resize(members.size());
    for (std::size_t i = 0; i < members.size(); ++i) {
      keys_[i] = (std::uint64_t{grid.place(points_[members[i]])} << 32) | members[i];
    }
    if (members.size() < 256) {
      std::sort(keys_.begin(), keys_.end());
    } else {
      radix_sort(keys_, 32, 64, buffer_);
    }
    for (std::size_t i = 0; i < members.size(); ++i) members[i] = static_cast<Index>(keys_[i]);
    collect_crowded_cells(members);
  }

  void run(std::span<Index> all) {
    pending_.push_back(all);
    while (!pending_.empty()) {
      const std::span<Index> members = pending_.back();
      pending_.pop_back();
      arrange(members);
    }
  }

 private:
  void collect_crowded_cells(std::span<Index> members) {
    for (std::size_t first = 0; first < members.size();) {
      std::size_t last = first + 1;
      while (last < members.size() && keys_[last] >> 32 == keys_[first] >> 32) ++last;
      const bool shrinks = last - first < members.size();  // always, except where doubles are too dense for halving
      if (last - first > kSmallCell && shrinks) pending_.push_back(members.subspan(first, last - first));
      first = last;
    }
  }

  Points points_;
  std::vector<std::span<Index>> pending_;
  KeptVector<std::uint64_t> keys_;
  KeptVector<std::uint64_t> buffer_;
};

}  // namespace

std::vector<Index> spatial_order(Points points) {
  std::vector<Index> order(points.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  if (!order.empty()) SpatialOrder(points).run(order);
  return order;
}

}  // namespace mwt
