// The queue of greedy's candidates: a sorted list of the edges known from the start and a heap of later ones.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "algorithms/mesh/edge_order.h"
#include "algorithms/mesh/planar_mesh.h"

namespace mwt {

/// What may become greedy's next edge.
struct Candidate {
  EdgeKey key;
  enum class Kind : std::uint8_t {
    edge,  ///< a mesh edge, found at `place`
    ear    ///< the third side of a wedge; `place` is the wedge's first halfedge, which is fixed and so stays
  } kind = Kind::edge;
  Halfedge place = 0;
};

/// Sorts mesh edges in greedy's order. O(n) for many edges: radix sort by squared length in floating point, then exact
/// sorting within the runs that rounding leaves undecided. Keeps its buffers for the next call.
class EdgeSorter {
 public:
  /// `points` in the caller's numbering.
  EdgeSorter(const PlanarMesh& mesh, Points points) : mesh_(mesh), points_(points) {}

  /// Afterwards edge(0), edge(1), ... are `edges` in order.
  void sort(std::span<const MeshEdge> edges);

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] MeshEdge edge(std::size_t i) const { return static_cast<MeshEdge>(keys_[i] & kEdgeMask); }

 private:
  static constexpr int kEdgeBits = 30;  // a mesh has fewer than 3 * 2^28 edges
  static constexpr std::uint64_t kEdgeMask = (std::uint64_t{1} << kEdgeBits) - 1;

  void sort_by_rounded_length(std::span<const MeshEdge> edges);
  void sort_undecided_runs();
  void sort_exactly(std::size_t first, std::size_t last);
  [[nodiscard]] bool surely_increases(std::size_t i) const;

  const PlanarMesh& mesh_;
  Points points_;
  HugeVector<std::uint64_t> keys_;  // high bits: truncated squared length; low bits: edge
  HugeVector<std::uint64_t> buffer_;
  std::uint64_t smallest_bits_ = 0;
  int dropped_bits_ = 0;
};

/// A priority queue of candidates that came up on the way, for use in increasing order: nothing is pushed that precedes
/// what was popped before. Once it is large, long candidates wait unsorted in buckets by length, so that the heap
/// proper stays in the cache.
class CandidateHeap {
 public:
  explicit CandidateHeap(Points points) : later_{points} {}

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] const Candidate& top() const { return heap_.front(); }

  void push(const Candidate& candidate) {
    if (const std::uint64_t bucket = bucket_of(candidate); bucket > open_bucket_) {
      waiting_[bucket].push_back(candidate);
    } else {
      heap_.push_back(candidate);
      std::push_heap(heap_.begin(), heap_.end(), later_);
      if (heap_.size() > kLargeHeap && open_bucket_ == kLastBucket) set_long_ones_aside();
    }
    if (!waiting_.empty()) open_due_buckets();
  }

  void pop() {
    std::pop_heap(heap_.begin(), heap_.end(), later_);
    heap_.pop_back();
    if (!waiting_.empty()) open_due_buckets();
  }

 private:
  static constexpr std::size_t kLargeHeap = 4096;
  static constexpr std::uint64_t kLastBucket = ~std::uint64_t{0};

  struct Later {
    Points points;
    bool operator()(const Candidate& a, const Candidate& b) const { return precedes(b.key, a.key, points); }
  };

  [[nodiscard]] static std::uint64_t bucket_of(const Candidate& candidate);
  [[nodiscard]] static std::uint64_t least_length_bits(std::uint64_t bucket);
  void set_long_ones_aside();
  void open_due_buckets();

  Later later_;
  std::vector<Candidate> heap_;
  std::uint64_t open_bucket_ = kLastBucket;  // candidates of this bucket and of those before it go to the heap
  std::map<std::uint64_t, std::vector<Candidate>> waiting_;
};

}  // namespace mwt
