#include "algorithms/exact/holes/cut_duals.h"

#include <algorithm>
#include <cmath>

#include "algorithms/exact/holes/triangle_emptiness.h"
#include "geometry/numbers/interval.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr int kMaxSweeps = 60;

// Of a reduced cost, relative to the largest cost that is added.
constexpr double kCostError = 64 * 0x1p-53;

}  // namespace

CutDuals::CutDuals(const CutPolygon& polygon) : polygon_(polygon) {
  const CandidateGraph& graph = polygon.graph;
  origin_.resize(graph.target.size());
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) origin_[h] = v;
  }
  is_alive_.assign(graph.target.size(), true);
  set_costs();
  list_crossing();
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
    const double side = length(graph.points[origin_[h]], graph.points[graph.target[h]]).high;
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

void CutDuals::list_crossing() {
  crossing_.clear();
  for (std::uint32_t h = 0; h < polygon_.kind.size(); ++h) {
    const bool is_first = origin_[h] < polygon_.graph.target[h];
    if (is_first && is_alive_[h] && polygon_.kind[h] == SideKind::crossing) crossing_.push_back(h);
  }
}

std::size_t CutDuals::alive_crossing() const { return crossing_.size(); }

bool CutDuals::find_loose_triangles(std::size_t limit, const Deadline& deadline) {
  std::vector<std::uint32_t> at_first(polygon_.graph.points.size(), kNoIndex);
  std::vector<std::uint32_t> touched;
  for (const std::uint32_t h : crossing_) {
    add_triangles_of(h, at_first, touched);
    if (loose_.size() > limit || has_passed(deadline)) return false;
  }
  const TriangleEmptiness emptiness(polygon_.graph.points);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < loose_.size(); ++i) {
    if (i % 256 == 0 && has_passed(deadline)) return false;
    const auto& [a, b, c] = loose_[i].side;
    if (emptiness.is_empty(origin_[a], origin_[b], origin_[c])) loose_[kept++] = loose_[i];
  }
  loose_.resize(kept);
  file_triangles();
  list_straddling();
  return true;
}

bool CutDuals::may_be_sides(const std::array<std::uint32_t, 3>& sides) const {
  return std::all_of(sides.begin(), sides.end(),
                     [&](std::uint32_t side) { return polygon_.kind[side] != SideKind::outside; });
}

// Each loose triangle is found from its first crossing side in the order of crossing_.
void CutDuals::add_triangles_of(std::uint32_t halfedge, std::vector<std::uint32_t>& at_first,
                                std::vector<std::uint32_t>& touched) {
  const CandidateGraph& graph = polygon_.graph;
  const Index a = origin_[halfedge], b = graph.target[halfedge];
  touched.clear();
  for (std::uint32_t h = graph.first[a]; h < graph.first[a + std::size_t{1}]; ++h) {
    at_first[graph.target[h]] = h;
    touched.push_back(graph.target[h]);
  }
  const auto is_earlier = [&](std::uint32_t side) {
    return polygon_.kind[side] == SideKind::crossing &&
           std::min(side, polygon_.twin[side]) < std::min(halfedge, polygon_.twin[halfedge]);
  };
  for (std::uint32_t bc = graph.first[b]; bc < graph.first[b + std::size_t{1}]; ++bc) {
    const Index c = graph.target[bc];
    const std::uint32_t ac = at_first[c];
    if (ac == kNoIndex || is_earlier(ac) || is_earlier(bc)) continue;
    const int turn = orientation(graph.points[a], graph.points[b], graph.points[c]);
    const std::array<std::uint32_t, 3> left{halfedge, bc, polygon_.twin[ac]};
    const std::array<std::uint32_t, 3> right{polygon_.twin[halfedge], ac, polygon_.twin[bc]};
    const auto& sides = turn > 0 ? left : right;
    if (turn != 0 && may_be_sides(sides)) loose_.push_back({sides, 0});
  }
  for (const Index v : touched) at_first[v] = kNoIndex;
}

// By each of their crossing sides.
void CutDuals::file_triangles() {
  slot_.assign(cost_.size(), kNoIndex);
  std::uint32_t slots = 0;
  for (const std::uint32_t h : crossing_) {
    slot_[h] = slots++;
    slot_[polygon_.twin[h]] = slots++;
  }
  filed_ = file_in_rows<std::uint32_t>(slots, [&](const auto& file) {
    for (std::uint32_t t = 0; t < loose_.size(); ++t) {
      for (const std::uint32_t side : loose_[t].side) {
        if (slot_[side] != kNoIndex) file(slot_[side], t);
      }
    }
  });
}

