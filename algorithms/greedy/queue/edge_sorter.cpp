#include "algorithms/greedy/queue/edge_sorter.h"

#include <algorithm>
#include <bit>

#include "geometry/mesh/distance.h"
#include "geometry/mesh/radix_sort.h"

namespace mwt {

namespace {

double rounded_squared_length(const PlanarMesh& mesh, MeshEdge e) {
  return rounded_squared_distance(mesh.point(mesh.origin(2 * e)), mesh.point(mesh.target(2 * e)));
}

int bits_of(std::uint64_t value) { return static_cast<int>(std::bit_width(value)); }

}  // namespace

void EdgeSorter::sort(std::span<const MeshEdge> edges) {
  sort_roughly(edges);
  for (std::size_t first = 0, last = 1; first < keys_.size(); first = last++) {
    while (last < keys_.size() && !surely_increases(last)) ++last;
    if (last - first > 1) sort_exactly(first, last);
  }
}

void EdgeSorter::sort_roughly(std::span<const MeshEdge> edges) {
  // The bits of non-negative doubles order like the doubles.
  keys_.resize(edges.size());
  std::uint64_t max_bits = 0;
  min_bits_ = ~std::uint64_t{0};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    keys_[i] = std::bit_cast<std::uint64_t>(rounded_squared_length(mesh_, edges[i]));
    min_bits_ = std::min(min_bits_, keys_[i]);
    max_bits = std::max(max_bits, keys_[i]);
  }
  const int length_bits = bits_of(max_bits - min_bits_);
  dropped_bits_ = std::max(0, length_bits + kEdgeBits - 64);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    keys_[i] = ((keys_[i] - min_bits_) >> dropped_bits_ << kEdgeBits) | edges[i];
  }
  constexpr std::size_t kManyEdges = 1000;
  if (edges.size() < kManyEdges) {
    std::sort(keys_.begin(), keys_.end());
  } else {
    radix_sort(keys_, kEdgeBits, kEdgeBits + length_bits - dropped_bits_, buffer_);
  }
}

// Whether the i-th edge is certainly longer than the one before it.
bool EdgeSorter::surely_increases(std::size_t i) const {
  const std::uint64_t before = keys_[i - 1] >> kEdgeBits, here = keys_[i] >> kEdgeBits;
  if (here <= before) return false;
  // Squared lengths in the trusted range are apart by more than twice the 9 ulps by which they may err together.
  constexpr std::uint64_t kSafeUlps = 32;
  const std::uint64_t least = min_bits_ + (here << dropped_bits_);
  return is_trusted_product(std::bit_cast<double>(least)) && ((here - before - 1) << dropped_bits_) >= kSafeUlps;
}

void EdgeSorter::sort_exactly(std::size_t first, std::size_t last) {
  run_.clear();
  for (std::size_t i = first; i < last; ++i) {
    run_.push_back(order_.key(mesh_.origin(2 * edge(i)), mesh_.target(2 * edge(i)), edge(i)));
  }
  order_.sort(run_);
  for (std::size_t i = first; i < last; ++i) keys_[i] = (keys_[i] & ~kEdgeMask) | run_[i - first].tag;
}

}  // namespace mwt
