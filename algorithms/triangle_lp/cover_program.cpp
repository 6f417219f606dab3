#include "algorithms/triangle_lp/cover_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace mwt {

namespace {

using Entry = LinearProgram::Entry;
using Method = LinearProgram::Method;

// The gap between the relaxation's value and the certified bound, relative to the value, at which refinement rests.
constexpr double kRestingGap = 0x1p-44;
// So many rounds in a row that neither bring new columns nor halve the best gap end the refinement.
constexpr int kPatience = 3;

// A power of two by which `worst` becomes about -1: doubles scale exactly.
double scale_for(double worst) {
  constexpr int kMaxExponent = 60;
  return worst < 0 ? std::ldexp(1.0, std::min(-std::ilogb(worst), kMaxExponent)) : 1;
}

bool is_forward(Side side) { return side == forward_side(edge_of(side)); }

}  // namespace

std::vector<std::uint32_t> promising_columns(const CoverModel& model, const CoverDuals& duals,
                                             std::span<const Triangle> known, std::size_t per_triangle) {
  const std::set<Triangle> known_triangles(known.begin(), known.end());
  std::vector<std::uint32_t> columns;
  std::vector<std::pair<double, std::uint32_t>> ranked;
  for (std::uint32_t c = 0; c < model.columns.size(); ++c) {
    const CoverModel::Column& column = model.columns[c];
    if (known_triangles.contains(column.triangle)) columns.push_back(c);
    ranked.push_back({reduced_cost(model, duals, column) / model.cost(column), c});
  }
  const auto wanted = std::min(std::max(kFewColumns, per_triangle * model.triangle_count), ranked.size());
  std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(wanted), ranked.end());
  for (std::size_t i = 0; i < wanted; ++i) columns.push_back(ranked[i].second);
  return columns;
}

CoverProgram::CoverProgram(const CoverModel& model, CoverDuals duals, std::span<const std::uint32_t> first_columns,
                           const Deadline& deadline)
    : model_(model), deadline_(deadline), duals_(std::move(duals)), empty_cover_cost_(2 * model.max_cover_cost) {
  const std::size_t edges = model.edges.size();
  is_active_.assign(model.columns.size(), 0);
  boundary_row_.assign(2 * edges, kNone);
  balance_row_.assign(edges, kNone);
  decision_row_.assign(edges, kNone);
  decision_dual_.assign(edges, 0);
  program_.add_column({});
  for (Side side = 0; side < 2 * edges; ++side) {
    if (model.on_boundary[side]) boundary_row_[side] = program_.add_row({}, 1);
  }
  update_empty_cover();
  for (const std::uint32_t column : first_columns) add_column(column);
}

int CoverProgram::row_of_inner_edge(std::uint32_t edge) {
  if (balance_row_[edge] == kNone) balance_row_[edge] = program_.add_row({}, 0);
  return balance_row_[edge];
}

void CoverProgram::add_column(std::uint32_t column) {
  if (is_active_[column]) return;
  is_active_[column] = 1;
  active_.push_back(column);
  std::vector<Entry> entries;
  for (const Side side : model_.columns[column].sides) {
    const std::uint32_t edge = edge_of(side);
    if (model_.on_boundary[side]) {
      entries.push_back({boundary_row_[side], 1});
    } else {
      entries.push_back({row_of_inner_edge(edge), is_forward(side) ? 1.0 : -1.0});
      if (decision_row_[edge] != kNone && is_forward(side)) entries.push_back({decision_row_[edge], 1});
    }
  }
  program_.add_column(entries);
}

// The empty cover counts for every side that has to be covered.
void CoverProgram::update_empty_cover() {
  std::vector<Entry> entries;
  for (const int row : boundary_row_) {
    if (row != kNone) entries.push_back({row, 1});
  }
  for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) {
    if (duals_.decisions[edge] == EdgeDecision::in) entries.push_back({decision_row_[edge], 1});
  }
  program_.replace_column(kEmptyCover, entries);
}

