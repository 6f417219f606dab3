#include "algorithms/greedy/pockets/distant_ears.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/greedy/pockets/boundary_stretch.h"
#include "algorithms/greedy/testing/greedy_testing.h"
#include "generators/registry.h"

namespace mwt {

namespace {

bool is_promising(Points points) {
  const PlanarMesh mesh = test::constrained_mesh(points, {});
  const EdgeOrder order(mesh.points(), mesh.labels());
  FaceBoundary boundary(mesh, test::inner_edges(mesh));
  BoundaryStretch stretch(mesh);
  return DistantEars(mesh, order, stretch).is_promising(boundary);
}

// The Delaunay triangulation of a convex arc of a parabola is a fan: other points are far. Near a boundary through
// uniform points there are others everywhere.
TEST(DistantEars, ArePromisingWhereNothingIsNearTheBoundary) {
  EXPECT_TRUE(is_promising(generate("parabola", 2000, 1, {})));
  std::vector<Point> points = generate("uniform", 2000, 1, {});
  for (int i = 0; i < 100; ++i) points.insert(points.end(), {{-1, .01 * i}, {2, .01 * i}});
  for (int i = 0; i < 100; ++i) points.insert(points.end(), {{-.99 - 1e-5 * i * (99 - i), .005 + .01 * i}});
  EXPECT_FALSE(is_promising(points));
}

// Looks at all corners before the first is cut. Returns how many ears were certain.
std::size_t expect_distant_ears_greedy(Points points, const std::string& what) {
  const std::vector<Edge> greedy = test::greedy_edges(points);
  const PlanarMesh mesh = test::constrained_mesh(points, test::some_of(greedy, 3, points.size()));
  const EdgeOrder order(mesh.points(), mesh.labels());
  FaceBoundary boundary(mesh, test::inner_edges(mesh));
  BoundaryStretch stretch(mesh);
  stretch.enter(boundary, 0, static_cast<Corner>(boundary.size()));
  DistantEars ears(mesh, order, stretch);
  ears.begin(boundary.size());
  std::size_t certain = 0;
  for (Corner c = 0; c < boundary.size(); ++c) {
    DistantEar ear{boundary.next(c), boundary.previous(c), c};
    if (boundary.is_of_triangle(c) || !ears.is_certain(ear)) continue;
    const Edge edge = make_edge(mesh.label(boundary.point(ear.a)), mesh.label(boundary.point(ear.b)));
    EXPECT_TRUE(std::binary_search(greedy.begin(), greedy.end(), edge)) << what;
    ++certain;
  }
  return certain;
}

TEST(DistantEars, AreGreedy) { EXPECT_GT(test::sum_over_instances(6, 60, expect_distant_ears_greedy), 100U); }

}  // namespace

}  // namespace mwt
