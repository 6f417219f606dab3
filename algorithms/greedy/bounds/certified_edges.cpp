#include "algorithms/greedy/bounds/certified_edges.h"

#include "geometry/mesh/angle.h"
#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

// Each angle errs by less than 1e-15 of its size, sums of three by less than 1e-14.
bool surely_below_half_turn(const Angle& sum, double magnitude) { return sum.imaginary > kProductMargin * magnitude; }

}  // namespace

bool is_certainly_greedy(const PlanarMesh& mesh, MeshEdge e) {
  const Point& a = mesh.point(mesh.origin(2 * e));
  const Point& b = mesh.point(mesh.target(2 * e));
  const Angle left = angle_at(mesh.point(mesh.apex(2 * e)), a, b);
  const Angle right = angle_at(mesh.point(mesh.apex(2 * e + 1)), b, a);
  if (!(left.real > 0 && right.real > 0)) return false;  // acute: sums of three stay below a full turn
  const double both = size(left) * size(right);
  const Angle sum = sum_of(left, right);
  return is_trusted_factor(size(left)) && is_trusted_factor(size(right)) &&
         surely_below_half_turn(sum_of(sum, left), both * size(left)) &&
         surely_below_half_turn(sum_of(sum, right), both * size(right));
}

}  // namespace mwt
