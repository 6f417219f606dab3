// The queue of greedy's candidates: a sorted list of the edges known from the start and a heap of later ones.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "geometry/mesh/edge_order.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// What may become greedy's next edge.
class Candidate {
 public:
  /// A mesh edge, as long as it is not flipped away.
  [[nodiscard]] static Candidate edge(const PlanarMesh& mesh, const EdgeOrder& order, MeshEdge e) {
    return Candidate(order.key(mesh.origin(2 * e), mesh.target(2 * e), 2 * e));
  }
  /// The third side of a wedge, named by its first halfedge, which is fixed and so stays.
  [[nodiscard]] static Candidate ear(const PlanarMesh& mesh, const EdgeOrder& order, Halfedge first, Halfedge last) {
    return Candidate(order.key(mesh.target(first), mesh.target(last), kEarBit | first));
  }

  [[nodiscard]] const EdgeKey& key() const { return key_; }
  [[nodiscard]] bool is_ear() const { return (key_.tag & kEarBit) != 0; }
  [[nodiscard]] Halfedge place() const { return key_.tag & ~kEarBit; }
  [[nodiscard]] bool joins(Index a, Index b) const {
    return (key_.a == a && key_.b == b) || (key_.a == b && key_.b == a);
  }

 private:
  static constexpr std::uint32_t kEarBit = std::uint32_t{1} << 31;  // a mesh has fewer than 3 * 2^29 halfedges
  explicit Candidate(const EdgeKey& key) : key_(key) {}

  EdgeKey key_;
};

/// Sorts mesh edges in greedy's order. O(n) for many edges: radix sort by squared length in floating point, then, run
/// by run as the user comes to them, exact sorting of what rounding leaves undecided. Keeps its buffers for the next
/// call.
class EdgeSorter {
 public:
  EdgeSorter(const PlanarMesh& mesh, const EdgeOrder& order) : mesh_(mesh), order_(order) {}

  /// Edges first .. last - 1 that rounding leaves undecided, maybe a single one. Between two bounds for their exact
  /// squared lengths.
  struct Run {
    std::size_t first;
    std::size_t last;
    double least;
    double most;
  };

  /// Afterwards edge(0), edge(1), ... are `edges`, in order up to decided() = 0.
  void sort(std::span<const MeshEdge> edges);

  /// The run that begins at decided(). Precondition: decided() < size().
  [[nodiscard]] Run next_run() const;

  /// Moves decided() to the end of the run, whose edges are put in order unless any order will do.
  void decide(const Run& run, bool any_order);
  [[nodiscard]] std::size_t decided() const { return decided_; }

  [[nodiscard]] std::size_t size() const { return keys_.size(); }
  [[nodiscard]] MeshEdge edge(std::size_t i) const { return static_cast<MeshEdge>(keys_[i] & kEdgeMask); }

 private:
  static constexpr int kEdgeBits = 30;  // a mesh has fewer than 3 * 2^28 edges
  static constexpr std::uint64_t kEdgeMask = (std::uint64_t{1} << kEdgeBits) - 1;

  void sort_exactly(std::size_t first, std::size_t last);
  [[nodiscard]] bool surely_increases(std::size_t i) const;
  [[nodiscard]] double rounded_down(std::uint64_t leading_bits) const;

  const PlanarMesh& mesh_;
  const EdgeOrder& order_;
  KeptVector<std::uint64_t> keys_;  // high bits: truncated squared length; low bits: edge
  KeptVector<std::uint64_t> buffer_;
  KeptVector<EdgeKey> run_;
  std::uint64_t min_bits_ = 0;
  int dropped_bits_ = 0;
  std::size_t decided_ = 0;
};

/// A priority queue of candidates that came up on the way, for use in increasing order: nothing is pushed that precedes
/// what was popped before. Once there are many, long ones wait unsorted in buckets by length; a bucket is sorted when
/// its turn comes, and only what is pushed after that goes through a heap. So nearly all that comes next is known.
class CandidateHeap {
 public:
  explicit CandidateHeap(const EdgeOrder& order) : later_{&order} {}

  [[nodiscard]] bool empty() const { return heap_.empty() && next_ == sorted_.size(); }
  /// The first candidate. Precondition: not empty.
  [[nodiscard]] const Candidate& top() const { return heap_is_first() ? heap_.front() : sorted_[next_]; }

  void push(const Candidate& candidate);
  void pop();

  /// The candidate that will probably be on top after `steps` pops, if that is known.
  [[nodiscard]] const Candidate* ahead(std::size_t steps) const {
    return next_ + steps < sorted_.size() ? &sorted_[next_ + steps] : nullptr;
  }

 private:
  static constexpr std::size_t kLargeHeap = 4096;
  static constexpr std::size_t kLargeBucket = 1024;
  static constexpr std::uint64_t kLastBucket = ~std::uint64_t{0};

  struct Later {
    const EdgeOrder* order;
    bool operator()(const Candidate& a, const Candidate& b) const { return order->precedes(b.key(), a.key()); }
  };

  [[nodiscard]] bool heap_is_first() const {
    return next_ == sorted_.size() || (!heap_.empty() && later_(sorted_[next_], heap_.front()));
  }
  void set_long_ones_aside();
  void open_due_buckets();

  Later later_;
  KeptVector<Candidate> heap_;
  KeptVector<Candidate> sorted_;  // an opened bucket; those from next_ on are still in the queue
  std::size_t next_ = 0;
  std::uint64_t open_bucket_ = kLastBucket;  // candidates of this bucket and of those before it go to the heap
  std::map<std::uint64_t, KeptVector<Candidate>> waiting_;
};

}  // namespace mwt
