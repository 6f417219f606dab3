#include "algorithms/exact/division/beta_skeleton.h"

#include <algorithm>

#include "algorithms/common/beta_skeleton_edges.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

std::vector<Edge> beta_skeleton(Points points) {
  PlanarMesh delaunay = PlanarMesh::delaunay(points);
  mark_beta_skeleton(delaunay);
  std::vector<Edge> edges;
  for (MeshEdge e = 0; e < delaunay.edge_count(); ++e) {
    if ((delaunay.marks(e) & kBetaSkeletonMark) != 0) edges.push_back(delaunay.labelled_edge(e));
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace mwt
