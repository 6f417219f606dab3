#include "algorithms/triangle_lp/cover_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "algorithms/common/rows.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxSweeps = 20'000;
constexpr std::size_t kMaxVisits = 1'000'000'000;  // of columns, in all sweeps together
// A sweep that gains less than this, relatively, is the last: a linear program then gains more in the same time.
constexpr double kNegligibleGain = 1e-6;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The columns at every side, and their reduced costs, kept up to date.
class SideBalance {
 public:
  SideBalance(const CoverModel& model, CoverDuals& duals) : model_(model), dual_(duals.of_side) {
    for (const auto& column : model.columns) reduced_.push_back(reduced_cost(model, duals, column));
    columns_ = file_in_rows<std::uint32_t>(model.side_cost.size(), [&](const auto& file) {
      for (std::uint32_t c = 0; c < model.columns.size(); ++c) {
        for (const Side side : model.columns[c].sides) file(side, c);
      }
    });
  }

  void add_dual(Side side, double dual) {
    dual_[side] += dual;
    for (const std::uint32_t c : std::as_const(columns_)[side]) reduced_[c] -= dual;
  }

  void balance(std::uint32_t edge) {
    const Side forward = forward_side(edge), backward = backward_side(edge);
    if (!model_.is_inner(edge)) {
      for (const Side side : {forward, backward}) {
        if (model_.on_boundary[side] && min_at(side) < kInfinity) add_dual(side, min_at(side));
      }
      return;
    }
    const double min_forward = min_at(forward), min_backward = min_at(backward);
    const bool both_sides_live = min_forward < kInfinity && min_backward < kInfinity;
    if (both_sides_live) {
      const double moved = 0.5 * (min_forward - min_backward);
      add_dual(forward, moved);
      add_dual(backward, -moved);
    } else if (min_forward < model_.max_cover_cost || min_backward < model_.max_cover_cost) {
      // No cover uses the edge: price its triangles out.
      const double moved = (min_forward < kInfinity ? -1 : 1) * 2 * model_.max_cover_cost;
      add_dual(forward, moved);
      add_dual(backward, -moved);
    }
  }

  [[nodiscard]] double boundary_dual() const {
    double total = 0;
    for (Side side = 0; side < dual_.size(); ++side) total += model_.on_boundary[side] ? dual_[side] : 0;
    return total;
  }

  // Opposite sides' dual values are exact negatives but for the rounding of many small steps.
  void make_opposite() {
    for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) {
      if (model_.is_inner(edge)) dual_[forward_side(edge)] = -dual_[backward_side(edge)];
    }
  }

 private:
  [[nodiscard]] double min_at(Side side) const {
    double least = kInfinity;
    for (const std::uint32_t c : columns_[side]) least = std::min(least, reduced_[c]);
    return least;
  }

  const CoverModel& model_;
  std::vector<double>& dual_;
  Rows<std::uint32_t> columns_;  // by side
  std::vector<double> reduced_;
};

std::vector<std::uint32_t> edges_by_length(const CoverModel& model) {
  std::vector<std::uint32_t> order(model.edges.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return model.side_cost[forward_side(a)].high < model.side_cost[forward_side(b)].high;
  });
  return order;
}

}  // namespace

void balance_duals(const CoverModel& model, CoverDuals& duals, const Deadline& deadline) {
  SideBalance balance(model, duals);
  std::vector<std::uint32_t> order = edges_by_length(model);
  double last = balance.boundary_dual();
  const std::size_t sweeps = std::min(kMaxSweeps, kMaxVisits / (model.columns.size() + 1));
  for (std::size_t sweep = 0; sweep < sweeps; ++sweep) {
    for (const std::uint32_t edge : order) balance.balance(edge);
    std::reverse(order.begin(), order.end());  // so that changes spread in both directions
    const double dual = balance.boundary_dual();
    const bool late = has_passed(deadline);
    if (late || std::abs(dual - last) <= kNegligibleGain * dual) break;
    last = dual;
  }
  balance.make_opposite();
}

}  // namespace mwt
