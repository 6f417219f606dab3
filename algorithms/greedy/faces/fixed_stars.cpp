#include "algorithms/greedy/faces/fixed_stars.h"

namespace mwt {

FixedStars::Neighbours FixedStars::linked_neighbours(Halfedge h) {
  if (is_linked_.empty()) {
    is_linked_.resize(mesh_.point_count());
    links_.resize(2 * mesh_.edge_count());
  }
  if (!is_linked_[mesh_.origin(h)]) link_star(h);
  return is_fixed(mesh_, h) ? links_[h] : find_neighbours(h);
}

// Those of a halfedge that has no links itself: the nearer one by scanning, the other one by its links.
FixedStars::Neighbours FixedStars::find_neighbours(Halfedge h) const {
  Halfedge left = mesh_.rotate_left(h), right = mesh_.rotate_right(h);
  while (!is_fixed(mesh_, left) && !is_fixed(mesh_, right)) {
    left = mesh_.rotate_left(left);
    right = mesh_.rotate_right(right);
  }
  return is_fixed(mesh_, left) ? Neighbours{left, links_[left].right} : Neighbours{links_[right].left, right};
}

void FixedStars::link(Halfedge h) {
  const Neighbours neighbours = find_neighbours(h);
  links_[neighbours.left].right = h;
  links_[neighbours.right].left = h;
  links_[h] = neighbours;
}

// Links the fixed halfedges around the origin of h, of which there is at least one.
void FixedStars::link_star(Halfedge h) {
  is_linked_[mesh_.origin(h)] = true;
  Halfedge first = h;
  while (!is_fixed(mesh_, first)) first = mesh_.rotate_left(first);
  Halfedge before = first;
  for (Halfedge spoke = mesh_.rotate_left(first);; spoke = mesh_.rotate_left(spoke)) {
    if (!is_fixed(mesh_, spoke)) continue;
    links_[before].left = spoke;
    links_[spoke].right = before;
    before = spoke;
    if (spoke == first) return;
  }
}

}  // namespace mwt
