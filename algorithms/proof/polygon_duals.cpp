#include "algorithms/proof/polygon_duals.h"

#include <algorithm>
#include <cmath>

#include "algorithms/proof/half_length.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// The longest diagonal is to have so many bits in front of the point, but not more than the most.
constexpr int kUsualBits = 46, kMaxBits = 56;

// For each diagonal of a triangulation, the optimum is to have at least so many units: rounding costs less than 2.
constexpr double kMinUnitsPerDiagonal = 0x1p43;

}  // namespace

std::vector<std::array<std::uint32_t, 2>> diagonals_of_convex_polygon(Points points, std::span<const Index> corners) {
  const auto size = static_cast<std::uint32_t>(corners.size());
  const auto corner = [&](std::uint32_t i) -> const Point& { return points[corners[i % size]]; };
  // Corners along one side are joined to their neighbours only.
  const auto lie_on_one_side = [&](std::uint32_t i, std::uint32_t j) {
    return orientation(corner(i), corner(i + 1), corner(j)) == 0 ||
           orientation(corner(j), corner(j + 1), corner(i)) == 0;
  };
  std::vector<std::array<std::uint32_t, 2>> diagonals;
  for (std::uint32_t i = 0; i < size; ++i) {
    const std::uint32_t end = i == 0 ? size - 1 : size;
    for (std::uint32_t j = i + 2; j < end; ++j) {
      if (!lie_on_one_side(i, j)) diagonals.push_back({i, j});
    }
  }
  return diagonals;
}

std::optional<DualRegion> PolygonDuals::solve(Points points, std::span<const Index> corners,
                                              std::span<const std::array<std::uint32_t, 2>> diagonals,
                                              const Deadline& deadline, std::optional<int> unit_exponent) {
  diagonals_ = diagonals;
  measure(points, corners);
  lay_out_cells(corners.size());
  DualRegion region;
  int exponent = unit_exponent.value_or(0);
  const auto result = unit_exponent ? run(exponent, deadline) : run_in_good_unit(exponent, deadline);
  if (!result) return {};
  const std::int64_t optimum = *result;
  region.unit_exponent = exponent;
  region.places.assign(corners.begin(), corners.end());
  region.walk_sizes = {static_cast<std::uint32_t>(corners.size())};
  region.open_edges.assign(diagonals.begin(), diagonals.end());
  DualNode& leaf = region.tree.emplace_back();
  leaf.side_duals.assign(corners.size(), 0);
  leaf.edge_duals.assign(diagonals.size(), 0);
  if (optimum == kNever && !unit_exponent) return region;
  leaf.side_duals.back() = optimum;
  for (std::size_t i = 0; i < diagonals.size(); ++i) leaf.edge_duals[i] = -dual_[i];
  region.lower_bound = std::max(0.0, next_down(std::ldexp(static_cast<double>(optimum), region.unit_exponent)));
  return region;
}

void PolygonDuals::measure(Points points, std::span<const Index> corners) {
  points_.clear();
  for (const Index corner : corners) points_.push_back(points[corner]);
  lengths_.clear();
  longest_ = 0;
  for (const auto& [from, to] : diagonals_) {
    lengths_.push_back(length(points_[from], points_[to]));
    longest_ = std::max(longest_, lengths_.back().high);
  }
}

void PolygonDuals::lay_out_cells(std::size_t size) {
  first_.assign(size + 1, 0);
  backward_first_.assign(size + 1, 0);
  for (const auto& [from, to] : diagonals_) {
    ++first_[from + std::size_t{1}];
    ++backward_first_[to + std::size_t{1}];
  }
  for (std::size_t p = 1; p <= size; ++p) {
    first_[p] += first_[p - 1];
    backward_first_[p] += backward_first_[p - 1] + 1;  // and the side from the position before
  }
  backward_.resize(backward_first_.back());
  half_.resize(diagonals_.size());
  dual_.resize(diagonals_.size());
}

