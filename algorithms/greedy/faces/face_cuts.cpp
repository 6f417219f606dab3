#include "algorithms/greedy/faces/face_cuts.h"

#include "geometry/mesh/distance.h"
#include "geometry/mesh/margins.h"
#include "geometry/numbers/trusted_range.h"
#include "geometry/predicates.h"

namespace mwt {

bool FaceCuts::is_promising(std::span<const MeshEdge> face) const {
  constexpr std::size_t kSamples = 4096, kEnough = 4;  // a cut for every thousand edges
  std::size_t cuts = 0;
  for (std::size_t i = 0; i < face.size(); i += face.size() / kSamples + 1) cuts += is_shortest(face[i]) ? 1 : 0;
  return cuts >= kEnough;
}

std::span<const MeshEdge> FaceCuts::find(std::span<const MeshEdge> face) {
  constexpr std::size_t kStepsPerEdge = 4;
  const std::size_t last_step = search_.steps() + kStepsPerEdge * face.size();
  cuts_.clear();
  for (const MeshEdge e : face) {
    if (is_shortest(e) && shows_nothing_near(2 * e, last_step) && shows_nothing_near(2 * e + 1, last_step)) {
      cuts_.push_back(e);
    }
  }
  return cuts_;
}

// Whether e is the shortest between the fixed edges at either end, and shorter than the ears between these.
bool FaceCuts::is_shortest(MeshEdge e) const {
  const auto wedge = wedge_if_shortest(2 * e);
  if (!wedge) return false;
  const auto other = wedge_if_shortest(2 * e + 1);
  return other && is_before_ear(2 * e, *wedge) && is_before_ear(2 * e + 1, *other);
}

// The fixed edges next to h on either side, unless another spoke between them may be as short. Looking in both
// directions at once takes few steps in long stars: of neighbours in a fan one is shorter.
std::optional<Wedge> FaceCuts::wedge_if_shortest(Halfedge h) const {
  const double squared = mesh_.record(edge_of(h)).squared_length;
  if (!is_trusted_float(squared)) return std::nullopt;
  const double surely_longer = squared * (1 + kFloatMargin);
  Wedge wedge{h, h};
  while (!is_fixed(mesh_, wedge.first) || !is_fixed(mesh_, wedge.last)) {
    if (!is_fixed(mesh_, wedge.first)) wedge.first = mesh_.rotate_right(wedge.first);
    if (!is_fixed(mesh_, wedge.last)) wedge.last = mesh_.rotate_left(wedge.last);
    for (const Halfedge spoke : {wedge.first, wedge.last}) {
      if (is_fixed(mesh_, spoke)) continue;
      if (mesh_.record(edge_of(spoke)).squared_length < surely_longer) return std::nullopt;
    }
  }
  return wedge;
}

// Whether h is shorter than the ear between the fixed edges, if there is one.
bool FaceCuts::is_before_ear(Halfedge h, const Wedge& wedge) const {
  const Point &apex = mesh_.point(mesh_.origin(h)), &end = mesh_.point(mesh_.target(h));
  const Point &first = mesh_.point(mesh_.target(wedge.first)), &last = mesh_.point(mesh_.target(wedge.last));
  if (orientation(apex, first, last) <= 0 || dot_sign(first, apex, last) > 0) return true;
  return rounded_squared_distance(first, last) > rounded_squared_distance(apex, end) * (1 + kSquareMargin);
}

// Whether nothing is seen beside the ends of the fixed edges that is as near to the origin of h as its target. What is
// seen elsewhere is no nearer than the nearest spoke.
bool FaceCuts::shows_nothing_near(Halfedge h, std::size_t last_step) {
  if (search_.steps() >= last_step) return false;
  const auto wedge = wedge_if_shortest(h);
  const Point &apex = mesh_.point(mesh_.origin(h)), &end = mesh_.point(mesh_.target(h));
  const double squared = rounded_squared_distance(apex, end) * (1 + kSquareMargin);
  const std::size_t max_steps = last_step - search_.steps();
  return search_.shows_nothing_near(mesh_.next(wedge->first), squared, max_steps) &&
         search_.shows_nothing_near(mesh_.previous(twin(wedge->last)), squared, max_steps);
}

}  // namespace mwt
