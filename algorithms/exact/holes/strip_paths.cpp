#include "algorithms/exact/holes/strip_paths.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mwt {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Costs that differ by no more than this part of them may be in another order than their high parts.
constexpr double kClose = 1 + 0x1p-50;

// Paths this much shorter than the best one known are not searched for: far below what counts as proved.
constexpr double kWorthSearching = 1 - 1e-14;

// Whether `cost` becomes the smaller of both; of equal ones the first stays.
bool improves(const DoubleDouble& cost, const DoubleDouble& known) {
  if (cost.high > known.high * kClose) return false;
  return cost < known;
}

}  // namespace

StripPaths::StripPaths(const Strip& strip, const StripCosts& costs, const Deadline& deadline)
    : strip_(strip), costs_(costs), deadline_(deadline), best_cost_(kInfinity) {
  for (Place a = 0; a < strip.outer.period(); ++a) {
    rows_.push_back({static_cast<Node>(outer_.size()), 0});
    for (const Place s : strip.across[static_cast<std::size_t>(a)]) {
      outer_.push_back(a);
      inner_.push_back(s);
      length_.push_back(length(costs.points[strip.outer.vertex_at(a)], costs.points[strip.inner.vertex_at(s)]));
    }
    rows_.back().last = static_cast<Node>(outer_.size());
  }
  // Along a path over three periods: two additions per place, lengths and values of programs over two periods.
  const double places = static_cast<double>(strip.outer.period()) + static_cast<double>(strip.inner.period()) + 8;
  error_ = 16 * places * kDoubleDoubleError;
}

// The node (outer, inner), outer place within the first copy; the number of nodes if there is none.
StripPaths::Node StripPaths::find(Place outer, Place inner) const {
  const auto [first, last] = rows_[static_cast<std::size_t>(outer)];
  const auto begin = inner_.begin() + first, end = inner_.begin() + last;
  const auto found = std::lower_bound(begin, end, inner);
  return found != end && *found == inner ? static_cast<Node>(found - inner_.begin()) : static_cast<Node>(inner_.size());
}

// offer(node reached, value) for the node's outer place and later inner ones.
template <class Offer>
void StripPaths::follow_inner_chords(Node node, const Offer& offer) const {
  const Place period = strip_.inner.period();
  if (period == 0) return;
  const Place place = ((inner_[node] % period) + period) % period;
  const Place shift = inner_[node] - place;
  const std::vector<Place>& chords = strip_.inner.chord[static_cast<std::size_t>(place)];
  const std::vector<DoubleDouble>& values = costs_.inner[static_cast<std::size_t>(place)];
  const Node last = rows_[static_cast<std::size_t>(outer_[node])].last;
  Node reached = node + 1;
  for (std::size_t i = 0; i < chords.size() && reached < last; ++i) {
    while (reached < last && inner_[reached] < chords[i] + shift) ++reached;
    if (reached < last && inner_[reached] == chords[i] + shift) offer(reached, values[i]);
  }
}

// offer(node, node reached, value) for all nodes of a row, from their outer place to `to`.
template <class Offer>
void StripPaths::follow_outer_chord(Row row, Place to, const DoubleDouble& value, const Offer& offer) const {
  const Place period = strip_.outer.period();
  const bool leads_on = to >= period;
  const auto [first, last] = rows_[static_cast<std::size_t>(leads_on ? to - period : to)];
  const Place shift = leads_on ? strip_.inner.period() : 0;
  Node reached = first;
  for (Node node = row.first; node < row.last; ++node) {
    const Place wanted = inner_[node] - shift;
    while (reached < last && inner_[reached] < wanted) ++reached;
    if (reached == last) return;
    if (inner_[reached] == wanted) offer(node, reached, value);
  }
}

// From the costs of paths that enter this copy to those of all paths within it, and of those that enter the next.
bool StripPaths::pass_over_period(Costs& here, Costs& next) const {
  for (Place a = 0; a < strip_.outer.period(); ++a) {
    if (has_passed(deadline_)) return false;
    const Row row = rows_[static_cast<std::size_t>(a)];
    for (Node node = row.first; node < row.last; ++node) {
      if (here[node].high == kInfinity) continue;
      const DoubleDouble cost = here[node] + length_[node];
      follow_inner_chords(node, [&](Node reached, const DoubleDouble& value) {
        if (cost.high + value.high > here[reached].high * kClose) return;
        here[reached] = std::min(here[reached], cost + value);
      });
    }
    const std::vector<Place>& chords = strip_.outer.chord[static_cast<std::size_t>(a)];
    for (std::size_t i = 0; i < chords.size(); ++i) {
      Costs& costs = chords[i] < strip_.outer.period() ? here : next;
      const DoubleDouble& value = costs_.outer[static_cast<std::size_t>(a)][i];
      if (value.high == kInfinity) continue;
      follow_outer_chord(row, chords[i], value, [&](Node node, Node reached, const DoubleDouble& chord) {
        const double sum = here[node].high + length_[node].high + chord.high;
        if (!(sum <= costs[reached].high * kClose) || sum == kInfinity) return;
        costs[reached] = std::min(costs[reached], here[node] + length_[node] + chord);
      });
    }
  }
  return true;
}

