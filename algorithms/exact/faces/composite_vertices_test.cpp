#include "algorithms/exact/faces/composite_vertices.h"

#include <gtest/gtest.h>

#include <set>

#include "algorithms/exact/testing/naive_candidates.h"

namespace mwt {
namespace {

using Vertices = std::vector<Index>;

// A square with three points inside.
const std::vector<Point> kSquareWithThree{{0, 0}, {20, 0}, {20, 20}, {0, 20}, {8, 7}, {12, 13}, {13, 6}};

Vertices composite_with(const std::set<Edge>& certain) {
  return composite_vertices(naive::graph_with_certain(kSquareWithThree, certain));
}

TEST(CompositeVertices, AreThoseOfFacesWithHolesOrIsolatedVertices) {
  EXPECT_EQ(composite_with({}), (Vertices{0, 1, 2, 3, 4, 5, 6})) << "isolated vertices";
  EXPECT_EQ(composite_with({{0, 4}, {5, 6}}), (Vertices{0, 1, 2, 3, 4, 5, 6})) << "a slit apart from the square";
  EXPECT_EQ(composite_with({{0, 4}, {2, 4}, {2, 5}}), (Vertices{0, 1, 2, 4, 6})) << "the other face is a polygon";
}

TEST(CompositeVertices, ConnectedGraphsHaveNone) { EXPECT_TRUE(composite_with({{0, 4}, {4, 5}, {4, 6}}).empty()); }

}  // namespace
}  // namespace mwt
