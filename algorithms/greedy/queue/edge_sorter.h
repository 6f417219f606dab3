// Sorts the edges that are candidates from the start.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/mesh/edge_order.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// Sorts mesh edges in greedy's order. O(n) for many edges: radix sort by squared length in floating point, then exact
/// sorting of the runs that rounding leaves undecided. Keeps its buffers for the next call.
class EdgeSorter {
 public:
  EdgeSorter(const PlanarMesh& mesh, const EdgeOrder& order) : mesh_(mesh), order_(order) {}

  /// Afterwards edge(0), edge(1), ..., edge(size() - 1) are `edges` in order.
  void sort(std::span<const MeshEdge> edges);

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] MeshEdge edge(std::size_t i) const { return static_cast<MeshEdge>(keys_[i] & kEdgeMask); }

 private:
  static constexpr int kEdgeBits = 30;  // a mesh has fewer than 3 * 2^28 edges
  static constexpr std::uint64_t kEdgeMask = (std::uint64_t{1} << kEdgeBits) - 1;

  void sort_roughly(std::span<const MeshEdge> edges);
  void sort_exactly(std::size_t first, std::size_t last);
  [[nodiscard]] bool surely_increases(std::size_t i) const;

  const PlanarMesh& mesh_;
  const EdgeOrder& order_;
  KeptVector<std::uint64_t> keys_;  // high bits: truncated squared length; low bits: edge
  KeptVector<std::uint64_t> buffer_;
  KeptVector<EdgeKey> run_;
  std::uint64_t min_bits_ = 0;
  int dropped_bits_ = 0;
};

}  // namespace mwt
