#include "algorithms/triangle_lp/cover_model.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace mwt {

namespace {

// Gives each undirected edge a number when it is first seen.
class EdgeNumbers {
 public:
  explicit EdgeNumbers(std::vector<Edge>& edges) : edges_(edges) {}

  Side side(Index from, Index to) {
    const Edge edge = make_edge(from, to);
    const std::uint64_t key = (std::uint64_t{edge.a} << 32) | edge.b;
    const auto [place, is_new] = number_.try_emplace(key, static_cast<std::uint32_t>(edges_.size()));
    if (is_new) edges_.push_back(edge);
    return from == edge.a ? forward_side(place->second) : backward_side(place->second);
  }

 private:
  std::vector<Edge>& edges_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
};

// The exponent of a power of two just above the longest edge's extent.
int unit_exponent(Points points, const std::vector<Edge>& edges) {
  double size = 0;
  for (const Edge& edge : edges) {
    const Point &p = points[edge.a], &q = points[edge.b];
    size = std::max({size, std::abs(p.x - q.x), std::abs(p.y - q.y)});
  }
  return size > 0 ? std::ilogb(size) + 1 : 0;
}

// Coordinates far below the unit may underflow: an error below 2^-1000, which pricing allows for.
DoubleDouble length_in_unit(const Point& p, const Point& q, int exponent) {
  const auto scaled = [&](const Point& a) { return Point{std::ldexp(a.x, -exponent), std::ldexp(a.y, -exponent)}; };
  return length(scaled(p), scaled(q));
}

DoubleDouble halved(const DoubleDouble& a) { return {0.5 * a.high, 0.5 * a.low}; }

std::vector<DoubleDouble> costs_of_sides(Points points, const CoverModel& model) {
  std::vector<DoubleDouble> costs;
  for (Side side = 0; side < 2 * model.edges.size(); ++side) {
    const Edge& edge = model.edges[edge_of(side)];
    const DoubleDouble whole = length_in_unit(points[edge.a], points[edge.b], model.exponent);
    const bool one_way = model.on_boundary[side] && !model.on_boundary[reversed(side)];
    costs.push_back(one_way ? whole : halved(whole));
  }
  return costs;
}

// Error bounds, relative to the sum of the magnitudes of all terms.
constexpr double kDoubleError = 0x1p-49;           // six terms, each operation errs by 2^-53
constexpr double kDoubleDoubleSumError = 0x1p-90;  // lengths err by 2^-97, each of the few additions by 2^-100
constexpr double kUnderflow = 0x1p-1000;           // absolute: what coordinates far below the unit lose

// Makes a product of rounded costs an upper bound: far above the few roundings of 2^-53 in it.
constexpr double kRoundUp = 1 + 0x1p-40;

// A sum of signed double-doubles and the magnitude to which its error is relative.
struct SignedSum {
  DoubleDouble sum;
  double magnitude = 0;

  void add(const DoubleDouble& term) {
    sum += term;
    magnitude += std::abs(term.high);
  }
  [[nodiscard]] double lower(double relative_error) const {
    return next_down(sum.high + (sum.low - (relative_error * magnitude + kUnderflow)));
  }
};

SignedSum precise_reduced_cost(const CoverModel& model, const CoverDuals& duals, const CoverModel::Column& column) {
  SignedSum total;
  for (const Side side : column.sides) {
    total.add(model.side_cost[side]);
    total.add(-duals.of_side[side]);
  }
  return total;
}

// A cheap proof that a column's reduced cost is not negative.
class PricingFilter {
 public:
  PricingFilter(const CoverModel& model, const CoverDuals& duals) {
    for (Side side = 0; side < model.side_cost.size(); ++side) {
      const double cost = model.side_cost[side].high, dual = duals.of_side[side];
      sides_.push_back({cost - dual, kDoubleError * (cost + std::abs(dual)) + kUnderflow});
    }
  }

  [[nodiscard]] bool proves_non_negative(const CoverModel::Column& column) const {
    const auto [a, b, c] = column.sides;
    return sides_[a].price + sides_[b].price + sides_[c].price >= sides_[a].error + sides_[b].error + sides_[c].error;
  }

 private:
  struct PricedSide {
    double price;
    double error;
  };
  std::vector<PricedSide> sides_;
};

// The dual values that every cover collects, whichever triangles it has.
SignedSum certain_dual(const CoverModel& model, const CoverDuals& duals) {
  SignedSum total;
  for (Side side = 0; side < model.on_boundary.size(); ++side) {
    const bool covered_once = model.on_boundary[side] || duals.decisions[edge_of(side)] == EdgeDecision::in;
    if (covered_once) total.add(duals.of_side[side]);
  }
  return total;
}

}  // namespace

CoverModel::CoverModel(const TriangleCoverProblem& problem) : triangle_count(problem.triangle_count) {
  EdgeNumbers numbers(edges);
  std::vector<Side> boundary;
  for (const Edge& edge : problem.boundary) boundary.push_back(numbers.side(edge.a, edge.b));
  columns.reserve(problem.triangles.size());
  for (const Triangle& t : problem.triangles) {
    columns.push_back({t, {numbers.side(t[0], t[1]), numbers.side(t[1], t[2]), numbers.side(t[2], t[0])}});
  }
  on_boundary.assign(2 * edges.size(), 0);
  for (const Side side : boundary) on_boundary[side] = 1;
  std::erase_if(columns, [&](const Column& column) {
    return std::any_of(column.sides.begin(), column.sides.end(),
                       [&](Side side) { return !on_boundary[side] && on_boundary[reversed(side)]; });
  });
  exponent = unit_exponent(problem.points, edges);
  side_cost = costs_of_sides(problem.points, *this);
  for (const Column& column : columns) max_cover_cost = std::max(max_cover_cost, cost(column));
  max_cover_cost *= static_cast<double>(triangle_count) * kRoundUp;
}

double CoverModel::cost(const Column& column) const {
  const auto [a, b, c] = column.sides;
  return side_cost[a].high + side_cost[b].high + side_cost[c].high;
}

double reduced_cost(const CoverModel& model, const CoverDuals& duals, const CoverModel::Column& column) {
  return precise_reduced_cost(model, duals, column).sum.high;
}

double min_reduced_cost(const CoverModel& model, const CoverDuals& duals, const CoverModel::Column& column) {
  return precise_reduced_cost(model, duals, column).lower(kDoubleDoubleSumError);
}

CoverPricing price(const CoverModel& model, const CoverDuals& duals) {
  CoverPricing result;
  const PricingFilter filter(model, duals);
  for (std::uint32_t c = 0; c < model.columns.size(); ++c) {
    if (filter.proves_non_negative(model.columns[c])) continue;
    const SignedSum reduced = precise_reduced_cost(model, duals, model.columns[c]);
    result.worst = std::min(result.worst, reduced.lower(kDoubleDoubleSumError));
    if (reduced.sum.high < 0) result.violated.push_back({c, reduced.sum.high});
  }
  SignedSum bound = certain_dual(model, duals);
  result.dual = bound.sum.high;
  bound.add(exact_product(static_cast<double>(model.triangle_count), result.worst));
  const double terms = static_cast<double>(model.on_boundary.size());
  result.lower = bound.lower((terms + 8) * kDoubleDoubleError);
  return result;
}

}  // namespace mwt