// Sets the exponent; returns the optimum in units, or kNever. Nothing if the deadline passes.
std::optional<std::int64_t> PolygonDuals::run_in_good_unit(int& exponent, const Deadline& deadline) {
  const double longest = diagonals_.empty() ? 1 : longest_;
  const int min_exponent = std::ilogb(longest) - kMaxBits;
  const double least = std::min(static_cast<double>(points_.size()) * kMinUnitsPerDiagonal, 0x1p56);
  exponent = std::ilogb(longest) - kUsualBits;
  std::optional<std::int64_t> optimum = run(exponent, deadline);
  for (int tries = 0; tries < 4 && optimum; ++tries) {
    const bool is_too_coarse = static_cast<double>(*optimum) < least && exponent > min_exponent;
    if (*optimum == kNever) {
      exponent += 6;
    } else if (is_too_coarse) {
      exponent =
          std::max(min_exponent, exponent - 1 - std::ilogb(least / std::max(1.0, static_cast<double>(*optimum))));
    } else {
      break;
    }
    optimum = run(exponent, deadline);
  }
  return optimum;
}

std::optional<std::int64_t> PolygonDuals::run(int unit_exponent, const Deadline& deadline) {
  for (std::size_t i = 0; i < half_.size(); ++i) {
    half_[i] = std::max<std::int64_t>(0, half_length(lengths_[i], unit_exponent));
  }
  row_value_.assign(points_.size(), kNever);
  backward_end_.assign(backward_first_.begin(), backward_first_.end() - 1);
  const auto last = static_cast<Position>(points_.size() - 1);
  constexpr std::size_t kCellsPerLook = 1024;
  std::size_t cells = 0;
  for (Position from = last; from-- > 0;) {
    cells += first_[from + std::size_t{1}] - first_[from];
    if (cells >= kCellsPerLook) {
      if (has_passed(deadline)) return {};
      cells = 0;
    }
    run_row(from);
  }
  for (std::size_t cell = first_[0]; cell < first_[1]; ++cell)
    row_value_[diagonals_[cell][1]] = dual_[cell] + half_[cell];
  row_value_[1] = 0;
  return std::min(kNever, min_sum(0, last, first_[0], first_[1]));
}

// The diagonals from a position to later ones, ascending; all that they contain is known.
void PolygonDuals::run_row(Position from) {
  const auto file = [&](Position to, std::int64_t value) {
    row_value_[to] = value;
    backward_[backward_end_[to]++] = {from, value};
  };
  file(from + 1, 0);
  for (std::size_t cell = first_[from]; cell < first_[from + std::size_t{1}]; ++cell) {
    const Position to = diagonals_[cell][1];
    dual_[cell] = std::min(kNever, half_[cell] + min_sum(from, to, first_[from], cell));
    file(to, std::min(kNever, dual_[cell] + half_[cell]));
  }
  row_value_[from + std::size_t{1}] = kNever;
  for (std::size_t cell = first_[from]; cell < first_[from + std::size_t{1}]; ++cell)
    row_value_[diagonals_[cell][1]] = kNever;
}

// Over the positions between the two to which both are joined: by the shorter of two lists. In the row of `from` the
// diagonals before `cell` are known.
std::int64_t PolygonDuals::min_sum(Position from, Position to, std::size_t first_cell, std::size_t cell) const {
  std::int64_t least = kNever;
  const auto begin = backward_.begin() + static_cast<std::ptrdiff_t>(backward_first_[to]);
  const auto end = backward_.begin() + static_cast<std::ptrdiff_t>(backward_end_[to]);
  if (16 * (cell - first_cell + 1) >= static_cast<std::size_t>(end - begin)) {
    for (auto it = begin; it != end; ++it) least = std::min(least, row_value_[it->from] + it->value);
    return least;
  }
  const auto look_at = [&](Position middle) {
    const auto it = std::partition_point(begin, end, [&](const BackwardCell& b) { return b.from > middle; });
    if (it != end && it->from == middle) least = std::min(least, row_value_[middle] + it->value);
  };
  look_at(from + 1);
  for (std::size_t i = first_cell; i < cell; ++i) look_at(diagonals_[i][1]);
  return least;
}

}  // namespace mwt
