#include "algorithms/exact/candidates/lmt_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/common/testing/extreme_points.h"
#include "algorithms/exact/candidates/near_points.h"
#include "algorithms/exact/testing/instruction_sets.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/numbers/scaling.h"

namespace mwt {
namespace {

using stage_testing::diamond_candidates;
using stage_testing::edges_in;
using stage_testing::for_each_instruction_set;
using stage_testing::hull_of;
using stage_testing::instances_of_all_families;

// The stars of these edges, which ascend.
StarTable stars_of(const KdOrder& order, const std::set<Edge>& edges) {
  StarTable table;
  table.stars.resize(order.points.size());
  for (const Edge& edge : edges) {
    ++table.stars[edge.a].capacity;
    ++table.stars[edge.b].capacity;
  }
  table.arenas.emplace_back(2 * edges.size());
  for (Star& star : table.stars) star = table.arenas[0].allot(star.capacity);
  const double scale = distance_scale(order);
  const auto append = [&](Index from, Index to) {
    const Point &p = order.points[from], &q = order.points[to];
    table.stars[from].append(to, Star::component(q.x - p.x, scale), Star::component(q.y - p.y, scale));
  };
  for (const Edge& edge : edges) {
    append(edge.a, edge.b);
    append(edge.b, edge.a);
  }
  return table;
}

std::vector<std::uint32_t> row_of(const Star& star, const std::uint32_t* row) { return {row, row + star.count}; }

void expect_same_deletions(Points points) {
  const KdOrder order = make_kd_order(points);
  const HullEdges hull = hull_of(order.points);
  const std::set<Edge> edges = edges_in(diamond_candidates(order));
  std::vector<CandidatePair> pairs;
  for (const Edge& edge : edges) pairs.push_back({edge.a, edge.b});
  StarTable vectors = stars_of(order, edges), plain = stars_of(order, edges);
  const LmtCounters by_vectors = delete_edges_without_certificate(vectors, order.points, hull, pairs, Context{});
  const LmtCounters by_loops = delete_edges_without_certificate_plainly(plain, order.points, hull, pairs, Context{});
  ASSERT_EQ(by_vectors.checks, by_loops.checks);
  ASSERT_EQ(by_vectors.deleted, by_loops.deleted);
  for (Index v = 0; v < order.points.size(); ++v) {
    const Star &one = vectors.stars[v], &other = plain.stars[v];
    ASSERT_EQ(row_of(one, one.target()), row_of(other, other.target())) << "star " << v;
    ASSERT_EQ(row_of(one, one.certificate()), row_of(other, other.certificate())) << "star " << v;
    ASSERT_TRUE(std::equal(one.x(), one.x() + one.count, other.x(),
                           [](float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }))
        << "star " << v;
  }
}

// The same certificates and survivors, with every instruction set.
TEST(LmtKernels, AgreeWithThePlainLoops) {
  for_each_instruction_set([] {
    for (const auto& [name, points] : instances_of_all_families({4, 10, 40})) {
      SCOPED_TRACE(name);
      ASSERT_NO_FATAL_FAILURE(expect_same_deletions(points));
    }
  });
}

TEST(LmtKernels, AgreeWithThePlainLoopsAtTheLimitsOfFloats) {
  for_each_instruction_set([] {
    for (std::uint64_t seed = 0; seed < 320; ++seed) {
      SCOPED_TRACE(seed);
      const auto kind = static_cast<test::ExtremePoints::Kind>(seed % test::ExtremePoints::kKinds);
      const std::vector<Point> points = exactly_scaled(test::ExtremePoints(seed).draw(kind, 5 + seed % 30));
      if (points.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_same_deletions(points));
    }
  });
}

TEST(LmtKernels, KeepHullEdgesAndStopAtTheDeadline) {
  const KdOrder order = make_kd_order(generate("uniform", 200, 1));
  const HullEdges hull = hull_of(order.points);
  const std::set<Edge> edges = edges_in(diamond_candidates(order));
  std::vector<CandidatePair> pairs;
  for (const Edge& edge : edges) pairs.push_back({edge.a, edge.b});
  StarTable table = stars_of(order, edges);
  Context late;
  late.deadline = Context::Clock::now() - std::chrono::seconds(1);
  EXPECT_EQ(delete_edges_without_certificate(table, order.points, hull, pairs, late).checks, 0U);
  EXPECT_EQ(edges_in(table), edges);
  EXPECT_GT(delete_edges_without_certificate(table, order.points, hull, pairs, Context{}).deleted, 0U);
  const std::set<Edge> survivors = edges_in(table);
  for (Index v = 0; v < order.points.size(); ++v) {
    if (hull.next[v] == kNoIndex) continue;
    EXPECT_TRUE(survivors.contains(make_edge(v, hull.next[v])));
  }
}

}  // namespace
}  // namespace mwt
