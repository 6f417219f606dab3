#include "algorithms/boolean_model/boolean_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/boolean_model/edge_program.h"
#include "algorithms/boolean_model/model_count.h"
#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/max_points.h"
#include "algorithms/common/solve_scaled.h"
#include "algorithms/greedy/greedy.h"
#include "geometry/convex_hull.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// A branch whose bound is this near to the best model, relatively, is left: the interval stays within 1e-12.
constexpr double kPruningGap = 2e-13;

Interval length_of(Points points, const std::vector<Edge>& edges) {
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

double power_of_two_near_longest(Points points, const CrossingModel& model) {
  double longest = 0;
  for (const Edge& edge : model.edges) longest = std::max(longest, length(points[edge.a], points[edge.b]).high);
  return std::ldexp(1.0, std::ilogb(longest));
}

class ModelSearch {
 public:
  ModelSearch(Points points, const CrossingModel& model, const Deadline& deadline)
      : points_(points),
        model_(model),
        deadline_(deadline),
        unit_(power_of_two_near_longest(points, model)),
        program_(points, model, unit_, deadline_),
        decisions_(model.edges.size()),
        best_(edges_of(greedy_triangulation(points))),
        upper_(length_of(points, best_).upper) {}

  // A certified lower bound on all models: at least the hull, which all contain.
  double run() {
    const double lower = explore(cycle_length(points_, convex_hull(points_)).lower / unit_);
    return std::min(lower, enough()) * unit_;
  }

  [[nodiscard]] const std::vector<Edge>& best() const { return best_; }
  [[nodiscard]] bool is_late() const { return is_late_; }
  [[nodiscard]] std::uint64_t programs() const { return program_.programs(); }
  [[nodiscard]] std::uint64_t branchings() const { return branchings_; }

 private:
  [[nodiscard]] double enough() const { return upper_ / unit_ * (1 - kPruningGap); }

  // The least bound of what obeys the decisions, in units; `known` is one.
  double explore(double known) {
    is_late_ = is_late_ || has_passed(deadline_);
    if (is_late_) return known;
    const double lower = std::max(known, program_.solve(enough()));
    if (lower >= enough()) return lower;
    auto edge = program_.fractional_edge();
    if (!edge) {
      keep_if_model(used_edges());
      if (lower >= enough()) return lower;
      edge = undecided_edge();
    }
    if (!edge) return lowest_of_decided();
    ++branchings_;
    double lowest = std::numeric_limits<double>::infinity();
    const bool first = program_.use(*edge) > 0.5;
    for (const bool is_in : {first, !first}) {
      const std::vector<std::uint32_t> decided = decide(*edge, is_in);
      lowest = std::min(lowest, explore(lower));
      for (const std::uint32_t e : decided) set(e, {});
    }
    return lowest;
  }

  // With the consequences of an edge that is in; returns what was not decided before.
  std::vector<std::uint32_t> decide(std::uint32_t edge, bool is_in) {
    std::vector<std::uint32_t> decided{edge};
    set(edge, is_in);
    if (!is_in) return decided;
    for (const std::uint32_t f : model_.crossing[edge]) {
      if (decisions_[f]) continue;
      set(f, false);
      decided.push_back(f);
    }
    return decided;
  }

  void set(std::uint32_t edge, std::optional<bool> decision) {
    program_.decide(edge, decision);
    decisions_[edge] = decision;
  }

  // Of those that the solution chooses, or of all.
  [[nodiscard]] std::optional<std::uint32_t> undecided_edge() const {
    std::optional<std::uint32_t> result;
    for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
      if (decisions_[e] || model_.crossing[e].empty()) continue;
      if (program_.use(e) > 0.5) return e;
      result = e;
    }
    return result;
  }

  // All edges that others cross are decided: those that are in and the others are a model, or there is none. No model
  // is shorter than the best one known.
  [[nodiscard]] double lowest_of_decided() {
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
      if (decisions_[e].value_or(model_.crossing[e].empty())) chosen.push_back(e);
    }
    return keep_if_model(chosen) ? enough() : std::numeric_limits<double>::infinity();
  }

  [[nodiscard]] std::vector<std::uint32_t> used_edges() const {
    std::vector<std::uint32_t> used;
    for (std::uint32_t e = 0; e < model_.edges.size(); ++e) {
      if (program_.use(e) > 0.5) used.push_back(e);
    }
    return used;
  }

  // Whether the edges are a model: counted and compared, not rounded.
  bool keep_if_model(const std::vector<std::uint32_t>& chosen) {
    if (chosen.size() != model_.size) return false;
    for (const std::uint32_t e : chosen) {
      const auto crosses = [&](std::uint32_t f) { return model_.cross(e, f); };
      if (std::any_of(chosen.begin(), chosen.end(), crosses)) return false;
    }
    std::vector<Edge> edges;
    for (const std::uint32_t e : chosen) edges.push_back(model_.edges[e]);
    const double found = length_of(points_, edges).upper;
    if (found < upper_) {
      upper_ = found;
      best_ = std::move(edges);
    }
    return true;
  }

  Points points_;
  const CrossingModel& model_;
  Deadline deadline_;
  double unit_;
  EdgeProgram program_;
  std::vector<std::optional<bool>> decisions_;
  std::vector<Edge> best_;
  double upper_;
  std::uint64_t branchings_ = 0;
  bool is_late_ = false;
};

Solution solve(Points points, Context& context) {
  require_max_points("boolean_model", points, context);
  const CrossingModel model(points);
  Solution solution;
  ModelSearch search(points, model, deadline_before_heuristics(context.deadline, points.size()));
  const double lower = [&] {
    const ScopedPhase phase(context, "branch_and_cut");
    return search.run();
  }();
  solution.triangulation = triangulation_of(points, search.best());
  const double upper = weight(points, solution.triangulation).upper;
  solution.optimum = {std::min(lower, upper), upper};
  if (search.is_late()) {
    solution.stop_reason = StopReason::deadline;
    improve_by_heuristics(points, context, solution);
  }
  solution.counters = {{"variables", static_cast<double>(model.edges.size())},
                       {"programs", static_cast<double>(search.programs())},
                       {"branchings", static_cast<double>(search.branchings())}};
  if (context.parameters.text("count") != "on") return solution;
  const ScopedPhase phase(context, "count");
  if (const auto models = count_models(model, context.deadline)) {
    if (!models->have_the_same_size) throw std::logic_error("boolean_model: a model is no triangulation");
    solution.count = std::to_string(models->count);
  } else {
    solution.stop_reason = StopReason::deadline;
  }
  return solution;
}

Solution solve_in_range(Points points, Context& context) { return solve_scaled(points, context, solve); }

}  // namespace

AlgorithmInfo boolean_model_entry() {
  AlgorithmInfo info;
  info.name = "boolean_model";
  info.summary = "the source report's Boolean model, one variable per edge, by branch and cut; counts its models too";
  info.source = "source report, section 3";
  info.guarantee = "optimal, up to the certified interval it returns";
  info.time = "exponential, in convex position from 11 points on; linear programs of O(n^2) variables";
  info.space = "O(n^4)";
  info.exactness = Exactness::exact;
  info.max_n = 10;
  info.parameters = {{"max_points", ParameterType::integer, "24", "largest number of points it takes"},
                     {"count", ParameterType::choice, "off", "whether to count the models, one by one", {"off", "on"}}};
  info.function = solve_in_range;
  return info;
}

}  // namespace mwt
