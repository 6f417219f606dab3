#include "algorithms/greedy/ears/ear_insertion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/greedy/faces/face_boundary.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/testing/greedy_testing.h"
#include "geometry/checker.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// Whether no spoke of the wedge ends in its closed triangle.
bool is_empty_ear(const PlanarMesh& mesh, const Wedge& wedge) {
  const Point &c = mesh.point(mesh.origin(wedge.first)), &a = mesh.point(mesh.target(wedge.first)),
              &b = mesh.point(mesh.target(wedge.last));
  if (orientation(c, a, b) <= 0 || mesh.rotate_left(wedge.first) == wedge.last) return false;
  for (Halfedge s = mesh.rotate_left(wedge.first); s != wedge.last; s = mesh.rotate_left(s)) {
    if (orientation(a, b, mesh.point(mesh.target(s))) >= 0) return false;
  }
  return true;
}

// Inserts every ear that there is, one after the other. Returns how many.
std::size_t insert_all(Points points, const std::string& what) {
  PlanarMesh mesh = test::constrained_mesh(points, test::some_of(test::greedy_edges(points), 3, points.size()));
  FixedStars stars(mesh);
  EarInsertion insertion(mesh, stars);
  std::size_t inserted = 0;
  for (Halfedge first = 0; first < 2 * mesh.edge_count(); ++first) {
    if (!is_fixed(mesh, first)) continue;
    const Wedge wedge{first, stars.left_of(first)};
    if (wedge.first == wedge.last || !is_empty_ear(mesh, wedge)) continue;
    const Edge expected = make_edge(mesh.label(mesh.target(wedge.first)), mesh.label(mesh.target(wedge.last)));
    const MeshEdge e = insertion.insert(wedge);
    EXPECT_EQ(mesh.labelled_edge(e), expected) << what;
    stars.fix(e);
    test::expect_constrained_delaunay(mesh, what);
    ++inserted;
  }
  EXPECT_FALSE(find_violation(points, mesh.triangulation())) << what;
  return inserted;
}

TEST(EarInsertion, RestoresTheDelaunayProperty) { EXPECT_GT(test::sum_over_instances(2, 60, insert_all), 200U); }

}  // namespace

}  // namespace mwt
