#include "algorithms/exact/faces/interval_program.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/exact/faces/length_sum_comparison.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The largest sum of two values' high parts that is not surely worse than the least such sum. Among sums that underflow
// all are close.
double close_above(double least) {
  if (least == 0) return 0;
  if (least < kMinTrustedLength) return std::numeric_limits<double>::max();
  return least + least * kRoundedSumMargin;
}

}  // namespace

void IntervalProgram::clear() {
  vertex_.clear();
  first_.clear();
  to_.clear();
  best_.clear();
}

void IntervalProgram::add_position(Index vertex) {
  vertex_.push_back(vertex);
  first_.push_back(static_cast<Cell>(to_.size()));
}

void IntervalProgram::add_cell(Position to) {
  to_.push_back(to);
  best_.push_back({});
}

void IntervalProgram::add_copy(Position to, Position period) {
  if (to == size()) return add_cell(to);  // a side of the boundary
  to_.push_back(to);
  best_.push_back({kCopy, 0});
  period_ = period;
}

IntervalProgram::Cell IntervalProgram::find(Position from, Position to) const {
  const auto begin = to_.begin() + first_[from], end = to_.begin() + first_[from + 1];
  const auto found = std::lower_bound(begin, end, to);
  return found != end && *found == to ? static_cast<Cell>(found - to_.begin()) : kNoCell;
}

bool IntervalProgram::compute(bool is_closed, const Deadline& deadline) {
  is_closed_ = is_closed;
  first_.push_back(cell_count());
  lay_out_backward_cells();
  for (Position from = size() - 1; from-- > 0;) {
    const bool is_late = size() > kSmall && has_passed(deadline);
    if (is_late) return false;
    compute_row(from);
  }
  return true;
}

void IntervalProgram::lay_out_backward_cells() {
  const std::size_t positions = size();
  backward_first_.assign(positions + 1, 0);
  for (const Position to : to_) ++backward_first_[to + 1];
  for (std::size_t p = 1; p <= positions; ++p) backward_first_[p] += backward_first_[p - 1];
  backward_end_.assign(backward_first_.begin(), backward_first_.end() - 1);
  backward_.resize(to_.size());
  value_.resize(to_.size());
  row_value_.assign(positions, kInfinity);
  row_cell_.resize(positions);
  if (positions > kShort) lay_out_blocks();
}

void IntervalProgram::lay_out_blocks() {
  const std::size_t positions = size();
  std::vector<Position> last(positions, kNoCell);
  block_first_.assign(positions + 1, 0);
  for (Position from = 0; from < positions; ++from) {
    for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) {
      const Position to = to_[cell];
      if (last[to] == from / kBlock) continue;
      last[to] = from / kBlock;
      ++block_first_[to + 1];
    }
  }
  for (std::size_t p = 1; p <= positions; ++p) block_first_[p] += block_first_[p - 1];
  block_end_.assign(block_first_.begin(), block_first_.end() - 1);
  blocks_.resize(block_first_.back());
  row_block_.assign(positions / kBlock + 1, 0);
}

// Rows come by descending `from`.
void IntervalProgram::add_backward_cell(Position from, Cell cell) {
  const Position to = to_[cell];
  const Cell place = backward_end_[to]++;
  backward_[place] = {from, cell, value_[cell].high};
  if (size() <= kShort) return;
  const bool is_new = block_end_[to] == block_first_[to] || blocks_[block_end_[to] - 1].number != from / kBlock;
  if (is_new) blocks_[block_end_[to]++] = {from / kBlock, place, 0};
  blocks_[block_end_[to] - 1].apexes |= std::uint64_t{1} << from % kBlock;
  row_block_[to / kBlock] |= std::uint64_t{1} << to % kBlock;
}

void IntervalProgram::compute_row(Position from) {
  for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) {
    const Position to = to_[cell];
    if (!compute_cell(from, cell)) {
      value_[cell] = kInfinity;
      continue;
    }
    row_value_[to] = value_[cell].high;
    row_cell_[to] = cell;
    add_backward_cell(from, cell);
  }
  for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) {
    row_value_[to_[cell]] = kInfinity;
    if (size() > kShort) row_block_[to_[cell] / kBlock] = 0;
  }
}

// Whether the cell has a triangulation.
bool IntervalProgram::compute_cell(Position from, Cell cell) {
  const Position to = to_[cell];
  value_[cell] = 0;
  if (to == from + 1) return true;
  Option& best = best_[cell];
  if (best.left == kCopy) {
    best.right = find(from + period_, to + period_);
    value_[cell] = value_[best.right];
    return is_feasible(cell);
  }
  if (!find_best_option(from, cell, best)) return false;
  value_[cell] = sum(best);
  if (!is_side(from, to)) value_[cell] += length(points_[vertex_[from]], points_[vertex_[to]]);
  ++counters_.cells;
  return true;
}

// Calls visit(backward cell) for those of a block with these apexes, descending; if there are many, for others as well.
template <class Visit>
void IntervalProgram::for_each_meeting_cell(const Block& block, std::uint64_t apexes, Visit visit) const {
  constexpr int kMany = 12;
  const int count = std::popcount(block.apexes);
  if (std::popcount(apexes) > kMany) {
    for (Cell i = block.first; i < block.first + static_cast<Cell>(count); ++i) visit(backward_[i]);
    return;
  }
  while (apexes != 0) {
    const std::uint64_t highest = std::bit_floor(apexes);
    visit(backward_[block.first + static_cast<Cell>(std::popcount(block.apexes & ~(2 * highest - 1)))]);
    apexes -= highest;
  }
}