void CutDuals::list_straddling() {
  const CandidateGraph& graph = polygon_.graph;
  std::vector<std::vector<std::pair<std::uint32_t, Index>>> cuts_at(graph.points.size());  // cut * 2 + end, other end
  for (std::uint32_t cut = 0; cut < polygon_.cuts.size(); ++cut) {
    const auto [a, b] = polygon_.cuts[cut];
    cuts_at[a].emplace_back(2 * cut, b);
    cuts_at[b].emplace_back(2 * cut + 1, a);
  }
  ends_.assign(polygon_.cuts.size(), {});
  for (std::uint32_t t = 0; t < loose_.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index corner = origin_[loose_[t].side[i]];
      const Index next = graph.target[loose_[t].side[i]], last = origin_[loose_[t].side[(i + 2) % 3]];
      for (const auto& [end, other] : cuts_at[corner]) {
        const bool is_inside = orientation(graph.points[corner], graph.points[next], graph.points[other]) > 0 &&
                               orientation(graph.points[corner], graph.points[other], graph.points[last]) > 0;
        if (is_inside) ends_[end / 2][end % 2].straddling.push_back(t);
      }
    }
  }
}

double CutDuals::reduced_cost(const Loose& triangle) const {
  return cost_[triangle.side[0]] + cost_[triangle.side[1]] + cost_[triangle.side[2]] - triangle.paid;
}

double CutDuals::min_left_of(std::uint32_t halfedge) const {
  double least = kInfinity;
  for (const std::uint32_t t : triangles_left_of(halfedge)) least = std::min(least, reduced_cost(loose_[t]));
  return least;
}

double CutDuals::min_at(const CutEnd& end) const {
  double least = kInfinity;
  for (const std::uint32_t t : end.straddling) least = std::min(least, reduced_cost(loose_[t]));
  return least;
}

// Each crossing candidate passes dual value from one side to the other until the cheapest triangles on both cost the
// same. Returns the largest change.
double CutDuals::balance_once() {
  double largest = 0;
  for (const std::uint32_t h : crossing_) {
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
  const auto& ends = ends_[cut];
  std::array<double, 2> offer{};
  double pay = unpaid_[cut];  // unless a triangle straddles it, the cut is in every triangulation
  const bool may_be_crossed = !ends[0].straddling.empty() && !ends[1].straddling.empty();
  if (may_be_crossed) {
    for (const std::size_t end : {0U, 1U}) offer[end] = std::max(0.0, min_at(ends[end]) - error_);
    pay = std::min(pay, offer[0] + offer[1]);
  }
  if (pay <= 0) return;
  for (const std::size_t end : {0U, 1U}) {
    const double share = may_be_crossed ? pay * (offer[end] / (offer[0] + offer[1])) : 0;
    for (const std::uint32_t t : ends[end].straddling) loose_[t].paid += share;
  }
  unpaid_[cut] = std::max(0.0, next_down(unpaid_[cut] - pay));
  paid_ = next_down(paid_ + pay * (1 - 0x1p-50));
  const std::uint32_t h = cut_halfedge_[cut];
  cost_[h] = cost_[polygon_.twin[h]] = unpaid_[cut] / 2;
}

// Triangles with a negative reduced cost, if any are left, are at most one per directed crossing candidate.
void CutDuals::update_lower_bound() {
  std::vector<double> least(filed_.first.size() - 1, 0);
  for (const Loose& triangle : loose_) {
    const double cost = reduced_cost(triangle) - error_;
    if (cost >= 0) continue;
    for (const std::uint32_t side : triangle.side) {
      if (slot_[side] == kNoIndex) continue;
      least[slot_[side]] = std::min(least[slot_[side]], cost);
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
  const auto is_dead = [&](const Loose& triangle) {
    return std::any_of(triangle.side.begin(), triangle.side.end(),
                       [&](std::uint32_t side) { return !is_alive_[side]; });
  };
  for (;;) {
    const auto first_dead = std::remove_if(loose_.begin(), loose_.end(), is_dead);
    if (first_dead == loose_.end()) return;
    loose_.erase(first_dead, loose_.end());
    list_crossing();
    file_triangles();
    list_straddling();
    for (const std::uint32_t h : crossing_) {
      if (triangles_left_of(h).empty() || triangles_left_of(polygon_.twin[h]).empty()) kill(h);
    }
  }
}

bool CutDuals::is_certain(std::size_t cut, double upper) const {
  const double least = std::max(0.0, min_at(ends_[cut][0]) - error_) + std::max(0.0, min_at(ends_[cut][1]) - error_);
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
  for (const std::uint32_t h : crossing_) {
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
  for (const Loose& triangle : loose_) {
    const double cost = std::max(0.0, reduced_cost(triangle) - error_);
    for (const std::uint32_t side : triangle.side) {
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
