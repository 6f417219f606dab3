// A growing tree in which the way from the root to a leaf is found in few steps, however deep the tree is.
#pragma once

#include <vector>

#include "geometry/point.h"

namespace mwt {

/// The link-cut trees of Sleator and Tarjan, reduced to what nested regions need: a rooted tree that grows at its
/// leaves, and a search for the deepest node that has a property which, if a node has it, its parent has as well.
///
/// The tree is cut into paths that run downwards; each is kept in a splay tree ordered by depth, in which the property
/// is searched by bisection. A search makes the way that it took one path. Provided that children are added to the node
/// that was found last, a search takes amortised O(log^2 n) steps, also where the tree is a single long path.
///
/// D. D. Sleator, R. E. Tarjan, "Self-adjusting binary search trees", JACM 32 (1985), with "A data structure for
/// dynamic trees", JCSS 26 (1983). 12 bytes per node.
class PreferredPaths {
 public:
  /// Adds a node below `parent`, the root if there is none yet. Nodes are numbered 0, 1, 2, ...
  Index add(Index parent) {
    nodes_.push_back({kNoIndex, kNoIndex, parent});
    const auto added = static_cast<Index>(nodes_.size() - 1);
    if (parent == kNoIndex) top_ = added;
    return added;
  }

  void reserve(std::size_t count) { nodes_.reserve(count); }

  /// The deepest node with the property has(node). Requires that the root has it, and that child_with(node) gives a
  /// child of `node` that has it, kNoIndex if none does.
  template <class Has, class ChildWith>
  Index find_deepest(const Has& has, const ChildWith& child_with) {
    Index deepest = kNoIndex;
    Index subtree = top_;
    while (true) {
      Index last = deepest;
      while (subtree != kNoIndex) {
        last = subtree;
        const bool yes = has(subtree);
        if (yes) deepest = subtree;
        subtree = yes ? nodes_[subtree].deeper : nodes_[subtree].higher;
      }
      splay(last);
      splay(deepest);
      top_ = deepest;
      const Index child = child_with(deepest);
      prefer(deepest, child);
      if (child == kNoIndex) return deepest;
      deepest = child;
      subtree = nodes_[child].deeper;
    }
  }

 private:
  struct Node {
    Index higher;  // children in the splay tree: nodes nearer the root of the tree,
    Index deeper;  // and nodes farther from it
    Index parent;  // in the splay tree; for its root, the node of another path from which this path hangs
  };

  [[nodiscard]] bool is_splay_root(Index v) const {
    const Index parent = nodes_[v].parent;
    return parent == kNoIndex || (nodes_[parent].higher != v && nodes_[parent].deeper != v);
  }

  // Continues the path that ends or passes at the splay root v with the path that starts at `child`. What followed v so
  // far becomes a path of its own: it hangs from v already, by its parent.
  void prefer(Index v, Index child) {
    if (child != kNoIndex) splay(child);
    nodes_[v].deeper = child;
  }

  void splay(Index v);
  void rotate(Index v);

  std::vector<Node> nodes_;
  Index top_ = kNoIndex;  // root of the splay tree that holds the root's path
};

}  // namespace mwt
