#include "algorithms/greedy/faces/fixed_stars.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "algorithms/greedy/greedy_marks.h"
#include "generators/registry.h"

namespace mwt {

namespace {

Halfedge next_fixed(const PlanarMesh& mesh, Halfedge h, bool to_the_left) {
  const auto step = [&](Halfedge s) { return to_the_left ? mesh.rotate_left(s) : mesh.rotate_right(s); };
  Halfedge other = step(h);
  while (!is_fixed(mesh, other)) other = step(other);
  return other;
}

// By definition, at a hub of 2,000 spokes that are fixed one after the other, and at the rim, which needs no links.
TEST(FixedStars, FindNeighboursOfFixedAndOtherHalfedges) {
  const std::vector<Point> points = generate("wheel", 2001, 1, {});
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  FixedStars stars(mesh);
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.is_hull(e)) stars.fix(e);
  }
  std::mt19937_64 random(1);
  const auto any = [&random](std::size_t count) { return static_cast<MeshEdge>(random() % count); };
  for (MeshEdge first = any(mesh.edge_count()), i = 0; i < 500; ++i, first = any(mesh.edge_count())) {
    if (is_fixed_edge(mesh, first)) continue;
    stars.fix(first);
    const Halfedge another = 2 * any(mesh.edge_count()) + any(2);
    for (const Halfedge h : {2 * first, 2 * first + 1, another}) {
      Halfedge other = mesh.rotate_left(h);
      while (other != h && !is_fixed(mesh, other)) other = mesh.rotate_left(other);
      if (!is_fixed(mesh, other)) continue;  // nothing is fixed there
      EXPECT_EQ(stars.left_of(h), next_fixed(mesh, h, true));
      EXPECT_EQ(stars.right_of(h), next_fixed(mesh, h, false));
    }
  }
}

}  // namespace

}  // namespace mwt
