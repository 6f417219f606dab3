#include "algorithms/greedy/candidate_queue.h"

#include <algorithm>
#include <bit>

#include "algorithms/mesh/radix_sort.h"

namespace mwt {

namespace {

double rounded_squared_length(const PlanarMesh& mesh, MeshEdge e) {
  const Point& p = mesh.point(mesh.origin(2 * e));
  const Point& q = mesh.point(mesh.target(2 * e));
  const double dx = p.x - q.x, dy = p.y - q.y;
  return dx * dx + dy * dy;
}

int bits_of(std::uint64_t value) { return static_cast<int>(std::bit_width(value)); }

struct KeyedEdge {
  EdgeKey key;
  MeshEdge edge;
};

// Sorts by (low, high) without comparing: by `high` first, then stably by `low`.
void sort_by_labels(std::span<KeyedEdge> edges) {
  const int place_bits = bits_of(edges.size());
  Index largest = 0;
  for (const KeyedEdge& e : edges) largest = std::max(largest, e.key.high);
  const int key_end = place_bits + bits_of(largest);
  const std::uint64_t place_mask = (std::uint64_t{1} << place_bits) - 1;
  HugeVector<std::uint64_t> order, buffer;
  order.reserve(edges.size());
  for (std::uint64_t i = 0; i < edges.size(); ++i)
    order.push_back((std::uint64_t{edges[i].key.high} << place_bits) | i);
  radix_sort(order, place_bits, key_end, buffer);
  for (std::uint64_t& entry : order) {
    const std::uint64_t place = entry & place_mask;
    entry = (std::uint64_t{edges[place].key.low} << place_bits) | place;
  }
  radix_sort(order, place_bits, key_end, buffer);
  std::vector<KeyedEdge> sorted;
  sorted.reserve(edges.size());
  for (const std::uint64_t entry : order) sorted.push_back(edges[entry & place_mask]);
  std::copy(sorted.begin(), sorted.end(), edges.begin());
}

// Whether all edges have equal lengths: exactly known ones, or differences of coordinates that are the same but for
// signs.
bool all_of_one_length(std::span<const KeyedEdge> edges, Points points) {
  return std::all_of(edges.begin(), edges.end(),
                     [&](const KeyedEdge& e) { return have_equal_lengths(e.key, edges.front().key, points); });
}

// Sorts edges whose squared lengths are sorted as far as double-doubles go.
void sort_nearly_equal(std::span<KeyedEdge> edges, Points points) {
  constexpr std::size_t kManyEdges = 64;
  if (edges.size() > kManyEdges && all_of_one_length(edges, points)) {
    sort_by_labels(edges);
  } else {
    std::sort(edges.begin(), edges.end(),
              [&](const KeyedEdge& a, const KeyedEdge& b) { return precedes(a.key, b.key, points); });
  }
}

}  // namespace

void EdgeSorter::sort(std::span<const MeshEdge> edges) {
  sort_by_rounded_length(edges);
  sort_undecided_runs();
}

void EdgeSorter::sort_by_rounded_length(std::span<const MeshEdge> edges) {
  // The bits of non-negative doubles order like the doubles.
  keys_.resize(edges.size());
  std::uint64_t largest_bits = 0;
  smallest_bits_ = ~std::uint64_t{0};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    keys_[i] = std::bit_cast<std::uint64_t>(rounded_squared_length(mesh_, edges[i]));
    smallest_bits_ = std::min(smallest_bits_, keys_[i]);
    largest_bits = std::max(largest_bits, keys_[i]);
  }
  const int length_bits = bits_of(largest_bits - smallest_bits_);
  dropped_bits_ = std::max(0, length_bits + kEdgeBits - 64);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    keys_[i] = ((keys_[i] - smallest_bits_) >> dropped_bits_ << kEdgeBits) | edges[i];
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
  const std::uint64_t least = smallest_bits_ + (here << dropped_bits_);
  const bool trusted = least > std::bit_cast<std::uint64_t>(1e-250) && least < std::bit_cast<std::uint64_t>(1e290);
  return trusted && ((here - before - 1) << dropped_bits_) >= kSafeUlps;
}

void EdgeSorter::sort_undecided_runs() {
  for (std::size_t first = 0, last = 1; first < keys_.size(); first = last++) {
    while (last < keys_.size() && !surely_increases(last)) ++last;
    if (last - first > 1) sort_exactly(first, last);
  }
}

void EdgeSorter::sort_exactly(std::size_t first, std::size_t last) {
  std::vector<KeyedEdge> run;
  run.reserve(last - first);
  for (std::size_t i = first; i < last; ++i) {
    const Edge ends = mesh_.labelled_edge(edge(i));
    run.push_back({edge_key(points_, ends.a, ends.b), edge(i)});
  }
  std::sort(run.begin(), run.end(),
            [](const KeyedEdge& a, const KeyedEdge& b) { return a.key.squared_length < b.key.squared_length; });
  for (std::size_t start = 0, end = 1; start < run.size(); start = end++) {
    while (end < run.size() && !is_surely_shorter(run[end - 1].key, run[end].key)) ++end;
    if (end - start > 1) sort_nearly_equal(std::span(run).subspan(start, end - start), points_);
  }
  for (std::size_t i = first; i < last; ++i) keys_[i] = (keys_[i] & ~kEdgeMask) | run[i - first].edge;
}

// Squared lengths with the same exponent and 6 leading bits share a bucket; all beyond the range in which they can be
// trusted share the last one or the first. Rounding may put two lengths in the wrong order when they are within a few
// ulps of each other: those within kMargin of a bucket's start count as belonging to the bucket before.
namespace {

constexpr int kBucketShift = 46;
constexpr std::uint64_t kMargin = 64;

std::uint64_t length_bits(const Candidate& candidate) {
  return std::bit_cast<std::uint64_t>(std::clamp(candidate.key.squared_length.high, 1e-250, 1e290));
}

}  // namespace

std::uint64_t CandidateHeap::bucket_of(const Candidate& candidate) {
  return (length_bits(candidate) - kMargin) >> kBucketShift;
}

std::uint64_t CandidateHeap::least_length_bits(std::uint64_t bucket) { return (bucket << kBucketShift) + kMargin; }

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
    const bool top_is_ahead =
        !heap_.empty() && length_bits(heap_.front()) + kMargin / 2 < least_length_bits(first->first);
    if (top_is_ahead) return;
    open_bucket_ = first->first;
    heap_.insert(heap_.end(), first->second.begin(), first->second.end());
    std::make_heap(heap_.begin(), heap_.end(), later_);
    waiting_.erase(first);
  }
  open_bucket_ = kLastBucket;
}

}  // namespace mwt
