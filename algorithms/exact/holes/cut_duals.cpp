#include "algorithms/exact/holes/cut_duals.h"

#include <algorithm>
#include <cmath>

#include "geometry/numbers/interval.h"

namespace mwt {

namespace {

constexpr int kMaxSweeps = 60;

// Of a reduced cost, relative to the largest cost that is added.
constexpr double kCostError = 64 * 0x1p-53;

}  // namespace

CutDuals::CutDuals(const CutPolygon& polygon) : polygon_(polygon), loose_(polygon) {
  is_alive_.assign(polygon.graph.target.size(), true);
  set_costs();
  update_lower_bound();
}

void CutDuals::set_costs() {
  const CandidateGraph& graph = polygon_.graph;
  const IntervalProgram& program = polygon_.program;
  const DoubleDouble& whole = program.value(program.closing_cell());
  value_ = std::max(0.0, enclose(whole, program.value_error()).lower);
  double longest = 0;
  cost_.assign(graph.target.size(), 0);
  for (std::uint32_t h = 0; h < cost_.size(); ++h) {
    const double side = length(graph.points[loose_.origin(h)], graph.points[graph.target[h]]).high;
    length_.push_back(side);
    longest = std::max(longest, side);
    switch (polygon_.kind[h]) {
      case SideKind::outside: cost_[h] = kInfinity; break;
      case SideKind::boundary: cost_[h] = 0; break;
      case SideKind::cut:
      case SideKind::crossing: cost_[h] = side / 2; break;
      case SideKind::chord:
        const double value = program.value(polygon_.cell[h]).high;
        cost_[h] = polygon_.is_lower[h] ? value : side - value;
        break;
    }
  }
  for (const Edge& cut : polygon_.cuts) {
    const auto star = graph.star(cut.a);
    const auto place = std::find(star.begin(), star.end(), cut.b) - star.begin();
    cut_halfedge_.push_back(graph.first[cut.a] + static_cast<std::uint32_t>(place));
    unpaid_.push_back(next_down(length(graph.points[cut.a], graph.points[cut.b]).high));
  }
  // The closing side: the triangle on its left gets the dual value of the whole.
  const Index from = program.vertex(program.size() - 1), to = program.vertex(0);
  for (std::uint32_t h = graph.first[from]; h < graph.first[from + std::size_t{1}]; ++h) {
    if (graph.target[h] == to) cost_[h] = -whole.high;
  }
  // A cost is a value of this size, rounded, or what is missing to a length; three are added, and payments subtracted.
  error_ = kCostError * (whole.high + 4 * longest);
}

bool CutDuals::find_loose_triangles(std::size_t limit, const Deadline& deadline) {
  const bool found = loose_.find(limit, deadline);
  paid_by_.assign(loose_.size(), 0);
  return found;
}

double CutDuals::reduced_cost(Number triangle) const {
  const auto& [a, b, c] = loose_.sides(triangle);
  return cost_[a] + cost_[b] + cost_[c] - paid_by_[triangle];
}

double CutDuals::min_of(std::span<const Number> triangles) const {
  double least = kInfinity;
  for (const Number t : triangles) least = std::min(least, reduced_cost(t));
  return least;
}

// Each crossing candidate passes dual value from one side to the other until the cheapest triangles on both cost the
// same. Returns the largest change.
double CutDuals::balance_once() {
  double largest = 0;
  for (const std::uint32_t h : loose_.crossing()) {
    if (!is_alive_[h]) continue;
    const std::uint32_t twin = polygon_.twin[h];
    const double left = min_left_of(h), right = min_left_of(twin);
    if (left == kInfinity || right == kInfinity) {
      kill(h);  // no triangle on one side
      continue;
    }
    const double change = (right - left) / 2;
    cost_[h] += change;
    cost_[twin] = length_[h] - cost_[h];
    error_ = std::max(error_, kCostError * std::max(std::abs(cost_[h]), std::abs(cost_[twin])));
    largest = std::max(largest, std::abs(change));
  }
  return largest;
}

void CutDuals::charge(std::size_t cut) {
  const std::array ends{loose_.straddling(cut, 0), loose_.straddling(cut, 1)};
  std::array<double, 2> offer{};
  double pay = unpaid_[cut];  // unless a triangle straddles it, the cut is in every triangulation
  const bool may_be_crossed = !ends[0].empty() && !ends[1].empty();
  if (may_be_crossed) {
    for (const std::size_t end : {0U, 1U}) offer[end] = std::max(0.0, min_of(ends[end]) - error_);
    pay = std::min(pay, offer[0] + offer[1]);
  }
  if (pay <= 0) return;
  for (const std::size_t end : {0U, 1U}) {
    const double share = may_be_crossed ? pay * (offer[end] / (offer[0] + offer[1])) : 0;
    for (const Number t : ends[end]) paid_by_[t] += share;
  }
  unpaid_[cut] = std::max(0.0, next_down(unpaid_[cut] - pay));
  paid_ = next_down(paid_ + pay * (1 - 0x1p-50));
  const std::uint32_t h = cut_halfedge_[cut];
  cost_[h] = cost_[polygon_.twin[h]] = unpaid_[cut] / 2;
}

// Triangles with a negative reduced cost, if any are left, are at most one per directed crossing candidate.
void CutDuals::update_lower_bound() {
  std::vector<double> least(loose_.slots(), 0);
  for (Number t = 0; t < loose_.size(); ++t) {
    const double cost = reduced_cost(t) - error_;
    if (cost >= 0) continue;
    for (const std::uint32_t side : loose_.sides(t)) {
      if (loose_.slot(side) == kNoIndex) continue;
      least[loose_.slot(side)] = std::min(least[loose_.slot(side)], cost);
      break;
    }
  }
  bound_ = next_down(value_ + paid_);
  for (const double cost : least) bound_ = next_down(bound_ + cost);
  lower_bound_ = std::max(lower_bound_, bound_);
}

void CutDuals::improve(const Deadline& deadline) {
  double first_change = 0;
  for (int sweep = 0; sweep < kMaxSweeps && !has_passed(deadline); ++sweep) {
    const double change = balance_once();
    first_change = std::max(first_change, change);
    if (change <= std::max(16 * error_, 1e-3 * first_change)) break;
  }
  drop_dead_triangles();
  for (std::size_t cut = 0; cut < polygon_.cuts.size(); ++cut) charge(cut);
  update_lower_bound();
}

void CutDuals::kill(std::uint32_t halfedge) {
  is_alive_[halfedge] = false;
  is_alive_[polygon_.twin[halfedge]] = false;
}

void CutDuals::drop_dead_triangles() {
  for (;;) {
    const std::size_t before = loose_.size();
    const std::vector<Number> kept = loose_.keep_alive(is_alive_);
    if (kept.size() == before) return;
    for (std::size_t i = 0; i < kept.size(); ++i) paid_by_[i] = paid_by_[kept[i]];
    paid_by_.resize(kept.size());
    for (const std::uint32_t h : loose_.crossing()) {
      if (loose_.left_of(h).empty() || loose_.left_of(polygon_.twin[h]).empty()) kill(h);
    }
  }
}

bool CutDuals::is_certain(std::size_t cut, double upper) const {
  const double least = std::max(0.0, min_at(cut, 0) - error_) + std::max(0.0, min_at(cut, 1) - error_);
  return least > next_up(upper - bound_);
}

std::size_t CutDuals::remove_expensive(double upper, bool with_chords) {
  const double gap = next_up(upper - bound_);
  std::size_t removed = remove_expensive_crossing(gap);
  if (with_chords) removed += remove_expensive_chords(gap);
  if (removed > 0) drop_dead_triangles();
  return removed;
}

std::size_t CutDuals::remove_expensive_crossing(double gap) {
  std::size_t removed = 0;
  for (const std::uint32_t h : loose_.crossing()) {
    if (!is_alive_[h]) continue;
    const double cost = min_left_of(h) + min_left_of(polygon_.twin[h]) - 2 * error_;
    if (cost <= gap) continue;
    kill(h);
    ++removed;
  }
  return removed;
}

// A triangulation that contains a chord has a triangle on its upper side, which is loose or whose upper side is a chord
// again, up to the closing side: their reduced costs are all paid.
std::size_t CutDuals::remove_expensive_chords(double gap) {
  const IntervalProgram& program = polygon_.program;
  std::vector<double> outside(program.cell_count(), kInfinity);
  for (Number t = 0; t < loose_.size(); ++t) {
    const double cost = std::max(0.0, reduced_cost(t) - error_);
    for (const std::uint32_t side : loose_.sides(t)) {
      if (polygon_.kind[side] == SideKind::chord && polygon_.is_lower[side])
        outside[polygon_.cell[side]] = std::min(outside[polygon_.cell[side]], cost);
    }
  }
  for (std::uint32_t h = 0; h < polygon_.kind.size(); ++h) {
    if (polygon_.kind[h] == SideKind::chord && !is_alive_[h]) outside[polygon_.cell[h]] = -1;  // not to be used
  }
  program.add_outside_costs(gap, outside);
  std::size_t removed = 0;
  for (std::uint32_t h = 0; h < polygon_.kind.size(); ++h) {
    const bool is_chord = polygon_.kind[h] == SideKind::chord && polygon_.is_lower[h] && is_alive_[h];
    if (!is_chord || outside[polygon_.cell[h]] <= gap) continue;
    kill(h);
    ++removed;
  }
  return removed;
}

}  // namespace mwt
