#include "algorithms/greedy/bounds/crossing_bounds.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/common/testing/extreme_points.h"
#include "algorithms/greedy/bounds/certified_edges.h"
#include "algorithms/greedy/testing/greedy_testing.h"

namespace mwt {

namespace {

struct Certain {
  std::vector<Edge> edges;
  std::size_t uncertain = 0;
};

// The bounds of all faces at once, between the hull's edges, and the certified ones if requested.
Certain certain_edges(Points points, bool fixes_certified) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  std::vector<MeshEdge> face;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    const bool fixed = mesh.is_hull(e) || (fixes_certified && is_certainly_greedy(mesh, e));
    mesh.marks(e) |= fixed ? kFixedMark : kFaceMark;
    if (!fixed) face.push_back(e);
  }
  CrossingBounds bounds(mesh);
  Certain result;
  const bool found = bounds.find(face, 1000);
  for (const MeshEdge e : face) {
    if (found && bounds.is_certain(e)) {
      result.edges.push_back(mesh.labelled_edge(e));
    } else {
      ++result.uncertain;
    }
  }
  std::sort(result.edges.begin(), result.edges.end());
  return result;
}

// Returns how many edges were certain.
std::size_t expect_greedy(Points points, const std::string& what) {
  const std::vector<Edge> expected = test::greedy_edges(points);
  std::size_t certain = 0;
  for (const bool fixes_certified : {false, true}) {
    const std::vector<Edge> edges = certain_edges(points, fixes_certified).edges;
    EXPECT_TRUE(std::includes(expected.begin(), expected.end(), edges.begin(), edges.end())) << what;
    certain += edges.size();
  }
  return certain;
}

TEST(CrossingBounds, CertainEdgesAreGreedy) { EXPECT_GT(test::sum_over_instances(6, 60, expect_greedy), 1000U); }

TEST(CrossingBoundsSlow, CertainEdgesAreGreedyOnManyInstances) {
  EXPECT_GT(test::sum_over_instances(100, 120, expect_greedy), 100'000U);
}

std::size_t sum_over_extreme_points(std::uint64_t sets, std::size_t max_n) {
  std::size_t sum = 0;
  for (std::uint64_t seed = 0; seed < sets; ++seed) {
    const auto kind = static_cast<test::ExtremePoints::Kind>(seed % test::ExtremePoints::kKinds);
    const std::size_t n = 5 + seed / test::ExtremePoints::kKinds % (max_n - 4);
    const std::vector<Point> points = test::ExtremePoints(seed).draw(kind, n);
    const std::string name = "kind " + std::to_string(kind) + " seed " + std::to_string(seed);
    if (!points.empty()) sum += expect_greedy(points, name);
  }
  return sum;
}

// Products of coordinates that underflow make no angle reflex and no bound too large.
TEST(CrossingBounds, CertainEdgesAreGreedyAtTheLimitsOfDoubles) { EXPECT_GT(sum_over_extreme_points(1200, 20), 1000U); }

TEST(CrossingBoundsSlow, CertainEdgesAreGreedyAtTheLimitsOfDoubles) {
  EXPECT_GT(sum_over_extreme_points(20'000, 30), 100'000U);
}

TEST(CrossingBounds, CertainEdgesOfWheelsAreGreedy) {
  for (const char* size : {"5", "14", "30", "60"}) {
    EXPECT_GT(expect_greedy(generate("wheels", 1200, 1, {{"size", size}}), "wheels"), 500U) << size;
  }
}

// Two rows of points, bent away from each other: every rung of the ladder between is shorter than what can cross it.
TEST(CrossingBounds, FindsTheRungsOfALadder) {
  std::vector<Point> points;
  for (int i = -10; i <= 10; ++i) points.insert(points.end(), {{1.0 * i, -.01 * i * i}, {i + .25, 3 + .01 * i * i}});
  const Certain found = certain_edges(points, true);
  EXPECT_GE(found.edges.size(), 35U);  // of 41 rungs
}

// Next to the rim of a wheel two spokes are nearer to each other than the hub is.
TEST(CrossingBounds, LeavesTheSpokesOfAWheelToShorterEars) {
  const Certain found = certain_edges(generate("wheels", 14, 1, {{"size", "14"}}), false);
  EXPECT_TRUE(found.edges.empty());
  EXPECT_EQ(found.uncertain, 13U);
}

}  // namespace

}  // namespace mwt
