#include "generators/distinct_points.h"

#include <fmt/core.h>

#include <bit>

#include "base/error.h"
#include "generators/random.h"

namespace mwt {

DistinctPoints::DistinctPoints(Index capacity)
    : slots_(std::bit_ceil(std::size_t{capacity} + capacity / 3 + 1)) {  // at most 3/4 full
  points_.reserve(capacity);
}

bool DistinctPoints::insert(Point p) {
  p = {p.x + 0.0, p.y + 0.0};  // -0 + 0 = 0: one zero only
  const std::uint64_t hash =
      scatter_bits(scatter_bits(std::bit_cast<std::uint64_t>(p.x)) ^ std::bit_cast<std::uint64_t>(p.y));
  const auto hash_part = static_cast<std::uint32_t>(hash >> 32);  // the slot depends mostly on the other half
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash & mask;
  for (; slots_[i].position != kNoIndex; i = (i + 1) & mask) {
    if (slots_[i].hash == hash_part && points_[slots_[i].position] == p) return false;
  }
  slots_[i] = {hash_part, size()};
  points_.push_back(p);
  return true;
}

DrawingBudget::DrawingBudget(std::string family, Index n)
    : family_(std::move(family)), n_(n), left_(std::uint64_t{100} * n + 1'000'000) {}

void DrawingBudget::spend_one(Index found) {
  if (left_-- > 0) return;
  throw InputError(
      fmt::format("{}: with these parameters doubles carry no n={} distinct points off one line; the search ended at "
                  "{}: choose a smaller n or spread the points wider",
                  family_, n_, found));
}

}  // namespace mwt
