#include "algorithms/greedy/ears/pocket_insertion.h"

#include "geometry/predicates.h"

namespace mwt {

// Hidden ears first, those of convex polygons at once.
void PocketInsertion::insert(Corner c) {
  const auto is_missing = [this](Corner apex) {
    return apex != BoundaryStretch::kNone && stretch_.room(apex).side == BoundaryStretch::kNone;
  };
  const Corner root = stretch_.room(c).apex;
  insertion_.begin();
  open_.assign(1, root);
  while (!open_.empty()) {
    const Corner apex = open_.back();
    const BoundaryStretch::Room& here = stretch_.room(apex);
    if (hides_convex_polygon(apex)) {
      open_.pop_back();
      insert_fan(apex);
    } else if (is_missing(here.left)) {
      open_.push_back(here.left);
    } else if (is_missing(here.apex)) {
      open_.push_back(here.apex);
    } else {
      open_.pop_back();
      insert_ear(apex);
    }
  }
  insertion_.restore_delaunay();
  stretch_.boundary().set_side(c, stretch_.room(root).side);
}

// Whether the ear and all ears that it hides form a convex polygon of four corners or more.
bool PocketInsertion::hides_convex_polygon(Corner apex) const {
  const BoundaryStretch::Room& here = stretch_.room(apex);
  if (!here.is_convex || (here.left == BoundaryStretch::kNone && here.apex == BoundaryStretch::kNone)) return false;
  const Corner first = stretch_.previous(apex), last = stretch_.next(apex);
  const Point &u = stretch_.point(first), &v = stretch_.point(last);
  const Point& after_u = mesh_.point(mesh_.target(stretch_.first_side(first)));
  const Point& before_v = stretch_.point(stretch_.room(last).before);
  return orientation(v, u, after_u) > 0 && orientation(before_v, v, u) > 0;
}

void PocketInsertion::insert_ear(Corner apex) {
  const Halfedge side = join(from_previous(apex), to_next(apex));
  stretch_.room(apex).side = side;
  stars_.fix(edge_of(side));
}

// All spokes of the polygon's corners are flipped to its last corner; then the ears take the places of the fan that
// this leaves inside.
void PocketInsertion::insert_fan(Corner apex) {
  const Corner first = stretch_.previous(apex), last = stretch_.next(apex);
  fan_.clear();
  Halfedge side = stretch_.first_side(stretch_.room(last).before);
  for (Corner c = stretch_.room(last).before; c != first; c = stretch_.room(c).before) {
    side = join(stretch_.first_side(stretch_.room(c).before), side);
    fan_.push_back(edge_of(side));
  }
  fan_.pop_back();
  stretch_.room(apex).side = side;
  link_ears(apex);
}

// Gives the ears that this one hides the edges of the fan.
void PocketInsertion::link_ears(Corner root) {
  const std::size_t others = open_.size();
  open_.push_back(root);
  for (std::size_t i = others; i < open_.size(); ++i) {
    const Corner apex = open_[i];
    for (const Corner hidden : {stretch_.room(apex).left, stretch_.room(apex).apex}) {
      if (hidden == BoundaryStretch::kNone) continue;
      const MeshEdge e = fan_.back();
      fan_.pop_back();
      const FaceBoundary& boundary = stretch_.boundary();
      mesh_.set_edge(e, boundary.point(boundary.previous(hidden)), boundary.point(boundary.next(hidden)));
      stretch_.room(hidden).side = 2 * e;
      open_.push_back(hidden);
    }
    mesh_.link_triangle(from_previous(apex), to_next(apex), twin(stretch_.room(apex).side));
  }
  for (std::size_t i = others; i < open_.size(); ++i) stars_.fix(edge_of(stretch_.room(open_[i]).side));
  open_.resize(others);
}

// The edge from the origin of `to` to the target of `from`, two sides that follow each other: it cuts off the corner
// between them.
Halfedge PocketInsertion::join(Halfedge to, Halfedge from) {
  const Wedge wedge{from, twin(to)};
  const bool is_in_mesh = mesh_.rotate_left(wedge.first) == wedge.last;
  if (is_in_mesh) return twin(mesh_.next(wedge.first));
  const MeshEdge e = insertion_.flip_out(wedge);
  return mesh_.origin(2 * e) == mesh_.origin(to) ? 2 * e : 2 * e + 1;
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
