#include "algorithms/hull_insertion/preferred_paths.h"

namespace mwt {

// Moves v one level up in its splay tree.
void PreferredPaths::rotate(Index v) {
  const Index parent = nodes_[v].parent;
  const Index grandparent = nodes_[parent].parent;
  if (!is_splay_root(parent)) {
    (nodes_[grandparent].higher == parent ? nodes_[grandparent].higher : nodes_[grandparent].deeper) = v;
  }
  const bool was_higher = nodes_[parent].higher == v;
  Index& handed_over = was_higher ? nodes_[v].deeper : nodes_[v].higher;
  (was_higher ? nodes_[parent].higher : nodes_[parent].deeper) = handed_over;
  if (handed_over != kNoIndex) nodes_[handed_over].parent = parent;
  handed_over = parent;
  nodes_[parent].parent = v;
  nodes_[v].parent = grandparent;
}

void PreferredPaths::splay(Index v) {
  while (!is_splay_root(v)) {
    const Index parent = nodes_[v].parent;
    if (!is_splay_root(parent)) {
      const Index grandparent = nodes_[parent].parent;
      const bool same_side = (nodes_[parent].higher == v) == (nodes_[grandparent].higher == parent);
      rotate(same_side ? parent : v);
    }
    rotate(v);
  }
}

}  // namespace mwt