void CoverProgram::decide(std::uint32_t edge, EdgeDecision decision) {
  if (decision_row_[edge] == kNone) {
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < active_.size(); ++i) {
      const auto& sides = model_.columns[active_[i]].sides;
      const bool lies_left = std::find(sides.begin(), sides.end(), forward_side(edge)) != sides.end();
      if (lies_left) entries.push_back({static_cast<int>(i) + 1, 1});
    }
    decision_row_[edge] = program_.add_row(entries, 0);
  }
  duals_.decisions[edge] = decision;
  if (decision == EdgeDecision::open) {
    program_.set_right_side(decision_row_[edge], {});
    decision_dual_[edge] = 0;
    duals_.of_side[forward_side(edge)] = -duals_.of_side[backward_side(edge)];
  } else {
    program_.set_right_side(decision_row_[edge], decision == EdgeDecision::in ? 1 : 0);
  }
  update_empty_cover();
}

// GLPK's tolerance is relative to the largest cost, so costs that are too large to matter are cut. After pricing,
// `scale` has made every reduced cost at least -2, so that no cover gains more than twice its triangles by leaving the
// last optimum: dearer columns stay out of it whatever exactly they cost.
double CoverProgram::max_useful_cost(double scale) const {
  constexpr double kMargin = 8;
  const bool priced = -scale * pricing_.worst >= 1;
  return priced ? 2 * kMargin * static_cast<double>(model_.triangle_count) : std::numeric_limits<double>::max();
}

void CoverProgram::set_reduced_costs(double scale) {
  double certain_dual = 0;
  for (Side side = 0; side < duals_.of_side.size(); ++side) {
    const bool covered_once = model_.on_boundary[side] || duals_.decisions[edge_of(side)] == EdgeDecision::in;
    if (covered_once) certain_dual += duals_.of_side[side];
  }
  const double cap = max_useful_cost(scale);
  std::vector<double> costs{std::min((empty_cover_cost_ - certain_dual) * scale, cap)};
  for (const std::uint32_t column : active_) {
    costs.push_back(std::min(reduced_cost(model_, duals_, model_.columns[column]) * scale, cap));
  }
  program_.set_costs(costs);
}

void CoverProgram::add_program_duals(double scale) {
  for (std::uint32_t edge = 0; edge < model_.edges.size(); ++edge) {
    double& forward = duals_.of_side[forward_side(edge)];
    double& backward = duals_.of_side[backward_side(edge)];
    if (balance_row_[edge] != kNone) {
      backward -= program_.dual(balance_row_[edge]) / scale;
      if (duals_.decisions[edge] != EdgeDecision::open) {
        decision_dual_[edge] += program_.dual(decision_row_[edge]) / scale;
      }
      forward = decision_dual_[edge] - backward;
    }
    for (const Side side : {forward_side(edge), backward_side(edge)}) {
      if (boundary_row_[side] != kNone) duals_.of_side[side] += program_.dual(boundary_row_[side]) / scale;
    }
  }
}

bool CoverProgram::optimise(Method method, double scale) {
  set_reduced_costs(scale);
  ++programs_;
  solved_ = program_.solve(method, deadline_);
  if (solved_) add_program_duals(scale);
  return solved_;
}

double CoverProgram::primal_value() const {
  double value = empty_cover_cost_ * program_.value(kEmptyCover);
  for (std::size_t i = 0; i < active_.size(); ++i) {
    value += model_.cost(model_.columns[active_[i]]) * program_.value(static_cast<int>(i) + 1);
  }
  return value;
}

