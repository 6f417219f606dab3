#include "algorithms/greedy/queue/candidate_queue.h"

#include <algorithm>
#include <bit>

#include "geometry/mesh/distance.h"
#include "geometry/mesh/margins.h"
#include "geometry/mesh/radix_sort.h"

namespace mwt {

namespace {

double rounded_squared_length(const PlanarMesh& mesh, MeshEdge e) {
  return rounded_squared_distance(mesh.point(mesh.origin(2 * e)), mesh.point(mesh.target(2 * e)));
}

int bits_of(std::uint64_t value) { return static_cast<int>(std::bit_width(value)); }

}  // namespace

void EdgeSorter::sort(std::span<const MeshEdge> edges) {
  decided_ = 0;
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

EdgeSorter::Run EdgeSorter::next_run() const {
  std::size_t last = decided_ + 1;
  while (last < keys_.size() && !surely_increases(last)) ++last;
  const double least = rounded_down(keys_[decided_] >> kEdgeBits),
               most = rounded_down((keys_[last - 1] >> kEdgeBits) + 1);
  return {decided_, last, least * (1 - kSquareMargin), most * (1 + kSquareMargin)};
}

// The least squared length with these leading bits.
double EdgeSorter::rounded_down(std::uint64_t leading_bits) const {
  return std::bit_cast<double>(min_bits_ + (leading_bits << dropped_bits_));
}

void EdgeSorter::decide(const Run& run, bool any_order) {
  decided_ = run.last;
  if (!any_order && run.last - run.first > 1) sort_exactly(run.first, run.last);
}

void EdgeSorter::sort_exactly(std::size_t first, std::size_t last) {
  run_.clear();
  for (std::size_t i = first; i < last; ++i) {
    run_.push_back(order_.key(mesh_.origin(2 * edge(i)), mesh_.target(2 * edge(i)), edge(i)));
  }
  order_.sort(run_);
  for (std::size_t i = first; i < last; ++i) keys_[i] = (keys_[i] & ~kEdgeMask) | run_[i - first].tag;
}

// Squared lengths with the same exponent and 6 leading bits share a bucket; all beyond the range in which they can be
// trusted share the last one or the first. Rounding may put two lengths in the wrong order when they are within a few
// ulps of each other: those within kMarginUlps of a bucket's start count as belonging to the bucket before.
namespace {

constexpr int kBucketShift = 46;
constexpr std::uint64_t kMarginUlps = 64;

std::uint64_t length_bits(const Candidate& candidate) {
  return std::bit_cast<std::uint64_t>(
      std::clamp(candidate.key().squared_length.high, kMinTrustedProduct, kMaxTrustedProduct));
}

std::uint64_t bucket_of(const Candidate& candidate) { return (length_bits(candidate) - kMarginUlps) >> kBucketShift; }

std::uint64_t min_length_bits(std::uint64_t bucket) { return (bucket << kBucketShift) + kMarginUlps; }

}  // namespace

void CandidateHeap::push(const Candidate& candidate) {
  if (open_bucket_ != kLastBucket) {
    if (const std::uint64_t bucket = bucket_of(candidate); bucket > open_bucket_) {
      waiting_[bucket].push_back(candidate);
      return open_due_buckets();
    }
  }
  heap_.push_back(candidate);
  std::push_heap(heap_.begin(), heap_.end(), later_);
  if (heap_.size() > kLargeHeap && open_bucket_ == kLastBucket) set_long_ones_aside();
}

void CandidateHeap::pop() {
  if (heap_is_first()) {
    std::pop_heap(heap_.begin(), heap_.end(), later_);
    heap_.pop_back();
  } else {
    ++next_;
  }
  if (!waiting_.empty()) open_due_buckets();
}

void CandidateHeap::set_long_ones_aside() {
  open_bucket_ = bucket_of(heap_.front());
  const auto is_near = [&](const Candidate& candidate) { return bucket_of(candidate) <= open_bucket_; };
  const auto first_long = std::partition(heap_.begin(), heap_.end(), is_near);
  for (auto candidate = first_long; candidate != heap_.end(); ++candidate) {
    waiting_[bucket_of(*candidate)].push_back(*candidate);
  }
  heap_.erase(first_long, heap_.end());
  std::make_heap(heap_.begin(), heap_.end(), later_);
}

// Keeps the top ahead of everything that waits: certainly, that is by more than rounding.
void CandidateHeap::open_due_buckets() {
  while (!waiting_.empty()) {
    const auto first = waiting_.begin();
    if (!empty() && length_bits(top()) + kMarginUlps / 2 < min_length_bits(first->first)) return;
    sorted_.erase(sorted_.begin(), sorted_.begin() + static_cast<std::ptrdiff_t>(next_));
    next_ = 0;
    while (!waiting_.empty() && sorted_.size() < kLargeBucket) {
      const auto opened = waiting_.begin();
      open_bucket_ = opened->first;
      sorted_.insert(sorted_.end(), opened->second.begin(), opened->second.end());
      waiting_.erase(opened);
    }
    std::sort(sorted_.begin(), sorted_.end(), [this](const Candidate& x, const Candidate& y) { return later_(y, x); });
  }
  open_bucket_ = kLastBucket;
}

}  // namespace mwt
