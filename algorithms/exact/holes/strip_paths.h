// Lightest ways through a strip: from an edge across it to the same edge one period on.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/strip.h"
#include "geometry/numbers/double_double.h"

namespace mwt {

/// What the part that each chord of a chain cuts off costs at least, the chord's own length included: beside
/// Strip::Chain::chord. Infinite where it cannot be triangulated.
using ChordValues = std::vector<std::vector<DoubleDouble>>;

struct StripCosts {
  Points points;  ///< of the strip's vertices
  ChordValues outer;
  ChordValues inner;
};

/// A triangulation of one period as a sequence of edges across: the first one, and those that follow it, the last being
/// the first one period on. Two that follow each other differ in one place and span a triangle.
struct StripPath {
  std::vector<CrossEdge> edges;  ///< in places that go on counting: outer places up to two periods
  DoubleDouble length;           ///< of its edges across, the first one once, and the chords' costs
};

/// Finds the lightest path among those that begin with one of the `starts`, and a certified bound on all of them.
///
/// A path with one period is a cycle in the graph of all edges across, modulo periods; arcs lead from (A, S) to (B, S),
/// A < B, at the cost of chord (A, B) and the edge across (B, S), and to (A, T), S < T, likewise. If D(e, k) is the
/// least cost of a path from any of the starts to edge e in the k-th copy of the period, then a cycle through e costs
/// at least D(e, k + 1) - D(e, k), since it can follow any path. Only starts for which this is less than the lightest
/// path known are searched on their own, and there only edges from which, by the same argument, the goal is near
/// enough.
class StripPaths {
 public:
  StripPaths(const Strip& strip, const StripCosts& costs, const Deadline& deadline);

  /// Nothing if the deadline stops it before any path is known, or if there is none. O(arcs) for the bounds, then
  /// according to how many starts they leave.
  /// `limit`: nothing either if no path is shorter than this; then lower_bound() may be as little as the limit.
  [[nodiscard]] std::optional<StripPath> lightest(const std::vector<CrossEdge>& starts, double limit);

  /// After lightest(): no path through any of the starts is shorter; certified.
  [[nodiscard]] double lower_bound() const { return lower_bound_; }

  /// Whether the deadline left time for all starts that might have been better.
  [[nodiscard]] bool is_complete() const { return is_complete_; }

 private:
  using Node = std::uint32_t;
  using Place = Strip::Place;
  using Costs = std::vector<DoubleDouble>;  // of the best paths to nodes of one copy, without the last edge's length
  struct Row {
    Node first = 0;
    Node last = 0;
  };
  struct Arrival {
    DoubleDouble cost;
    Node from = 0;  // numbered over both copies
    std::uint32_t search = 0;
  };

  [[nodiscard]] Node find(Place outer, Place inner) const;
  template <class Offer>
  void follow_inner_chords(Node node, const Offer& offer) const;
  template <class Offer>
  void follow_outer_chord(Row row, Place to, const DoubleDouble& value, const Offer& offer) const;
  [[nodiscard]] bool pass_over_period(Costs& here, Costs& next) const;
  [[nodiscard]] bool find_bounds(const std::vector<Node>& starts);
  [[nodiscard]] bool search_from(Node start);
  void search_row(Place outer, std::size_t copy);
  [[nodiscard]] bool is_near_enough(const Arrival& arrival, std::size_t copy, Node node) const;
  void offer(std::size_t copy, Node node, const DoubleDouble& cost, Node from);
  [[nodiscard]] StripPath path_found() const;

  const Strip& strip_;
  const StripCosts& costs_;
  const Deadline& deadline_;
  std::vector<Row> rows_;     // by outer place: its nodes, the edges across from there
  std::vector<Place> outer_;  // by node
  std::vector<Place> inner_;
  std::vector<DoubleDouble> length_;
  double error_ = 0;  // relative, of the cost of any path

  Costs bound_;       // D(e, 1)
  Costs next_bound_;  // D(e, 2)
  double lower_bound_ = 0;
  bool is_complete_ = false;

  // The search from one start: in the copy it lies in and the next.
  std::vector<Arrival> arrivals_;  // by node, then the same for the next copy
  std::vector<Node> alive_;
  std::uint32_t search_ = 0;
  Node start_ = 0;
  DoubleDouble best_cost_;
  std::optional<StripPath> best_;
};

}  // namespace mwt
