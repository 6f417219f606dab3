#include "algorithms/triangle_lp/cover_balance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace mwt {

namespace {

constexpr std::size_t kMostSweeps = 1000;
constexpr std::size_t kMostVisits = 400'000'000;  // of columns, in all sweeps together
constexpr double kNegligibleGain = 1e-6;          // per sweep, relative

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A flow of credit outwards from `origin`, in the model's unit of length: through side ab goes what the triangle
// (origin, a, b) needs, so that every triangle keeps its own need.
class AreaFlow {
 public:
  AreaFlow(const CoverModel& model, Points points)
      : model_(model), points_(points), origin_(points[model.edges[0].a]) {}

  /// Twice the signed area of the triangle (origin, from, to).
  [[nodiscard]] double through(Side side) const {
    const Edge& edge = model_.edges[edge_of(side)];
    const Point a = relative(points_[edge.a]), b = relative(points_[edge.b]);
    const double area = a.x * b.y - a.y * b.x;
    return side == forward_side(edge_of(side)) ? area : -area;
  }

  [[nodiscard]] double through_boundary() const {
    double area = 0;
    for (Side side = 0; side < model_.on_boundary.size(); ++side) {
      if (model_.on_boundary[side]) area += through(side);
    }
    return area;
  }

 private:
  [[nodiscard]] Point relative(const Point& p) const {
    return {std::ldexp(p.x - origin_.x, -model_.exponent), std::ldexp(p.y - origin_.y, -model_.exponent)};
  }

  const CoverModel& model_;
  Points points_;
  Point origin_;
};

// The columns at every side, and their reduced costs, kept up to date.
class SideBalance {
 public:
  explicit SideBalance(const CoverModel& model)
      : model_(model), first_(model.side_cost.size() + 1, 0), credit_(model.side_cost.size(), 0) {
    for (const auto& column : model.columns) {
      reduced_.push_back(model.cost(column));
      for (const Side side : column.sides) ++first_[side + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    columns_.resize(3 * model.columns.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t c = 0; c < model.columns.size(); ++c) {
      for (const Side side : model.columns[c].sides) columns_[next[side]++] = c;
    }
  }

  void add_credit(Side side, double credit) {
    credit_[side] += credit;
    for (std::uint32_t i = first_[side]; i < first_[side + 1]; ++i) reduced_[columns_[i]] -= credit;
  }

  void balance(std::uint32_t edge) {
    const Side forward = forward_side(edge), backward = backward_side(edge);
    if (!model_.is_inner(edge)) {
      for (const Side side : {forward, backward}) {
        if (model_.on_boundary[side] && least_at(side) < kInfinity) add_credit(side, least_at(side));
      }
      return;
    }
    const double moved = 0.5 * (least_at(forward) - least_at(backward));
    if (!std::isfinite(moved)) return;  // no triangle on one side: no cover uses the edge
    add_credit(forward, moved);
    add_credit(backward, -moved);
  }

  [[nodiscard]] double boundary_credit() const {
    double total = 0;
    for (Side side = 0; side < credit_.size(); ++side) total += model_.on_boundary[side] ? credit_[side] : 0;
    return total;
  }

  // Opposite sides' credits are exact negatives only without the rounding of many small steps.
  [[nodiscard]] CoverCredits credits() const {
    CoverCredits result{credit_, std::vector<EdgeDecision>(model_.edges.size(), EdgeDecision::open)};
    for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) {
      if (model_.is_inner(edge)) result.of_side[forward_side(edge)] = -result.of_side[backward_side(edge)];
    }
    return result;
  }

 private:
  [[nodiscard]] double least_at(Side side) const {
    double least = kInfinity;
    for (std::uint32_t i = first_[side]; i < first_[side + 1]; ++i) least = std::min(least, reduced_[columns_[i]]);
    return least;
  }

  const CoverModel& model_;
  std::vector<std::uint32_t> first_;  // columns at side s: columns_[first_[s]] .. columns_[first_[s + 1]]
  std::vector<std::uint32_t> columns_;
  std::vector<double> reduced_;
  std::vector<double> credit_;
};

// Credit in proportion to area, as much in all as the known cover costs.
void add_area_flow(const CoverModel& model, const TriangleCoverProblem& problem, double cover_cost,
                   SideBalance& balance) {
  const AreaFlow flow(model, problem.points);
  constexpr double kSmallestArea = 1e-13;  // below, rounding errors of single areas would matter
  const double area = flow.through_boundary();
  if (area < kSmallestArea || !std::isfinite(area)) return;
  for (Side side = 0; side < model.side_cost.size(); ++side) {
    balance.add_credit(side, flow.through(side) * (cover_cost / area));
  }
}

std::vector<std::uint32_t> edges_by_length(const CoverModel& model) {
  std::vector<std::uint32_t> order(model.edges.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return model.side_cost[forward_side(a)].high < model.side_cost[forward_side(b)].high;
  });
  return order;
}

}  // namespace

CoverCredits balanced_credits(const CoverModel& model, const TriangleCoverProblem& problem, double cover_cost) {
  SideBalance balance(model);
  add_area_flow(model, problem, cover_cost, balance);
  std::vector<std::uint32_t> order = edges_by_length(model);
  double last = balance.boundary_credit();
  const std::size_t sweeps = std::min(kMostSweeps, kMostVisits / (model.columns.size() + 1));
  for (std::size_t sweep = 0; sweep < sweeps; ++sweep) {
    for (const std::uint32_t edge : order) balance.balance(edge);
    std::reverse(order.begin(), order.end());  // news travels both ways
    const double credit = balance.boundary_credit();
    const bool late = problem.deadline && std::chrono::steady_clock::now() >= *problem.deadline;
    if (late || std::abs(credit - last) <= kNegligibleGain * credit) break;
    last = credit;
  }
  return balance.credits();
}

}  // namespace mwt
