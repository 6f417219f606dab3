#include "algorithms/common/beta_skeleton_edges.h"

#include <algorithm>
#include <vector>

#include "geometry/mesh/angle.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

// cot(arcsin(1/beta)) = sqrt(2 sqrt 3) / 3 = 0.62040..., rounded up by far more than the rounding of angles.
constexpr double kMinCotangent = 0.62041;

}  // namespace

bool is_surely_small(const Angle& angle) {
  return angle.real > kMinCotangent * angle.imaginary && is_trusted_product(size(angle));
}

void mark_beta_skeleton(PlanarMesh& delaunay) {
  for (MeshEdge e = 0; e < delaunay.edge_count(); ++e) {
    if (delaunay.is_hull(e)) continue;
    const Point& a = delaunay.point(delaunay.origin(2 * e));
    const Point& b = delaunay.point(delaunay.target(2 * e));
    if (is_surely_small(angle_at(delaunay.point(delaunay.apex(2 * e)), a, b)) &&
        is_surely_small(angle_at(delaunay.point(delaunay.apex(2 * e + 1)), b, a))) {
      delaunay.marks(e) |= kBetaSkeletonMark;
    }
  }
}

void copy_beta_skeleton(const PlanarMesh& delaunay, PlanarMesh& mesh) {
  std::vector<Edge> beta_skeleton;
  for (MeshEdge e = 0; e < delaunay.edge_count(); ++e) {
    if ((delaunay.marks(e) & kBetaSkeletonMark) != 0) beta_skeleton.push_back(delaunay.labelled_edge(e));
  }
  std::sort(beta_skeleton.begin(), beta_skeleton.end());
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    if (std::binary_search(beta_skeleton.begin(), beta_skeleton.end(), mesh.labelled_edge(e)))
      mesh.marks(e) |= kBetaSkeletonMark;
  }
}

}  // namespace mwt
