#include "algorithms/exact/candidates/certain_edges.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <random>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

using stage_testing::candidate_graph;
using stage_testing::instances_of_all_families;
using stage_testing::reordered_edges;

// Each edge of the graph once, a < b, ascending.
std::vector<Edge> edges_of_graph(const CandidateGraph& graph, bool only_certain) {
  std::vector<Edge> edges;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t i = graph.first[v]; i < graph.first[v + std::size_t{1}]; ++i) {
      const bool is_wanted = !only_certain || graph.certain[i] == 1;
      if (v < graph.target[i] && is_wanted) edges.push_back({v, graph.target[i]});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

// Property (1), first half: each edge in both stars, once, with the same mark.
void expect_symmetric(const CandidateGraph& graph) {
  ASSERT_EQ(graph.certain.size(), graph.target.size());
  std::vector<std::tuple<Index, Index, int>> forwards, backwards;
  for (Index v = 0; v < graph.points.size(); ++v) {
    for (std::uint32_t i = graph.first[v]; i < graph.first[v + std::size_t{1}]; ++i) {
      forwards.emplace_back(v, graph.target[i], graph.certain[i]);
      backwards.emplace_back(graph.target[i], v, graph.certain[i]);
    }
  }
  std::sort(forwards.begin(), forwards.end());
  std::sort(backwards.begin(), backwards.end());
  EXPECT_EQ(forwards, backwards);
  EXPECT_EQ(std::adjacent_find(forwards.begin(), forwards.end()), forwards.end()) << "an edge stands twice";
}

// Property (1), second half. The edges by x, so that only points between its ends are examined.
void expect_no_point_on_edges(const CandidateGraph& graph) {
  const std::vector<Index> by_x = lexicographic_order(graph.points);
  std::vector<Index> rank(by_x.size());
  for (Index i = 0; i < by_x.size(); ++i) rank[by_x[i]] = i;
  for (const auto& [a, b] : edges_of_graph(graph, false)) {
    for (Index i = std::min(rank[a], rank[b]) + 1; i < std::max(rank[a], rank[b]); ++i) {
      ASSERT_FALSE(in_segment_interior(graph.points[by_x[i]], graph.points[a], graph.points[b]))
          << "point " << by_x[i] << " on edge " << a << ' ' << b;
    }
  }
}

// Property (2): going round a star, directions turn left and go round once.
void expect_stars_in_order(const CandidateGraph& graph) {
  for (Index v = 0; v < graph.points.size(); ++v) {
    const auto star = graph.star(v);
    const Point& center = graph.points[v];
    const auto is_below = [&](Index w) {
      const Point& p = graph.points[w];
      return p.y < center.y || (p.y == center.y && p.x < center.x);
    };
    std::size_t turns_of_side = 0;
    for (std::size_t i = 0; i < star.size(); ++i) {
      const Index one = star[i], next = star[(i + 1) % star.size()];
      if (is_below(one) != is_below(next)) {
        ++turns_of_side;
      } else if (star.size() > 1 && i + 1 < star.size()) {
        ASSERT_GT(orientation(center, graph.points[one], graph.points[next]), 0) << "at " << v;
      }
    }
    ASSERT_LE(turns_of_side, 2U) << "at " << v;
  }
}

struct Crossing {
  Edge candidate;
  Edge certain;
};

// Of certain edges: property (4). Of other candidates: not promised, but true of families whose scales do not jump.
// Over pairs of edges whose boxes meet.
std::vector<Crossing> crossings_of_certain_edges(const CandidateGraph& graph) {
  struct BoxedEdge {
    Edge edge;
    Box box;
    bool is_certain;
  };
  const std::vector<Edge> certain = edges_of_graph(graph, true);
  std::vector<BoxedEdge> edges;
  for (const Edge& edge : edges_of_graph(graph, false)) {
    const Point &a = graph.points[edge.a], &b = graph.points[edge.b];
    edges.push_back({edge,
                     {std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)},
                     std::binary_search(certain.begin(), certain.end(), edge)});
  }
  const auto starts_before = [](const BoxedEdge& e, const BoxedEdge& f) { return e.box.min_x < f.box.min_x; };
  std::sort(edges.begin(), edges.end(), starts_before);
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto& [e, box, e_is_certain] = edges[i];
    for (std::size_t j = i + 1; j < edges.size() && edges[j].box.min_x <= box.max_x; ++j) {
      const auto& [f, other, f_is_certain] = edges[j];
      if ((!e_is_certain && !f_is_certain) || other.min_y > box.max_y || other.max_y < box.min_y) continue;
      if (segments_cross(graph.points[e.a], graph.points[e.b], graph.points[f.a], graph.points[f.b])) {
        found.push_back(e_is_certain ? Crossing{f, e} : Crossing{e, f});
      }
    }
  }
  return found;
}

