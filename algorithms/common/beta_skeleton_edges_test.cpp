#include "algorithms/common/beta_skeleton_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "geometry/mesh/testing/shapes_for_tests.h"
#include "algorithms/patch/patch.h"
#include "algorithms/common/start.h"
#include "algorithms/common/testing/instances.h"
#include "geometry/delaunay.h"

namespace mwt {
namespace {

std::vector<Edge> walls_of(const PlanarMesh& mesh) {
  std::vector<Edge> walls;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if ((mesh.marks(e) & kWallMark) != 0) walls.push_back(mesh.labelled_edge(e));
  }
  std::sort(walls.begin(), walls.end());
  return walls;
}

// Whatever the algorithms on the way note on edges.
TEST(Walls, AreTheSameInEveryStart) {
  for (const test::Shape& shape : test::shapes()) {
    SCOPED_TRACE(shape.name);
    const std::vector<Point> points = test::make_shape(shape, 2000, 1);
    PlanarMesh delaunay(points, delaunay_triangulation(points));
    mark_walls(delaunay);
    for (const char* start : {"delaunay", "greedy", "quadtree"}) {
      const Context context = test::context_for(patch_entry(), {{"start", start}});
      const PlanarMesh mesh = start_mesh_with_walls(points, context);
      const std::vector<Edge> walls = walls_of(mesh);
      const std::vector<Edge> all = walls_of(delaunay);
      EXPECT_TRUE(std::includes(all.begin(), all.end(), walls.begin(), walls.end())) << start;
      if (start != std::string("quadtree")) {
        EXPECT_EQ(walls.size(), all.size()) << start;
      }
    }
  }
}

}  // namespace
}  // namespace mwt
