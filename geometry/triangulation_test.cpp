#include "geometry/triangulation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/testing/shapes.h"
#include "geometry/triangle_sides.h"

namespace mwt {
namespace {

// A square 0 1 2 3 with its centre 4.
const Triangulation kWheel{5, {{4, 0, 1}, {1, 2, 4}, {3, 4, 2}, {3, 0, 4}}};

TEST(Triangulation, DirectedEdgesAreOppositeTheirCorners) {
  const Triangle triangle{7, 3, 5};
  EXPECT_EQ(directed_edge(triangle, 0), (Edge{3, 5}));
  EXPECT_EQ(directed_edge(triangle, 1), (Edge{5, 7}));
  EXPECT_EQ(directed_edge(triangle, 2), (Edge{7, 3}));
  EXPECT_EQ(make_edge(4, 2), make_edge(2, 4));
}

TEST(Triangulation, EdgesOfAWheel) {
  const std::vector<Edge> edges{{0, 1}, {0, 3}, {0, 4}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
  EXPECT_EQ(edges_of(kWheel), edges);
  EXPECT_TRUE(edges_of(Triangulation{3, {}}).empty());
}

TEST(Triangulation, AdjacencyOfAWheel) {
  const std::vector<std::array<Index, 3>> adjacent{
      {kNoIndex, 1, 3}, {2, 0, kNoIndex}, {1, kNoIndex, 3}, {0, 2, kNoIndex}};
  EXPECT_EQ(adjacency_of(kWheel), adjacent);
}

TEST(Triangulation, CanonicalTrianglesForgetOrderAndRotation) {
  const Triangulation other{5, {{0, 4, 3}, {2, 3, 4}, {0, 1, 4}, {2, 4, 1}}};
  EXPECT_EQ(canonical_triangles(other), canonical_triangles(kWheel));
  EXPECT_EQ(canonical_triangles(kWheel)[0], (Triangle{0, 1, 4}));
  const Triangulation flipped{5, {{0, 3, 4}, {2, 3, 4}, {0, 1, 4}, {2, 4, 1}}};  // one turns the other way round
  EXPECT_NE(canonical_triangles(flipped), canonical_triangles(kWheel));
}

TEST(TriangleSides, StandNextToTheirReverses) {
  const TriangleSides sides(kWheel);
  ASSERT_EQ(sides.row(0).size(), 4U);
  EXPECT_EQ(sides.row(4).size(), 0U);
  const auto spoke = sides.row(0).subspan(2);
  EXPECT_EQ(spoke[0].other_end, 4U);
  EXPECT_EQ(spoke[1].other_end, 4U);
  EXPECT_TRUE(spoke[0].is_ascending && !spoke[1].is_ascending);
  EXPECT_EQ(spoke[0].triangle, 3U);
  EXPECT_EQ(spoke[1].triangle, 0U);
}

// Edges and adjacency by the slowest means: sets and maps of sides.
TEST(Triangulation, EdgesAndAdjacencyAgreeWithMapsOnEveryShape) {
  for (const test::Shape& shape : test::all_shapes()) {
    SCOPED_TRACE(shape.name);
    const Triangulation triangulation = delaunay_triangulation(shape.points);
    std::set<Edge> edges;
    std::map<Edge, Index> triangle_left_of;
    for (Index t = 0; t < triangulation.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Edge side = directed_edge(triangulation.triangles[t], i);
        edges.insert(make_edge(side.a, side.b));
        triangle_left_of[side] = t;
      }
    }
    EXPECT_TRUE(std::ranges::equal(edges_of(triangulation), edges));
    const std::size_t h = convex_hull(shape.points).size();
    EXPECT_EQ(edges.size(), 3 * shape.points.size() - 3 - h);

    const auto adjacent = adjacency_of(triangulation);
    ASSERT_EQ(adjacent.size(), triangulation.triangles.size());
    for (Index t = 0; t < adjacent.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        const Edge side = directed_edge(triangulation.triangles[t], i);
        const auto across = triangle_left_of.find({side.b, side.a});
        ASSERT_EQ(adjacent[t][static_cast<std::size_t>(i)],
                  across == triangle_left_of.end() ? kNoIndex : across->second);
      }
    }
  }
}

}  // namespace
}  // namespace mwt
