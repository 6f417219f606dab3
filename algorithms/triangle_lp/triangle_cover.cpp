#include "algorithms/triangle_lp/triangle_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "algorithms/triangle_lp/cover_balance.h"
#include "algorithms/triangle_lp/cover_model.h"
#include "algorithms/triangle_lp/cover_program.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

constexpr double kProvedWidth = 1e-12;
// A branch whose bound is this near to the best cover, relatively, can be left: the interval stays within kProvedWidth.
constexpr double kPruningGap = 2e-13;

std::vector<Edge> undirected(std::span<const Edge> edges) {
  std::vector<Edge> result;
  for (const Edge& edge : edges) result.push_back(make_edge(edge.a, edge.b));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

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
  return total_length(points, undirected(sides));
}

// Columns to begin with: the known cover and those of least reduced cost.
std::vector<std::uint32_t> first_columns(const CoverModel& model, const CoverCredits& credits,
                                         std::span<const Triangle> start) {
  const std::set<Triangle> known(start.begin(), start.end());
  std::vector<std::uint32_t> columns;
  std::vector<std::pair<double, std::uint32_t>> ranked;
  for (std::uint32_t c = 0; c < model.columns.size(); ++c) {
    if (known.contains(model.columns[c].triangle)) columns.push_back(c);
    ranked.push_back({reduced_cost(model, credits, model.columns[c]), c});
  }
  const auto wanted = std::min(std::max<std::size_t>(500, 10 * model.triangle_count), ranked.size());
  std::partial_sort(ranked.begin(), ranked.begin() + static_cast<std::ptrdiff_t>(wanted), ranked.end());
  for (std::size_t i = 0; i < wanted; ++i) columns.push_back(ranked[i].second);
  return columns;
}

// Depth-first search over decisions on edges that the relaxation uses in part.
class CoverSearch {
 public:
  explicit CoverSearch(const TriangleCoverProblem& problem)
      : problem_(problem),
        model_(problem),
        best_(known_cover(problem)),
        credits_(balanced_credits(model_, problem, cost_of_start())),
        program_(model_, credits_, first_columns(model_, credits_, problem.start), problem.deadline) {}

  TriangleCover run() {
    const double certain = total_length(problem_.points, undirected(problem_.boundary)).lower;
    best_.optimum.lower = std::min(std::max(certain, in_original_unit(explore(0))), best_.optimum.upper);
    best_.programs = program_.programs();
    best_.proved = !best_.triangles.empty() && !best_.stopped_early && best_.optimum.relative_width() <= kProvedWidth;
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

  [[nodiscard]] double cost_of_start() const {
    return best_.triangles.empty() ? 0 : std::ldexp(best_.optimum.upper, -model_.exponent);
  }

  // Rounded down where the result is too small to be represented exactly.
  [[nodiscard]] double in_original_unit(double lower) const {
    const double result = std::ldexp(lower, model_.exponent);
    return std::ldexp(result, -model_.exponent) == lower ? result : next_down(result);
  }

  // A lower bound that makes a branch useless, in the model's unit.
  [[nodiscard]] double enough() const {
    if (best_.triangles.empty()) return model_.largest_cover_cost;
    return std::ldexp(best_.optimum.upper, -model_.exponent) * (1 - kPruningGap);
  }

  bool past_deadline() {
    if (problem_.deadline && std::chrono::steady_clock::now() >= *problem_.deadline) best_.stopped_early = true;
    return best_.stopped_early;
  }

  void keep_if_lightest(std::vector<Triangle> triangles) {
    const Interval found = weight_of_cover(problem_.points, triangles);
    if (found.upper >= best_.optimum.upper) return;
    best_.optimum.upper = found.upper;
    best_.triangles = std::move(triangles);
  }

  // The lower bound of all covers that obey the decisions taken; `known` is one.
  double explore(double known) {
    if (past_deadline()) return known;
    const double lower = std::max(known, program_.solve(enough()));
    if (lower >= enough() || !program_.solved() || past_deadline()) return lower;
    if (auto cover = program_.cover()) {
      keep_if_lightest(std::move(*cover));
      return lower;
    }
    const auto edge = program_.fractional_edge();
    if (!edge) return lower;  // numerical trouble: the interval stays wide
    ++best_.branchings;
    double lowest = std::numeric_limits<double>::infinity();
    for (const EdgeDecision decision : {EdgeDecision::in, EdgeDecision::out}) {
      program_.decide(*edge, decision);
      lowest = std::min(lowest, explore(lower));
    }
    program_.decide(*edge, EdgeDecision::open);
    return lowest;
  }

  const TriangleCoverProblem& problem_;
  const CoverModel model_;
  TriangleCover best_;
  const CoverCredits credits_;  // to begin with
  CoverProgram program_;
};

}  // namespace

TriangleCover lightest_triangle_cover(const TriangleCoverProblem& problem) { return CoverSearch(problem).run(); }

}  // namespace mwt
