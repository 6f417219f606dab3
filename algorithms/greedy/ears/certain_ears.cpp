#include "algorithms/greedy/ears/certain_ears.h"

#include <algorithm>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/face_boundary.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/pockets/pockets.h"

namespace mwt {

bool CertainEars::take(std::span<const MeshEdge> face) {
  FaceBoundary boundary(parts_.mesh, face);
  if (are_pockets_promising(parts_, boundary)) inserted_ += take_pockets(parts_, boundary);
  std::size_t possible = 0;
  for (std::size_t first = 0; first < boundary.size() && !stopped_; first += kBlock) {
    for (std::size_t c = first; c < std::min(first + kBlock, boundary.size()); ++c) {
      const auto corner = static_cast<Corner>(c);
      if (!boundary.is_cut(corner) && boundary.is_possible_ear(corner)) waiting_.push_back(corner);
    }
    possible += waiting_.size();
    look_at_waiting(boundary);
  }
  look_at_put_off(boundary, kStepsPerCorner * possible);
  return !stopped_;
}

// First come, first served, so that short ears are taken before long ones: fewer edges are flipped again and again.
void CertainEars::look_at_waiting(FaceBoundary& boundary) {
  for (std::size_t i = 0; i < waiting_.size() && !stopped_; ++i) {
    // An ear that is inserted may take thousands of flips.
    if (++looks_ % 64 == 0 && parts_.context.deadline_passed()) stopped_ = true;
    look_at(boundary, waiting_[i], kFewSteps);
  }
  waiting_.clear();
}

// A few long searches may be what others wait for.
void CertainEars::look_at_put_off(FaceBoundary& boundary, std::size_t max_steps) {
  const std::size_t last_step = search_.steps() + max_steps;
  for (std::size_t i = 0; i < put_off_.size() && !stopped_ && search_.steps() < last_step; ++i) {
    look_at(boundary, put_off_[i], last_step - search_.steps());
    look_at_waiting(boundary);
  }
  put_off_.clear();
}

// Takes the corner off if its ear is certain; then its neighbours and theirs are to be looked at.
void CertainEars::look_at(FaceBoundary& boundary, Corner c, std::size_t max_steps) {
  if (boundary.is_cut(c) || boundary.is_of_triangle(c)) return;
  if (is_certain(boundary, c, max_steps)) {
    take_ear(boundary, c);
    const Corner next = boundary.next(c), previous = boundary.previous(c);
    waiting_.insert(waiting_.end(), {previous, next, boundary.previous(previous), boundary.next(next)});
  } else if (search_.gave_up()) {
    put_off_.push_back(c);
  }
}

bool CertainEars::is_certain(const FaceBoundary& boundary, Corner c, std::size_t max_steps) {
  const Corner next = boundary.next(c), previous = boundary.previous(c);
  return search_.is_certain({boundary.wedge(c),
                             boundary.point(c),
                             boundary.point(next),
                             boundary.point(previous),
                             {boundary.point(boundary.next(next)), boundary.point(boundary.previous(previous))}},
                            max_steps);
}

void CertainEars::take_ear(FaceBoundary& boundary, Corner c) {
  const Wedge wedge = boundary.wedge(c);
  const PlanarMesh& mesh = parts_.mesh;
  const bool is_in_mesh = mesh.rotate_left(wedge.first) == wedge.last;
  inserted_ += is_in_mesh ? 0 : 1;
  const MeshEdge ear = is_in_mesh ? edge_of(mesh.next(wedge.first)) : parts_.insertion.insert(wedge);
  parts_.stars.fix(ear);
  const bool leaves_previous = mesh.origin(2 * ear) == boundary.point(boundary.previous(c));
  boundary.cut(c, leaves_previous ? 2 * ear : 2 * ear + 1);
}

}  // namespace mwt
