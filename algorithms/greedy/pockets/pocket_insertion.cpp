#include "algorithms/greedy/pockets/pocket_insertion.h"

#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/pockets/boundary_stretch.h"

namespace mwt {

// Hidden ears first.
void PocketInsertion::insert(Corner c) {
  const auto is_missing = [this](Corner apex) {
    return apex != BoundaryStretch::kNone && stretch_.room(apex).side == BoundaryStretch::kNone;
  };
  const Corner root = stretch_.room(c).apex;
  parts_.insertion.begin();
  open_.assign(1, root);
  while (!open_.empty()) {
    const Corner apex = open_.back();
    const BoundaryStretch::Room& here = stretch_.room(apex);
    if (is_missing(here.left)) {
      open_.push_back(here.left);
    } else if (is_missing(here.apex)) {
      open_.push_back(here.apex);
    } else {
      open_.pop_back();
      insert_ear(apex);
    }
  }
  parts_.insertion.restore_delaunay();
  stretch_.boundary().set_side(c, stretch_.room(root).side);
}

void PocketInsertion::insert_ear(Corner apex) {
  const Halfedge side = join(from_previous(apex), to_next(apex));
  stretch_.room(apex).side = side;
  parts_.stars.fix(edge_of(side));
}

// The edge from the origin of `to` to the target of `from`, two sides that follow each other: it cuts off the corner
// between them.
Halfedge PocketInsertion::join(Halfedge to, Halfedge from) {
  const Wedge wedge{from, twin(to)};
  const bool is_in_mesh = parts_.mesh.rotate_left(wedge.first) == wedge.last;
  if (is_in_mesh) return twin(parts_.mesh.next(wedge.first));
  const MeshEdge e = parts_.insertion.flip_out(wedge);
  return parts_.mesh.origin(2 * e) == parts_.mesh.origin(to) ? 2 * e : 2 * e + 1;
}

Halfedge PocketInsertion::from_previous(Corner apex) const {
  const Corner hidden = stretch_.room(apex).left;
  return hidden == BoundaryStretch::kNone ? stretch_.first_side(stretch_.previous(apex)) : stretch_.room(hidden).side;
}

Halfedge PocketInsertion::to_next(Corner apex) const {
  const Corner hidden = stretch_.room(apex).apex;
  return hidden == BoundaryStretch::kNone ? stretch_.first_side(apex) : stretch_.room(hidden).side;
}

}  // namespace mwt