void expect_nothing_crosses_certain_edges(const CandidateGraph& graph, bool not_even_candidates) {
  const std::vector<Edge> all_certain = edges_of_graph(graph, true);
  for (const auto& [candidate, certain] : crossings_of_certain_edges(graph)) {
    const bool is_certain = std::binary_search(all_certain.begin(), all_certain.end(), candidate);
    if (!is_certain && !not_even_candidates) continue;
    ADD_FAILURE() << "candidate " << candidate.a << ' ' << candidate.b << " crosses certain edge " << certain.a << ' '
                  << certain.b;
  }
}

void expect_certain_hull(const CandidateGraph& graph) {
  const std::vector<Edge> certain = edges_of_graph(graph, true);
  const std::vector<Index> hull = convex_hull(graph.points);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Edge edge = make_edge(hull[i], hull[(i + 1) % hull.size()]);
    EXPECT_TRUE(std::binary_search(certain.begin(), certain.end(), edge)) << edge.a << ' ' << edge.b;
  }
}

void expect_properties(const CandidateGraph& graph, bool scales_jump_in_it = false) {
  expect_symmetric(graph);
  expect_no_point_on_edges(graph);
  expect_stars_in_order(graph);
  expect_nothing_crosses_certain_edges(graph, !scales_jump_in_it);
  expect_certain_hull(graph);
}

bool scales_jump(const std::string& name) {
  return name.starts_with("cluster_in_triangle") || name.starts_with("insertion_trap");
}

TEST(CertainEdges, HaveTheirPropertiesOnAllFamilies) {
  for (const auto& [name, points] : instances_of_all_families({3, 4, 5, 10, 30, 100, 200})) {
    SCOPED_TRACE(name);
    expect_properties(candidate_graph(make_kd_order(points)), scales_jump(name));
    if (HasFailure()) return;
  }
}

TEST(CertainEdges, HaveTheirPropertiesOnThousandsOfPoints) {
  for (const char* family : {"uniform", "normal", "clustered", "lattice", "integer_uniform", "far_from_origin"}) {
    SCOPED_TRACE(family);
    expect_properties(candidate_graph(make_kd_order(generate(family, 4000, 1))));
    if (HasFailure()) return;
  }
}

TEST(CertainEdgesSlow, HaveTheirPropertiesOnManyInstances) {
  for (const auto& [name, points] : instances_of_all_families({8, 13, 20, 50, 150}, 10)) {
    SCOPED_TRACE(name);
    expect_properties(candidate_graph(make_kd_order(points)), scales_jump(name));
    if (HasFailure()) return;
  }
}

// All optima: a certain edge belongs to each of them, and each consists of candidates.
void expect_certain_edges_in_optimum(Points points, const std::string& solver) {
  const KdOrder order = make_kd_order(points);
  const CandidateGraph graph = candidate_graph(order);
  std::vector<Edge> optimum = reordered_edges(order, solve_to_optimality(solver, points).triangulation);
  std::sort(optimum.begin(), optimum.end());
  const std::vector<Edge> candidates = edges_of_graph(graph, false), certain = edges_of_graph(graph, true);
  EXPECT_TRUE(std::includes(candidates.begin(), candidates.end(), optimum.begin(), optimum.end()));
  EXPECT_TRUE(std::includes(optimum.begin(), optimum.end(), certain.begin(), certain.end()));
}

