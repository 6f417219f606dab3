#include "algorithms/exact/bounds/side_costs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

double distance(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

std::vector<Edge> every_third(const std::vector<Edge>& edges) {
  std::vector<Edge> chosen;
  for (std::size_t i = 0; i < edges.size(); i += 3) chosen.push_back(edges[i]);
  std::sort(chosen.begin(), chosen.end());
  return chosen;
}

// By the definition.
SideCost plain_cost(Points points, const std::set<Edge>& given, Index p, Index q) {
  SideCost cost;
  cost.edge = distance(points[p], points[q]);
  for (Index z = 0; z < points.size(); ++z) {
    if (orientation(points[p], points[q], points[z]) <= 0) continue;
    const double one = distance(points[p], points[z]), two = distance(points[q], points[z]);
    const bool has_one = given.contains(make_edge(p, z)), has_two = given.contains(make_edge(q, z));
    cost.detour = std::min(cost.detour, one + two);
    if (has_one) cost.diagonal = std::min(cost.diagonal, two);
    if (has_two) cost.diagonal = std::min(cost.diagonal, one);
    cost.is_free = cost.is_free || (has_one && has_two);
  }
  return cost;
}

void expect_at_most(double lower, double value) {
  if (value == SideCost::kNone) {
    EXPECT_EQ(lower, value);
    return;
  }
  EXPECT_LE(lower, value * (1 + 1e-15));
  EXPECT_GE(lower, value * (1 - 1e-12));
}

TEST(SideCosts, AreThoseOfTheDefinition) {
  for (const auto& [name, points] : instances_of_all_families({5, 12, 40, 150}, 2)) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    const auto optimum = solve_to_optimality("exact", points).triangulation;
    const std::vector<Edge> edges = every_third(stage_testing::reordered_edges(order, optimum));
    const std::set<Edge> given(edges.begin(), edges.end());
    const std::vector<SideCost> costs = side_costs(order, edges, {});
    ASSERT_EQ(costs.size(), 2 * edges.size());
    for (std::size_t i = 0; i < costs.size(); ++i) {
      const Edge& edge = edges[i / 2];
      const SideCost plain = i % 2 == 0 ? plain_cost(order.points, given, edge.a, edge.b)
                                        : plain_cost(order.points, given, edge.b, edge.a);
      expect_at_most(costs[i].detour, plain.detour);
      expect_at_most(costs[i].diagonal, plain.diagonal);
      EXPECT_EQ(costs[i].is_free, plain.is_free);
      EXPECT_GE(costs[i].edge, plain.edge * (1 - 1e-15));
    }
  }
}

// For edges of an optimum, whatever the cap: what is above it, of the other edges, and what the sides cost.
TEST(SideCosts, AreBelowTheOptimum) {
  for (const auto& [name, points] : instances_of_all_families({5, 9, 13, 60}, 3)) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    const auto optimum = solve_to_optimality("exact", points).triangulation;
    const std::vector<Edge> all = stage_testing::reordered_edges(order, optimum), edges = every_third(all);
    const std::vector<SideCost> costs = side_costs(order, edges, {});
    for (const double cap : {1e-3, .1, .3, 1.0, 3.0, 1e300, SideCost::kNone}) {
      double capped = 0, paid = 0;
      for (const Edge& edge : all) {
        if (!std::binary_search(edges.begin(), edges.end(), edge))
          capped += std::min(cap, distance(order.points[edge.a], order.points[edge.b]));
      }
      for (const SideCost& side : costs) paid += side.capped(cap);
      EXPECT_LE(paid, capped * (1 + 1e-12)) << cap;
    }
  }
}

TEST(SideCosts, AreNothingAfterTheDeadline) {
  const KdOrder order = make_kd_order(generate("uniform", 500, 1));
  const std::vector<Edge> edges{{0, 1}};
  const std::vector<SideCost> costs = side_costs(order, edges, std::chrono::steady_clock::now());
  EXPECT_EQ(costs[0].capped(1), 0);
  EXPECT_EQ(costs[1].capped(1), 0);
}

}  // namespace
}  // namespace mwt
