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
void sort_by_labels(std::vector<KeyedEdge>& edges) {
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
  edges.swap(sorted);
}

bool all_of_one_exact_length(const std::vector<KeyedEdge>& edges) {
  return std::all_of(edges.begin(), edges.end(), [&](const KeyedEdge& e) {
    return e.key.exact && e.key.squared_length == edges.front().key.squared_length;
  });
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
  constexpr std::size_t kManyEdges = 1000;
  if (run.size() > kManyEdges && all_of_one_exact_length(run)) {
    sort_by_labels(run);
  } else {
    std::sort(run.begin(), run.end(),
              [&](const KeyedEdge& a, const KeyedEdge& b) { return precedes(a.key, b.key, points_); });
  }
  for (std::size_t i = first; i < last; ++i) keys_[i] = (keys_[i] & ~kEdgeMask) | run[i - first].edge;
}

}  // namespace mwt
