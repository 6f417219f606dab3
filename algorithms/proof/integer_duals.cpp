#include "algorithms/proof/integer_duals.h"

#include <algorithm>
#include <cmath>

#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::int64_t kLargest = std::int64_t{1} << 58;

// A half length or dual value in units; one that is too large stays far from overflow.
std::int64_t rounded_down(DoubleDouble value, int shift) {
  value = {std::ldexp(value.high, shift), std::ldexp(value.low, shift)};
  if (!(std::abs(value.high) < static_cast<double>(kLargest))) return value.high < 0 ? -kLargest : kLargest;
  const double whole = std::floor(value.high);
  return static_cast<std::int64_t>(whole) + static_cast<std::int64_t>(std::floor((value.high - whole) + value.low));
}

}  // namespace

IntegerDuals::IntegerDuals(const CoverModel& model, Points points, int shift)
    : model_(model), points_(points), shift_(shift), dual_(model.side_cost.size()) {
  for (std::uint32_t edge = 0; edge < model.edges.size(); ++edge) {
    // Lengths err by less than 2^-90 of themselves, and they are below 2^60.
    const std::int64_t half = rounded_down(model.side_cost[forward_side(edge)] - std::ldexp(1.0, -20 - shift), shift);
    half_.push_back(model.is_inner(edge) ? std::max<std::int64_t>(half, 0) : 0);
  }
  columns_ = file_in_rows<Column>(dual_.size(), [&](const auto& file) {
    for (Column c = 0; c < model.columns.size(); ++c) {
      for (const Side side : model.columns[c].sides) file(side, c);
    }
  });
}

bool IntegerDuals::is_covered_once(Side side) const {
  return model_.on_boundary[side] != 0 || decisions_[edge_of(side)] == EdgeDecision::in;
}

void IntegerDuals::round(const CoverDuals& duals) {
  decisions_ = duals.decisions;
  find_usable_columns();
  for (Side side = 0; side < dual_.size(); ++side) {
    const DoubleDouble cost = model_.on_boundary[side] != 0 ? model_.side_cost[side] : DoubleDouble();
    dual_[side] = rounded_down(DoubleDouble(duals.of_side[side]) - cost, shift_);
    const Side other = reversed(side);
    const bool is_one_way = model_.on_boundary[other] != 0 && model_.on_boundary[side] == 0;
    if (is_one_way) dual_[side] = 0;  // nothing lies there
    if (other < side && model_.is_inner(edge_of(side)) && !is_covered_once(side)) dual_[side] = -dual_[other];
  }
  constexpr int kSweeps = 4;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) {
      if (model_.is_inner(edge) && !is_covered_once(forward_side(edge))) balance(edge);
    }
  }
  for (Side side = 0; side < dual_.size(); ++side) {
    if (is_covered_once(side)) take_what_is_left(side);
  }
}

void IntegerDuals::find_usable_columns() {
  std::vector<std::uint8_t> is_excluded(model_.edges.size(), 0);
  for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) {
    if (decisions_[edge] == EdgeDecision::out) is_excluded[edge] = 1;
    if (decisions_[edge] != EdgeDecision::in) continue;
    const auto& [a, b] = model_.edges[edge];
    for (std::uint32_t other = 0; other < model_.edges.size(); ++other) {
      const auto& [c, d] = model_.edges[other];
      if (other != edge && segments_cross(points_[a], points_[b], points_[c], points_[d])) is_excluded[other] = 1;
    }
  }
  is_usable_.assign(model_.columns.size(), 1);
  for (Column c = 0; c < model_.columns.size(); ++c) {
    for (const Side side : model_.columns[c].sides) {
      if (is_excluded[edge_of(side)] != 0) is_usable_[c] = 0;
    }
  }
}

std::int64_t IntegerDuals::reduced_cost(Column column) const {
  std::int64_t result = 0;
  for (const Side side : model_.columns[column].sides) result += half_[edge_of(side)] - dual_[side];
  return result;
}

// The least reduced cost of a usable column with this side; kLargest if there is none.
std::int64_t IntegerDuals::least(Side side) const {
  std::int64_t result = kLargest;
  for (const Column c : columns_[side]) {
    if (is_usable_[c] != 0) result = std::min(result, reduced_cost(c));
  }
  return result;
}

void IntegerDuals::balance(std::uint32_t edge) {
  const Side forward = forward_side(edge), backward = backward_side(edge);
  const std::int64_t left = least(forward), right = least(backward);
  if (std::min(left, right) >= 0 || left == kLargest || right == kLargest) return;
  const std::int64_t dual = dual_[forward] + (left - right) / 2;
  if (dual <= -kLargest || dual >= kLargest) return;
  dual_[forward] = dual;
  dual_[backward] = -dual;
}

void IntegerDuals::take_what_is_left(Side side) {
  const std::int64_t rest = least(side);
  dual_[side] = rest == kLargest ? kLargest : std::clamp(dual_[side] + rest, -kLargest, kLargest);
}

std::int64_t IntegerDuals::bound() const {
  std::int64_t sum = 0, worst = 0;
  for (Side side = 0; side < dual_.size(); ++side) {
    if (is_covered_once(side) && __builtin_add_overflow(sum, dual_[side], &sum)) return 0;
  }
  for (Column c = 0; c < model_.columns.size(); ++c) {
    if (is_usable_[c] != 0) worst = std::min(worst, reduced_cost(c));
  }
  std::int64_t loss = 0;
  const bool overflows = __builtin_mul_overflow(worst, static_cast<std::int64_t>(model_.triangle_count), &loss) ||
                         __builtin_add_overflow(sum, loss, &sum);
  return overflows ? 0 : std::max<std::int64_t>(sum, 0);
}

}  // namespace mwt
