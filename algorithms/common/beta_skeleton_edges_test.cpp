#include "algorithms/common/beta_skeleton_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "algorithms/common/start.h"
#include "algorithms/common/testing/instances.h"
#include "algorithms/patch/patch.h"
#include "geometry/delaunay.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

std::vector<Edge> beta_skeleton_of(const PlanarMesh& mesh) {
  std::vector<Edge> beta_skeleton;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if ((mesh.marks(e) & kBetaSkeletonMark) != 0) beta_skeleton.push_back(mesh.labelled_edge(e));
  }
  std::sort(beta_skeleton.begin(), beta_skeleton.end());
  return beta_skeleton;
}

// Whatever the algorithms on the way note on edges.
TEST(BetaSkeletonEdges, AreTheSameInEveryStart) {
  for (const test::ShapeFamily& shape : test::shapes()) {
    SCOPED_TRACE(shape.name);
    const std::vector<Point> points = test::make_shape(shape, 2000, 1);
    PlanarMesh delaunay(points, delaunay_triangulation(points));
    mark_beta_skeleton(delaunay);
    for (const char* start : {"delaunay", "greedy", "quadtree"}) {
      const Context context = test::context_for(patch_entry(), {{"start", start}});
      const PlanarMesh mesh = start_mesh_with_beta_skeleton(points, context);
      const std::vector<Edge> beta_skeleton = beta_skeleton_of(mesh);
      const std::vector<Edge> all = beta_skeleton_of(delaunay);
      EXPECT_TRUE(std::includes(all.begin(), all.end(), beta_skeleton.begin(), beta_skeleton.end())) << start;
      if (start != std::string("quadtree")) {
        EXPECT_EQ(beta_skeleton.size(), all.size()) << start;
      }
    }
  }
}

}  // namespace
}  // namespace mwt
