// Nodes of the trees of dual values.
#pragma once

#include <cstdint>

#include "algorithms/proof_trace.h"

namespace mwt {

/// Appends a branch on an open edge to the tree of a region.
inline void add_branch(DualRegion& region, std::uint32_t open_edge) {
  DualNode& branch = region.tree.emplace_back();
  branch.kind = DualNode::Kind::branch;
  branch.edge = open_edge;
}

/// Appends a leaf to the tree of a region whose outline (places, walks, open edges) is given. `dual_of(from, to)` is
/// the dual value of the side on the left of the edge between two of the region's points.
template <class DualOf>
void add_leaf(DualRegion& region, const DualOf& dual_of) {
  DualNode& leaf = region.tree.emplace_back();
  std::size_t first = 0;
  for (const std::uint32_t size : region.walk_sizes) {
    for (std::size_t i = 0; i < size; ++i)
      leaf.side_duals.push_back(dual_of(region.places[first + i], region.places[first + (i + 1) % size]));
    first += size;
  }
  for (const auto& [from, to] : region.open_edges) {
    leaf.edge_duals.push_back(dual_of(region.places[from], region.places[to]));
    leaf.other_duals.push_back(dual_of(region.places[to], region.places[from]));
  }
}

}  // namespace mwt