bool StripPaths::find_bounds(const std::vector<Node>& starts) {
  const Costs unreached(outer_.size(), DoubleDouble(kInfinity));
  Costs first = unreached, after = unreached;
  for (const Node start : starts) first[start] = 0;
  bound_ = unreached;
  next_bound_ = unreached;
  return pass_over_period(first, bound_) && pass_over_period(bound_, next_bound_) &&
         pass_over_period(next_bound_, after);
}

// The best path may still lead through the node: what is missing to the goal is bounded as cycles are.
bool StripPaths::is_near_enough(const Arrival& arrival, std::size_t copy, Node node) const {
  const DoubleDouble& known = copy == 0 ? bound_[node] : next_bound_[node];
  const double goal = next_bound_[start_].high;
  return arrival.cost.high + (goal - known.high) <= best_cost_.high + 1e-14 * goal;
}

void StripPaths::offer(std::size_t copy, Node node, const DoubleDouble& cost, Node from) {
  Arrival& arrival = arrivals_[copy * outer_.size() + node];
  if (arrival.search == search_ && !improves(cost, arrival.cost)) return;
  arrival = {cost, from, search_};
}

void StripPaths::search_row(Place outer, std::size_t copy) {
  const Row row = rows_[static_cast<std::size_t>(outer)];
  const Node offset = static_cast<Node>(copy * outer_.size());
  alive_.clear();
  for (Node node = row.first; node < row.last; ++node) {
    const Arrival& arrival = arrivals_[offset + node];
    if (arrival.search != search_ || !is_near_enough(arrival, copy, node)) continue;
    alive_.push_back(node);
    const DoubleDouble cost = arrival.cost + length_[node];
    follow_inner_chords(node, [&](Node reached, const DoubleDouble& value) {
      if (value.high < kInfinity) offer(copy, reached, cost + value, offset + node);
    });
  }
  if (alive_.empty()) return;
  const Place period = strip_.outer.period();
  const std::vector<Place>& chords = strip_.outer.chord[static_cast<std::size_t>(outer)];
  for (std::size_t i = 0; i < chords.size(); ++i) {
    const bool leads_on = chords[i] >= period;
    const DoubleDouble& value = costs_.outer[static_cast<std::size_t>(outer)][i];
    if (value.high == kInfinity || (leads_on && copy == 1)) continue;
    for (const Node node : alive_) {
      const Node reached =
          leads_on ? find(chords[i] - period, inner_[node] - strip_.inner.period()) : find(chords[i], inner_[node]);
      if (reached == outer_.size()) continue;
      offer(leads_on ? 1 : copy, reached, arrivals_[offset + node].cost + length_[node] + value, offset + node);
    }
  }
}

// Whether the deadline allowed it.
bool StripPaths::search_from(Node start) {
  ++search_;
  start_ = start;
  arrivals_[start] = {0, start, search_};
  for (Place step = 0; step <= strip_.outer.period(); ++step) {
    if (has_passed(deadline_)) return false;
    const Place outer = outer_[start] + step;
    const bool is_next = outer >= strip_.outer.period();
    search_row(is_next ? outer - strip_.outer.period() : outer, is_next ? 1 : 0);
  }
  const Arrival& arrival = arrivals_[outer_.size() + start];
  if (arrival.search != search_ || !(arrival.cost < best_cost_)) return true;
  best_cost_ = arrival.cost;
  best_ = path_found();
  return true;
}

StripPath StripPaths::path_found() const {
  StripPath path;
  const auto nodes = static_cast<Node>(outer_.size());
  for (Node at = nodes + start_;; at = arrivals_[at].from) {
    const bool is_next = at >= nodes;
    const Node node = is_next ? at - nodes : at;
    path.edges.push_back(
        {outer_[node] + (is_next ? strip_.outer.period() : 0), inner_[node] + (is_next ? strip_.inner.period() : 0)});
    if (at == start_) break;
  }
  std::reverse(path.edges.begin(), path.edges.end());
  path.length = best_cost_;
  return path;
}

std::optional<StripPath> StripPaths::lightest(const std::vector<CrossEdge>& starts, double limit) {
  best_cost_ = limit;
  std::vector<Node> nodes;
  for (const CrossEdge& edge : starts) nodes.push_back(find(edge.outer, edge.inner));
  if (!find_bounds(nodes)) return {};
  std::vector<double> bounds(outer_.size(), kInfinity);
  for (const Node node : nodes) {
    const DoubleDouble& next = next_bound_[node];
    if (next.high == kInfinity) continue;  // no cycle leads through it
    bounds[node] = next_down((next - bound_[node]).high - 3 * error_ * next.high);
    bounds[node] = next_down(bounds[node]);
  }
  std::stable_sort(nodes.begin(), nodes.end(), [&](Node a, Node b) { return bounds[a] < bounds[b]; });
  arrivals_.resize(2 * outer_.size());
  const auto best = [&] { return next_down(best_cost_.high * (1 - 0x1p-52)); };
  for (const Node node : nodes) {  // those before it are no shorter than the best path
    lower_bound_ = std::min(bounds[node], best());
    is_complete_ = bounds[node] >= best_cost_.high * kWorthSearching;
    if (is_complete_ || !search_from(node)) return std::move(best_);
  }
  lower_bound_ = best();
  is_complete_ = true;
  return std::move(best_);
}

}  // namespace mwt
