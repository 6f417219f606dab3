#include "algorithms/triangle_lp/triangle_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/triangle_lp/cover_balance.h"
#include "algorithms/triangle_lp/cover_flow.h"
#include "algorithms/triangle_lp/cover_model.h"
#include "algorithms/triangle_lp/cover_program.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

// A branch whose bound is this near to the best cover, relatively, is pruned: the interval stays well within
// kProvedRelativeWidth.
constexpr double kPruningGap = 2e-13;

Interval total_length(Points points, const std::vector<Edge>& edges) {
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return sum.enclosure();
}

Interval weight_of_cover(Points points, const std::vector<Triangle>& triangles) {
  std::vector<Edge> sides;
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) sides.push_back(directed_edge(triangle, i));
  }
  return total_length(points, undirected_edges(std::move(sides)));
}

// Depth-first search over decisions on edges that the relaxation uses in part.
class CoverSearch {
 public:
  explicit CoverSearch(const TriangleCoverProblem& problem)
      : problem_(problem),
        model_(problem),
        best_(known_cover(problem)),
        duals_(duals_of_cover(model_, problem.points, problem.start)) {}

  TriangleCover run() {
    const double certain =
        total_length(problem_.points, undirected_edges({problem_.boundary.begin(), problem_.boundary.end()})).lower;
    reduce();
    if (lower_ < enough() && !past_deadline()) {
      program_.emplace(model_, duals_, promising_columns(model_, duals_, best_.triangles, 10), problem_.deadline);
      lower_ = explore(lower_);
      best_.programs += program_->programs();
    }
    best_.optimum.lower = std::min(std::max(certain, in_original_unit(lower_)), best_.optimum.upper);
    best_.proved = !best_.triangles.empty() && best_.optimum.relative_width() <= kProvedRelativeWidth;
    best_.stop_reason = stop_reason();
    return std::move(best_);
  }

 private:
  static TriangleCover known_cover(const TriangleCoverProblem& problem) {
    TriangleCover known;
    known.triangles.assign(problem.start.begin(), problem.start.end());
    known.optimum.upper = known.triangles.empty() ? std::numeric_limits<double>::infinity()
                                                  : weight_of_cover(problem.points, known.triangles).upper;
    return known;
  }

  // Rounded down where the result is too small to be represented exactly.
  [[nodiscard]] double in_original_unit(double lower) const {
    const double result = std::ldexp(lower, model_.exponent);
    return std::ldexp(result, -model_.exponent) == lower ? result : next_down(result);
  }

  // What the best known cover costs at most, or any cover if none is known, in the model's unit.
  [[nodiscard]] double upper() const {
    return best_.triangles.empty() ? model_.max_cover_cost : std::ldexp(best_.optimum.upper, -model_.exponent);
  }

  // A lower bound that makes a branch useless.
  [[nodiscard]] double enough() const { return upper() * (1 - kPruningGap); }

  bool past_deadline() {
    stopped_ = stopped_ || has_passed(problem_.deadline);
    return stopped_;
  }

  [[nodiscard]] std::optional<StopReason> stop_reason() const {
    if (stopped_) return StopReason::deadline;
    if (best_.proved || best_.triangles.empty()) return {};
    return StopReason::precision;
  }

  void keep_if_lightest(std::vector<Triangle> triangles) {
    const Interval found = weight_of_cover(problem_.points, triangles);
    if (found.upper >= best_.optimum.upper) return;
    best_.optimum.upper = found.upper;
    best_.triangles = std::move(triangles);
  }

  // Drops columns that only covers no lighter than the best known one have, as long as that helps. Bounds from here on
  // are bounds on what the other covers cost: the optimum may also be the best known cover.
  void reduce() {
    constexpr double kWorthwhile = 0.8;
    bool shrinking = true;
    while (shrinking && lower_ < enough() && !past_deadline()) {
      const std::size_t before = model_.columns.size();
      balance_duals(model_, duals_, problem_.deadline);
      lower_ = std::max(lower_, price(model_, duals_).lower);
      if (before <= kFewColumns) return;
      find_restricted_covers();
      drop_useless_columns();
      shrinking = static_cast<double>(model_.columns.size()) < kWorthwhile * static_cast<double>(before);
    }
  }

  // Solves the program over more and more of the promising columns until a cover is found that is nearly optimal.
  void find_restricted_covers() {
    constexpr double kNearly = 1e-4;  // a gap that leaves so few columns that the whole program is solved soon
    for (std::size_t per_triangle = 10; per_triangle <= 80 && !past_deadline(); per_triangle *= 2) {
      CoverProgram restricted(model_, duals_, promising_columns(model_, duals_, best_.triangles, per_triangle),
                              problem_.deadline);
      lower_ = std::max(lower_, restricted.solve(enough(), 1));
      best_.programs += restricted.programs();
      if (!restricted.solved()) return;
      if (auto cover = restricted.cover()) keep_if_lightest(std::move(*cover));
      const bool has_all = per_triangle * model_.triangle_count >= model_.columns.size();
      if (has_all || enough() - lower_ <= kNearly * enough()) return;
    }
  }

  // A cover with column c costs at least what all covers cost plus c's reduced cost.
  void drop_useless_columns() {
    const double enough_reduced_cost = next_up(upper() - price(model_, duals_).lower);
    std::erase_if(model_.columns, [&](const CoverModel::Column& column) {
      return min_reduced_cost(model_, duals_, column) >= enough_reduced_cost;
    });
  }

  // The lower bound of all covers that obey the decisions taken; `known` is one.
  double explore(double known) {
    if (known >= enough() || past_deadline()) return known;
    const double lower = std::max(known, program_->solve(enough()));
    if (lower >= enough() || past_deadline() || !program_->solved()) return lower;
    if (auto cover = program_->cover()) {
      keep_if_lightest(std::move(*cover));
      return lower;
    }
    const auto edge = program_->fractional_edge();
    if (!edge) return lower;  // numerical trouble: the interval stays wide
    ++best_.branchings;
    double lowest = std::numeric_limits<double>::infinity();
    for (const EdgeDecision decision : {EdgeDecision::in, EdgeDecision::out}) {
      program_->decide(*edge, decision);
      lowest = std::min(lowest, explore(lower));
    }
    program_->decide(*edge, EdgeDecision::open);
    return lowest;
  }

  const TriangleCoverProblem& problem_;
  CoverModel model_;
  TriangleCover best_;
  CoverDuals duals_;      // to begin with
  double lower_ = 0;      // certified, in the model's unit
  bool stopped_ = false;  // by the deadline
  std::optional<CoverProgram> program_;
};

}  // namespace

TriangleCover lightest_triangle_cover(const TriangleCoverProblem& problem) { return CoverSearch(problem).run(); }

}  // namespace mwt
