#include "algorithms/polygon_dp/convex_program.h"

#include <algorithm>
#include <utility>

namespace mwt {

ConvexProgram::ConvexProgram(const ConvexChords& chords)
    : chords_(chords), band_(chords.size(), IntervalBand::full_reach(chords.size())) {}

std::uint64_t ConvexProgram::bytes(std::size_t n) { return IntervalBand::bytes(n, IntervalBand::full_reach(n)); }

bool ConvexProgram::run(const Deadline& deadline, const std::function<void(double)>& progress) {
  const std::size_t size = chords_.size();
  const auto costs_of_row = [&](std::size_t i, std::size_t first, RowCosts& costs) {
    chords_.lengths_from(i, first, costs.chords.data());
    costs.known.fill(kNoCost);
    if (i + 1 - first < kTile) costs.known[i + 1 - first] = 0;  // a side of the polygon
    if (i > 0) return;
    for (std::size_t j = first; j < std::min(size, first + kTile); ++j) {
      if (j > 1 && chords_.runs_along_side(j, size)) costs.chords[j - first] = kNoCost;
    }
    if (size - 1 - first < kTile) costs.chords[size - 1 - first] = 0;  // the last side
  };
  return band_.compute(costs_of_row, deadline, progress);
}

double ConvexProgram::diagonals_at_least() const {
  return chords_.true_length_at_least(band_.cost(0, chords_.size() - 1));
}

std::vector<Triangle> ConvexProgram::triangles() const {
  std::vector<Triangle> triangles;
  triangles.reserve(chords_.size() - 2);
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, chords_.size() - 1}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (j - i < 2) continue;
    const std::size_t k = band_.best_split(i, j);
    triangles.push_back({static_cast<Index>(i), static_cast<Index>(k), static_cast<Index>(j)});
    open.emplace_back(k, j);
    open.emplace_back(i, k);
  }
  return triangles;
}

}  // namespace mwt