// Calls visit(option, sum of the values' high parts) for each apex; the sum is infinite where the row has no cell.
template <class Visit>
void IntervalProgram::for_each_option(Cell cell, Visit visit) const {
  const Position to = to_[cell];
  const auto visit_right = [&](const BackwardCell& right) {
    visit(Option{row_cell_[right.apex], right.cell}, row_value_[right.apex] + right.value);
  };
  if (size() <= kShort) {
    for (Cell i = backward_first_[to]; i < backward_end_[to]; ++i) visit_right(backward_[i]);
    return;
  }
  for (Cell i = block_first_[to]; i < block_end_[to]; ++i) {
    const Block& block = blocks_[i];
    for_each_meeting_cell(block, block.apexes & row_block_[block.number], visit_right);
  }
}

bool IntervalProgram::find_best_option(Position from, Cell cell, Option& best) {
  double least = kInfinity;
  double second = kInfinity;
  for_each_option(cell, [&](const Option& option, double sum) {
    if (sum < least) {
      second = least;
      least = sum;
      best = option;
    } else if (sum < second) {
      second = sum;
    }
  });
  if (least == kInfinity) return false;
  const double threshold = close_above(least);
  if (second <= threshold) best = best_of_close_options(from, cell, threshold);
  return true;
}

IntervalProgram::Option IntervalProgram::best_of_close_options(Position from, Cell cell, double threshold) {
  std::optional<Option> best;
  close_.clear();
  for_each_option(cell, [&](const Option& option, double sum) {
    if (sum <= threshold) close_.push_back(option);
  });
  for (const Option& option : close_) {
    if (!best || compare_options(from, option, *best) < 0) best = option;
  }
  return *best;
}

int IntervalProgram::compare_options(Position from, const Option& one, const Option& other) {
  ++counters_.precise_comparisons;
  const DoubleDouble value = sum(one);
  const double difference = (value - sum(other)).high;
  if (value.high >= kMinTrustedLength && std::abs(difference) > value_error() * value.high)
    return difference > 0 ? 1 : -1;
  collect_diagonals(from, one, one_);
  collect_diagonals(from, other, other_);
  const std::optional<int> sign = compare_length_sums(points_, one_, other_);
  if (!sign) ++counters_.undecided_ties;
  return sign.value_or(0);
}

// Calls visit(option) for each apex, after all cells have been computed. `row`: the feasible cells (from, j) by j;
// `row_block`: which there are, by blocks.
template <class Visit>
void IntervalProgram::for_each_computed_option(Position from, Cell cell, const std::vector<Cell>& row,
                                               const std::vector<std::uint64_t>& row_block, Visit visit) const {
  const Position to = to_[cell];
  const auto visit_right = [&](const BackwardCell& right) {
    if (row[right.apex] != kNoCell) visit(Option{row[right.apex], right.cell});
  };
  if (size() <= kShort) {
    for (Cell i = backward_first_[to]; i < backward_end_[to] && backward_[i].apex > from; ++i)
      visit_right(backward_[i]);
    return;
  }
  for (Cell i = block_first_[to]; i < block_end_[to] && blocks_[i].number >= from / kBlock; ++i) {
    const Block& block = blocks_[i];
    for_each_meeting_cell(block, block.apexes & row_block[block.number], visit_right);
  }
}

// From longer intervals to those inside them.
void IntervalProgram::add_outside_costs(double limit, std::vector<double>& outside) const {
  outside[closing_cell()] = 0;
  std::vector<Cell> row(size(), kNoCell);
  std::vector<std::uint64_t> row_block(size() / kBlock + 1, 0);
  for (Position from = 0; from + 1 < size(); ++from) {
    for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) {
      if (!is_feasible(cell)) continue;
      row[to_[cell]] = cell;
      row_block[to_[cell] / kBlock] |= std::uint64_t{1} << to_[cell] % kBlock;
    }
    for (Cell cell = first_[from + 1]; cell-- > first_[from];) {
      const Position to = to_[cell];
      if (to == from + 1 || !is_feasible(cell) || outside[cell] < 0 || outside[cell] > limit) continue;
      const double own = is_side(from, to) ? 0 : length(points_[vertex_[from]], points_[vertex_[to]]).high;
      const double value = value_[cell].high;
      const double error = 8 * 0x1p-53 * (value + own);
      for_each_computed_option(from, cell, row, row_block, [&](const Option& option) {
        const double excess = own + (value_[option.left].high + value_[option.right].high) - value - error;
        const double cost = outside[cell] + std::max(0.0, excess);
        if (cost > limit) return;
        const double rounded = std::max(0.0, next_down(cost));  // negative: not to be used
        for (const Cell side : {option.left, option.right}) outside[side] = std::min(outside[side], rounded);
      });
    }
    for (Cell cell = first_[from]; cell < first_[from + 1]; ++cell) {
      row[to_[cell]] = kNoCell;
      row_block[to_[cell] / kBlock] = 0;
    }
  }
}

IntervalProgram::Interval IntervalProgram::without_copy(const Interval& interval) const {
  const Option& best = best_[interval.cell];
  return best.left == kCopy ? Interval{interval.from + period_, best.right} : interval;
}

void IntervalProgram::collect_diagonals(Position from, const Option& option, std::vector<Edge>& edges) {
  edges.clear();
  stack_.assign({{from, option.left}, {to_[option.left], option.right}});
  while (!stack_.empty()) {
    const auto [begin, cell] = without_copy(stack_.back());
    stack_.pop_back();
    const Position end = to_[cell];
    if (end == begin + 1) continue;
    edges.push_back(make_edge(vertex_[begin], vertex_[end]));
    const Option& best = best_[cell];
    stack_.push_back({begin, best.left});
    stack_.push_back({to_[best.left], best.right});
  }
}

}  // namespace mwt