TEST(CertainEdges, BelongToTheOptimum) {
  for (const auto& [name, points] : instances_of_all_families({4, 6, 8, 10, 12}, 3)) {
    SCOPED_TRACE(name);
    expect_certain_edges_in_optimum(points, "subset_dp");
  }
  for (const auto& [name, points] : instances_of_all_families({32})) {
    SCOPED_TRACE(name);
    expect_certain_edges_in_optimum(points, "triangle_lp");
  }
}

TEST(CertainEdgesSlow, BelongToTheOptimum) {
  for (const auto& [name, points] : instances_of_all_families({13}, 10)) {
    SCOPED_TRACE(name);
    expect_certain_edges_in_optimum(points, "subset_dp");
  }
  for (const auto& [name, points] : instances_of_all_families({60}, 4)) {
    SCOPED_TRACE(name);
    expect_certain_edges_in_optimum(points, "triangle_lp");
  }
}

TEST(CertainEdges, AreMostOfUniformOptima) {
  const CandidateGraph graph = candidate_graph(make_kd_order(generate("uniform", 20'000, 1)));
  const double n = 20'000;
  EXPECT_LT(static_cast<double>(edges_of_graph(graph, false).size()) / n, 4.2);
  EXPECT_GT(static_cast<double>(edges_of_graph(graph, true).size()) / n, 2.3);
}

// By definition: an edge to a later point is certain unless an edge between neighbours of its smaller end crosses it.
TEST(CertainEdges, InLargeStarsAreThoseOfTheDefinition) {
  std::size_t in_large_stars = 0;
  for (const auto& points : {generate("roads", 500, 1), generate("wheel", 150, 1), generate("greedy_corridor", 160, 1),
                             generate("spiral", 400, 1), generate("cluster_in_triangle", 200, 1)}) {
    const KdOrder order = make_kd_order(points);
    const CandidateGraph graph = candidate_graph(order);
    const std::vector<Edge> edges = edges_of_graph(graph, false), certain = edges_of_graph(graph, true);
    for (const auto& [s, t] : edges) {
      const auto star = graph.star(s);
      if (star.size() <= 64) continue;
      ++in_large_stars;
      const bool is_crossed = std::any_of(star.begin(), star.end(), [&](Index y) {
        return y != t && std::any_of(star.begin(), star.end(), [&](Index w) {
                 return y < w && w != t && std::binary_search(edges.begin(), edges.end(), Edge{y, w}) &&
                        segments_cross(graph.points[y], graph.points[w], graph.points[s], graph.points[t]);
               });
      });
      EXPECT_EQ(std::binary_search(certain.begin(), certain.end(), Edge{s, t}), !is_crossed) << s << ' ' << t;
    }
  }
  EXPECT_GT(in_large_stars, 1000U);
}

// Stars made by hand: four points of a square around a fifth, one edge hidden by the centre.
TEST(CertainEdges, DropTheFartherOfTwoNeighboursInOneDirection) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  const std::vector<Edge> edges{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 4}, {1, 4}, {2, 4}, {3, 4}, {0, 2}};
  StarTable table;
  table.stars.resize(points.size());
  table.arenas.emplace_back(8 * points.size());
  for (Index v = 0; v < points.size(); ++v) {
    Star& star = table.stars[v];
    star = table.arenas[0].allot(8);
    for (const auto& [a, b] : edges) {
      if (a == v) star.append(b, 0, 0);
      if (b == v) star.append(a, 0, 0);
    }
  }
  const CandidateGraph graph = mark_certain_edges(points, table, Context{});
  expect_properties(graph);
  const std::vector<Edge> expected{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  EXPECT_EQ(edges_of_graph(graph, false), expected);
  EXPECT_EQ(edges_of_graph(graph, true), expected);
}

TEST(CertainEdges, DoNotDependOnThreads) {
  const KdOrder order = make_kd_order(generate("clustered", 20'000, 3));
  const CandidateGraph one = candidate_graph(order);
  tbb::task_arena arena(3);
  const CandidateGraph three = arena.execute([&] { return candidate_graph(order); });
  EXPECT_EQ(one.first, three.first);
  EXPECT_EQ(one.target, three.target);
  EXPECT_EQ(one.certain, three.certain);
}

}  // namespace
}  // namespace mwt
