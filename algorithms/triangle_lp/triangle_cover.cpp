#include "algorithms/triangle_lp/triangle_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// For each edge, how many shorter edges its ends have: the smaller of the two numbers.
std::vector<std::uint32_t> nearness_ranks(const CoverModel& model) {
  std::vector<std::uint32_t> by_length(model.edges.size());
  for (std::uint32_t e = 0; e < by_length.size(); ++e) by_length[e] = e;
  const auto length_of = [&](std::uint32_t e) {
    return model.side_cost[forward_side(e)].high + model.side_cost[backward_side(e)].high;
  };
  std::stable_sort(by_length.begin(), by_length.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return length_of(a) < length_of(b); });
  Index vertices = 0;
  for (const Edge& edge : model.edges) vertices = std::max(vertices, edge.b + 1);
  std::vector<std::uint32_t> degree(vertices, 0);
  std::vector<std::uint32_t> rank(model.edges.size());
  for (const std::uint32_t e : by_length) {
    std::uint32_t& a = degree[model.edges[e].a];
    std::uint32_t& b = degree[model.edges[e].b];
    rank[e] = std::min(a++, b++);
  }
  return rank;
}

// Columns to begin with: all if they are few, otherwise the triangles on the shortest edges.
std::vector<std::uint32_t> first_columns(const CoverModel& model) {
  const std::vector<std::uint32_t> rank = nearness_ranks(model);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ranked;
  for (std::uint32_t c = 0; c < model.columns.size(); ++c) {
    const auto [p, q, r] = model.columns[c].sides;
    ranked.push_back({std::max({rank[edge_of(p)], rank[edge_of(q)], rank[edge_of(r)]}), c});
  }
  std::sort(ranked.begin(), ranked.end());
  const std::size_t wanted = std::max<std::size_t>(500, 3 * model.triangle_count);
  if (ranked.size() > wanted) ranked.resize(wanted);
  std::vector<std::uint32_t> columns;
  for (const auto& [r, c] : ranked) columns.push_back(c);
  return columns;
}

// Depth-first search over decisions on edges that the relaxation uses in part.
class CoverSearch {
 public:
  CoverSearch(const TriangleCoverProblem& problem)
      : problem_(problem), model_(problem), program_(model_, first_columns(model_), problem.deadline) {
    best_.optimum = {0, std::numeric_limits<double>::infinity()};
  }

  TriangleCover run() {
    const double certain = total_length(problem_.points, undirected(problem_.boundary)).lower;
    best_.optimum.lower = std::min(std::max(certain, in_original_unit(explore(0))), best_.optimum.upper);
    best_.programs = program_.programs();
    best_.proved = !best_.triangles.empty() && !best_.stopped_early && best_.optimum.relative_width() <= kProvedWidth;
    return std::move(best_);
  }

 private:
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
  CoverProgram program_;
  TriangleCover best_;
};

}  // namespace

TriangleCover lightest_triangle_cover(const TriangleCoverProblem& problem) { return CoverSearch(problem).run(); }

}  // namespace mwt