bool CoverProgram::add_violated_columns(std::vector<PricedColumn> violated) {
  constexpr double kNegligible = 0x1p-10;  // of the worst
  const double threshold = kNegligible * pricing_.worst;
  std::erase_if(violated, [&](const PricedColumn& p) { return is_active_[p.column] || p.reduced_cost > threshold; });
  const std::size_t limit = std::max<std::size_t>(100, static_cast<std::size_t>(program_.rows()) / 2);
  const auto kept = std::min(limit, violated.size());
  std::partial_sort(violated.begin(), violated.begin() + static_cast<std::ptrdiff_t>(kept), violated.end(),
                    [](const PricedColumn& a, const PricedColumn& b) {
                      return a.reduced_cost < b.reduced_cost ||
                             (a.reduced_cost == b.reduced_cost && a.column < b.column);
                    });
  for (std::size_t i = 0; i < kept; ++i) add_column(violated[i].column);
  return kept > 0;
}

double CoverProgram::solve(double enough, int max_rounds) {
  double best = std::max(0.0, price(model_, duals_).lower);  // all there is if the deadline is near
  best_duals_ = duals_;
  double best_gap = std::numeric_limits<double>::infinity();
  int rounds_without_gain = 0;
  double scale = 1;
  Method method = Method::dual;
  pricing_ = {};
  for (int round = 0; round < max_rounds && optimise(method, scale); ++round) {
    pricing_ = price(model_, duals_);
    if (pricing_.lower > best) best_duals_ = duals_;
    best = std::max(best, pricing_.lower);
    const double value = primal_value();
    const double gap = value - pricing_.lower;
    if (best >= enough || gap <= kRestingGap * value) break;
    const bool grown = add_violated_columns(std::move(pricing_.violated));
    rounds_without_gain = grown || gap < 0.5 * best_gap ? 0 : rounds_without_gain + 1;
    if (rounds_without_gain == kPatience) break;
    best_gap = std::min(best_gap, gap);
    scale = scale_for(pricing_.worst);
    method = Method::primal;
  }
  return best;
}

std::optional<std::vector<Triangle>> CoverProgram::cover() const {
  std::vector<Triangle> triangles;
  std::vector<std::uint8_t> covered(model_.on_boundary.size(), 0);
  for (std::size_t i = 0; i < active_.size(); ++i) {
    if (program_.value(static_cast<int>(i) + 1) < 0.5) continue;
    const CoverModel::Column& column = model_.columns[active_[i]];
    for (const Side side : column.sides) {
      if (covered[side]++ > 0) return {};
    }
    triangles.push_back(column.triangle);
  }
  for (Side side = 0; side < covered.size(); ++side) {
    const bool wanted = model_.on_boundary[side] || (covered[reversed(side)] && !model_.on_boundary[reversed(side)]);
    if (covered[side] != static_cast<std::uint8_t>(wanted)) return {};
  }
  if (triangles.size() != model_.triangle_count) return {};
  return triangles;
}

std::vector<double> CoverProgram::edge_use() const {
  std::vector<double> use(model_.edges.size(), 0);
  for (std::size_t i = 0; i < active_.size(); ++i) {
    for (const Side side : model_.columns[active_[i]].sides) {
      if (is_forward(side)) use[edge_of(side)] += program_.value(static_cast<int>(i) + 1);
    }
  }
  return use;
}

std::optional<std::uint32_t> CoverProgram::fractional_edge() const {
  constexpr double kReadingError = 1e-6;  // a use this near to 0 or 1 is taken for that; cover() then verifies
  const std::vector<double> use = edge_use();
  std::optional<std::uint32_t> best;
  double best_merit = 0;
  for (std::uint32_t edge = 0; edge < use.size(); ++edge) {
    const double fraction = std::min(use[edge], 1 - use[edge]);
    if (!model_.is_inner(edge) || duals_.decisions[edge] != EdgeDecision::open || fraction < kReadingError) continue;
    const double merit = fraction * model_.side_cost[forward_side(edge)].high;
    if (merit > best_merit) {
      best = edge;
      best_merit = merit;
    }
  }
  return best;
}

}  // namespace mwt
