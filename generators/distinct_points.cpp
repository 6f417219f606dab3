#include "generators/distinct_points.h"

#include <bit>

#include "generators/random.h"
#include "geometry/error.h"

namespace mwt {

DistinctPoints::DistinctPoints(Index expected_count)
    : slots_(std::bit_ceil(std::size_t{2} * expected_count + 1), kNoIndex) {
  points_.reserve(expected_count);
}

bool DistinctPoints::insert(Point p) {
  p = {p.x + 0.0, p.y + 0.0};  // -0 + 0 = 0: one zero only
  const std::uint64_t hash =
      scatter_bits(scatter_bits(std::bit_cast<std::uint64_t>(p.x)) ^ std::bit_cast<std::uint64_t>(p.y));
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash & mask;
  while (slots_[slot] != kNoIndex) {
    if (points_[slots_[slot]] == p) return false;
    slot = (slot + 1) & mask;
  }
  slots_[slot] = size();
  points_.push_back(p);
  return true;
}

DrawingBudget::DrawingBudget(std::string family, Index n)
    : family_(std::move(family)), n_(n), left_(std::uint64_t{100} * n + 1'000'000) {}

void DrawingBudget::spend_one(Index found) {
  if (left_-- > 0) return;
  throw InputError(family_ + ": with these parameters doubles carry no n=" + std::to_string(n_) +
                   " distinct points off one line; the search ended at " + std::to_string(found) +
                   ": choose a smaller n or spread the points wider");
}

}  // namespace mwt
