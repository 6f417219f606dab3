#include "algorithms/exact/division/crossing_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/faces/face_solver.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/checker.h"

namespace mwt {
namespace {

using stage_testing::instances_of_all_families;

// All pairs of points are candidates; the optimum's edges, of which every third is left out, and the hull are certain.
struct Overfull {
  CandidateGraph graph;
  std::set<Edge> certain;
  std::vector<Edge> candidates;
};

Overfull make_overfull(Points points, const Triangulation& optimum) {
  Overfull result;
  result.certain = naive::hull_edges(points);
  const std::vector<Edge> edges = edges_of(optimum);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i % 3 != 0) result.certain.insert(edges[i]);
  }
  const std::vector<Edge> possible = naive::possible_edges(points);
  for (const Edge& edge : possible) {
    if (!result.certain.contains(edge)) result.candidates.push_back(edge);
  }
  result.graph = naive::make_graph(points, possible, result.certain);
  return result;
}

bool crosses_any(Points points, const Edge& e, const std::set<Edge>& edges) {
  return std::any_of(edges.begin(), edges.end(),
                     [&](const Edge& f) { return segments_cross(points[e.a], points[e.b], points[f.a], points[f.b]); });
}

TEST(CrossingCandidates, AreFoundByDefinition) {
  for (const auto& [name, points] : instances_of_all_families({5, 12, 40})) {
    SCOPED_TRACE(name);
    const auto [graph, certain, candidates] = make_overfull(points, solve_to_optimality("exact", points).triangulation);
    std::vector<Edge> expected;
    for (const Edge& edge : candidates) {
      if (crosses_any(points, edge, certain)) expected.push_back(edge);
    }
    EXPECT_EQ(find_crossing_candidates(graph, candidates).value(), expected);
  }
}

TEST(CrossingCandidates, IncludeThoseThroughIsolatedPoints) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 4}};
  const std::vector<Edge> edges{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  const CandidateGraph graph = naive::make_graph(points, edges, naive::hull_edges(points));
  const std::vector<Edge> suspects{{0, 2}, {0, 4}, {1, 4}};
  EXPECT_EQ(find_crossing_candidates(graph, suspects).value(), (std::vector<Edge>{{0, 2}}));
  EXPECT_FALSE(find_crossing_candidates(graph, suspects, std::chrono::steady_clock::now()));
}

TEST(CrossingCandidates, AreDeletedFromBothStars) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  CandidateGraph less = naive::make_graph(points, naive::possible_edges(points), naive::hull_edges(points));
  remove_edges(less, std::vector<Edge>{{0, 2}});
  const std::vector<Edge> rest{{0, 1}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  const CandidateGraph expected = naive::make_graph(points, rest, naive::hull_edges(points));
  EXPECT_EQ(less.first, expected.first);
  EXPECT_EQ(less.target, expected.target);
  EXPECT_EQ(less.certain, expected.certain);
}

TEST(CrossingCandidates, AreDeletedOneByOneAsAllAtOnce) {
  for (const auto& [name, points] : instances_of_all_families({12, 40})) {
    SCOPED_TRACE(name);
    const std::vector<Edge> edges = naive::possible_edges(points);
    const std::set<Edge> hull = naive::hull_edges(points);
    std::vector<Edge> removed, rest;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      (i % 3 == 0 && !hull.contains(edges[i]) ? removed : rest).push_back(edges[i]);
    }
    CandidateGraph less = naive::make_graph(points, edges, hull);
    remove_edges(less, removed);
    const CandidateGraph expected = naive::make_graph(points, rest, hull);
    EXPECT_EQ(less.first, expected.first);
    EXPECT_EQ(less.certain, expected.certain);
    for (Index v = 0; v < points.size(); ++v) {
      EXPECT_TRUE(std::ranges::is_permutation(less.star(v), expected.star(v)));
    }
  }
}

// The face solver deletes them by itself, whether they lead out of their faces or cut across a notch of one.
TEST(CrossingCandidates, DoNotMisleadTheFaceSolver) {
  for (const auto& [name, points] : instances_of_all_families({5, 8, 12, 25}, 3)) {
    SCOPED_TRACE(name);
    const Solution reference = solve_to_optimality("exact", points);
    Overfull overfull = make_overfull(points, reference.triangulation);
    Context context;
    const FaceSolution solution = solve_faces(overfull.graph, context);
    const Triangulation triangulation{static_cast<Index>(points.size()), solution.triangles};
    const auto violation = find_violation(points, triangulation);
    ASSERT_FALSE(violation) << violation->message;
    EXPECT_TRUE(solution.proved);
    EXPECT_TRUE(overlap(solution.optimum, *reference.optimum));
  }
}

// An L-shaped face of certain edges, with the diagonal across its notch, which is shorter than all others.
TEST(CrossingCandidates, ThatCutACornerOutsideTheFaceAreNotTaken) {
  const std::vector<Point> points{{0, 0}, {10, 0}, {10, 10}, {6, 10}, {5.5, 4}, {4, 10}, {0, 10}};
  std::set<Edge> certain{{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {0, 6}};
  certain.insert({3, 5});
  CandidateGraph graph = naive::graph_with_certain(points, certain);
  Context context;
  const FaceSolution solution = solve_faces(graph, context);
  EXPECT_TRUE(solution.proved);
  const auto edges = naive::possible_edges(points);
  const FaceSolution misled = solve_faces(naive::make_graph(points, edges, certain), context);
  EXPECT_TRUE(misled.proved);
  EXPECT_EQ(misled.optimum, solution.optimum);
}

}  // namespace
}  // namespace mwt
