#include "algorithms/greedy/faces/face_boundary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "algorithms/greedy/testing/greedy_testing.h"

namespace mwt {

namespace {

// A square with a point in its middle that one fixed edge joins to a corner.
struct Slit {
  std::vector<Point> points = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}};
  PlanarMesh mesh = test::constrained_mesh(points, {{0, 4}});
  FaceBoundary boundary{mesh, test::inner_edges(mesh)};

  [[nodiscard]] Index label(Corner c) const { return mesh.label(boundary.point(c)); }
  [[nodiscard]] std::size_t corners_at(Index point) const {
    std::size_t count = 0;
    for (Corner c = 0; c < boundary.size(); ++c) count += label(c) == point ? 1 : 0;
    return count;
  }
};

TEST(FaceBoundary, APointHasAsManyCornersAsTheFaceComesToIt) {
  const Slit slit;
  EXPECT_EQ(slit.boundary.size(), 6U);
  EXPECT_EQ(slit.corners_at(0), 2U);
  for (const Index point : {1, 2, 3, 4}) EXPECT_EQ(slit.corners_at(point), 1U);
}

TEST(FaceBoundary, CornersFormOneCycleAlongTheSides) {
  const Slit slit;
  Corner c = 0;
  for (std::size_t i = 0; i < slit.boundary.size(); ++i) {
    EXPECT_EQ(slit.mesh.origin(slit.boundary.side(c)), slit.boundary.point(c));
    EXPECT_EQ(slit.mesh.target(slit.boundary.side(c)), slit.boundary.point(slit.boundary.next(c)));
    EXPECT_EQ(slit.boundary.previous(slit.boundary.next(c)), c);
    c = slit.boundary.next(c);
    EXPECT_EQ(c == 0, i + 1 == slit.boundary.size());
  }
}

TEST(FaceBoundary, ConvexCornersThatAreNotAcuteMayBeCutOff) {
  const Slit slit;
  for (Corner c = 0; c < slit.boundary.size(); ++c) {
    const Index point = slit.label(c);  // right angles at 1, 2, 3; half of one at 0; a full turn at 4
    EXPECT_EQ(slit.boundary.is_possible_ear(c), point == 1 || point == 2 || point == 3) << point;
  }
}

TEST(FaceBoundary, HolesHaveCyclesOfTheirOwn) {
  const std::vector<Point> points = {{0, 0}, {9, 0}, {0, 9}, {2, 2}, {3, 2}, {2, 3}};
  const PlanarMesh mesh = test::constrained_mesh(points, {{3, 4}, {3, 5}, {4, 5}});
  const FaceBoundary boundary(mesh, test::inner_edges(mesh));
  EXPECT_EQ(boundary.size(), 6U);
  for (Corner c = 0; c < boundary.size(); ++c) EXPECT_TRUE(boundary.is_of_triangle(c));
}

TEST(FaceBoundary, ACutCornerIsOffTheCycle) {
  Slit slit;
  Corner cut = 0;
  while (slit.label(cut) != 2) ++cut;
  const Corner next = slit.boundary.next(cut), previous = slit.boundary.previous(cut);
  slit.boundary.unlink(cut);
  for (Corner c = 0; c < slit.boundary.size(); ++c) EXPECT_EQ(slit.boundary.is_cut(c), c == cut);
  EXPECT_EQ(slit.boundary.next(previous), next);
  EXPECT_EQ(slit.boundary.previous(next), previous);
}

}  // namespace

}  // namespace mwt
