#include "algorithms/greedy/pockets/boundary_stretch.h"

#include <gtest/gtest.h>

#include "algorithms/greedy/testing/greedy_testing.h"

namespace mwt {

namespace {

// A regular-looking octagon of integers, its hull fixed.
struct Octagon {
  std::vector<Point> points = {{3, 0}, {7, 0}, {10, 3}, {10, 7}, {7, 10}, {3, 10}, {0, 7}, {0, 3}};
  PlanarMesh mesh = test::constrained_mesh(points, {});
  FaceBoundary boundary{mesh, test::inner_edges(mesh)};
  BoundaryStretch stretch{mesh};

  Octagon() { stretch.enter(boundary, 0, 8); }
};

TEST(BoundaryStretch, TheClearanceIsTheShortestSpoke) {
  Octagon octagon;
  std::size_t without_spokes = 0;
  for (Corner c = 0; c < 8; ++c) {
    float least = BoundaryStretch::kFar;
    for (const MeshEdge e : test::inner_edges(octagon.mesh)) {
      const Index point = octagon.boundary.point(c);
      const bool ends_here = octagon.mesh.origin(2 * e) == point || octagon.mesh.target(2 * e) == point;
      if (ends_here) least = std::min(least, octagon.mesh.record(e).squared_length);
    }
    EXPECT_EQ(octagon.stretch.clearance(c), least);
    without_spokes += least == BoundaryStretch::kFar ? 1 : 0;
  }
  EXPECT_GE(without_spokes, 2U);  // every triangulation of a polygon has two ears
}

TEST(BoundaryStretch, CornersFaceWhatLiesBetweenTheirSides) {
  const Octagon octagon;
  for (Corner c = 0; c < 8; ++c) {
    EXPECT_TRUE(octagon.stretch.faces(c, {5, 5}));
    EXPECT_FALSE(octagon.stretch.faces(c, octagon.stretch.point(octagon.stretch.next(c))));
    EXPECT_FALSE(
        octagon.stretch.faces(c, {5 + 3 * (octagon.stretch.point(c).x - 5), 5 + 3 * (octagon.stretch.point(c).y - 5)}));
  }
}

TEST(BoundaryStretch, ACutCornerHidesInThePocketAfterThePreviousOne) {
  Octagon octagon;
  const Corner c = 3, previous = octagon.stretch.previous(c), next = octagon.stretch.next(c);
  octagon.stretch.cut(c, 5, 6, 7);
  EXPECT_TRUE(octagon.boundary.is_cut(c));
  EXPECT_EQ(octagon.stretch.next(previous), next);
  EXPECT_EQ(octagon.stretch.room(previous).apex, c);
  EXPECT_EQ(octagon.stretch.pocket(previous), 7);
  EXPECT_EQ(octagon.stretch.clearance(next), 5);
  EXPECT_EQ(octagon.stretch.clearance(previous), 6);
  EXPECT_EQ(octagon.stretch.room(next).before, c);  // as before the cut
}

}  // namespace

}  // namespace mwt
