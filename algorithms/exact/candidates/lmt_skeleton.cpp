#include "algorithms/exact/candidates/lmt_skeleton.h"

#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>

#include "algorithms/exact/candidates/near_points.h"
#include "algorithms/exact/search_stopped.h"

namespace mwt {

namespace {

// Coarsely by length, longest first: exact order within one part in 16 of an octave does not matter.
std::vector<CandidatePair> longest_first(Points points, double scale, const std::vector<CandidatePair>& pairs) {
  constexpr int kShift = 20;  // keeps a float's exponent and three bits of its mantissa
  constexpr std::size_t kBuckets = std::size_t{1} << (31 - kShift);
  std::array<std::uint32_t, kBuckets + 1> first{};
  std::vector<std::uint16_t> bucket_of(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double x = (points[pairs[i].p].x - points[pairs[i].q].x) * scale;
    const double y = (points[pairs[i].p].y - points[pairs[i].q].y) * scale;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(static_cast<float>(x * x + y * y));
    const auto bucket = static_cast<std::uint16_t>(kBuckets - 1 - (bits >> kShift));
    bucket_of[i] = bucket;
    ++first[bucket + std::size_t{1}];
  }
  for (std::size_t b = 1; b < first.size(); ++b) first[b] += first[b - 1];
  std::vector<CandidatePair> sorted(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) sorted[first[bucket_of[i]]++] = pairs[i];
  return sorted;
}

class LmtStage {
 public:
  LmtStage(const KdOrder& order, const HullEdges& hull, CandidateBlocks& blocks, const Context& context,
           LmtSkeleton& skeleton)
      : order_(order),
        hull_(hull),
        blocks_(blocks),
        context_(context),
        skeleton_(skeleton),
        scale_(distance_scale(order)),
        incoming_(blocks.block_count()) {}

  void run() {
    skeleton_.stars.stars.resize(order_.points.size());
    skeleton_.stars.arenas.resize(blocks_.block_count());
    file_incoming();
    skeleton_.counters = descend(1).counters;
  }

 private:
  // What a node hands to its parent: the edges that leave it, from smaller ends inside.
  struct NodeResult {
    std::vector<CandidatePair> leaving;
    LmtCounters counters;
  };

  std::uint32_t block_of(Index p) const {
    // The inverse of KdOrder::first_of at the blocks' level, up to rounding.
    const std::uint64_t n = order_.points.size();
    auto block = static_cast<std::uint32_t>(std::uint64_t{p} * blocks_.block_count() / n);
    while (order_.last_of(blocks_.first_block_node + block) <= p) ++block;
    return block;
  }

  void file_incoming() {
    for (const auto& outer : blocks_.outer) {
      for (const CandidatePair& pair : outer) incoming_[block_of(pair.q)].push_back(pair);
    }
  }

  NodeResult descend(std::uint32_t node) {
    if (node >= blocks_.first_block_node) return process_block(node - blocks_.first_block_node);
    NodeResult low, high;
    tbb::parallel_invoke([&] { low = descend(2 * node); }, [&] { high = descend(2 * node + 1); });
    const Index end = order_.last_of(node);
    NodeResult result;
    result.counters = low.counters;
    result.counters.add(high.counters);
    std::vector<CandidatePair> between;
    for (const CandidatePair& pair : low.leaving) (pair.q < end ? between : result.leaving).push_back(pair);
    result.leaving.insert(result.leaving.end(), high.leaving.begin(), high.leaving.end());
    result.counters.add(delete_edges_without_certificate(skeleton_.stars, order_.points, hull_,
                                                         longest_first(order_.points, scale_, between), context_));
    return result;
  }

  NodeResult process_block(std::uint32_t block) {
    if (context_.deadline_passed())
      throw SearchStopped(StopReason::deadline, "the deadline passed during the LMT stage");
    const std::uint32_t node = blocks_.first_block_node + block;
    std::vector<std::uint32_t> arena = build_stars(node, block);
    NodeResult result;
    const auto edges = longest_first(order_.points, scale_, blocks_.inner[block]);
    blocks_.inner[block] = {};
    incoming_[block] = {};
    result.counters = delete_edges_without_certificate(skeleton_.stars, order_.points, hull_, edges, context_);
    compact_stars(node, block);
    result.leaving = std::move(blocks_.outer[block]);
    return result;
  }

  std::vector<std::uint32_t> build_stars(std::uint32_t node, std::uint32_t block) {
    const Index first = order_.first_of(node), last = order_.last_of(node);
    std::vector<Star>& stars = skeleton_.stars.stars;
    for (const auto& [p, q] : blocks_.inner[block]) {
      ++stars[p].capacity;
      ++stars[q].capacity;
    }
    for (const auto& [p, q] : blocks_.outer[block]) ++stars[p].capacity;
    for (const auto& [p, q] : incoming_[block]) ++stars[q].capacity;
    std::size_t words = StarTable::kSlack;
    for (Index v = first; v < last; ++v) words += Star::words_for(stars[v].capacity);
    std::vector<std::uint32_t> arena(words);
    std::uint32_t* place = arena.data();
    for (Index v = first; v < last; ++v) {
      stars[v].words = place;
      place += Star::words_for(stars[v].capacity);
    }
    // In this order each star's targets ascend, as CandidateBlocks promises.
    for (const auto& [p, q] : incoming_[block]) append(q, p);
    for (const auto& [p, q] : blocks_.inner[block]) {
      append(p, q);
      append(q, p);
    }
    for (const auto& [p, q] : blocks_.outer[block]) append(p, q);
    assert(std::all_of(stars.begin() + first, stars.begin() + last,
                       [](const Star& star) { return std::is_sorted(star.target(), star.target() + star.count); }));
    return arena;
  }

  void append(Index from, Index to) {
    Star& star = skeleton_.stars.stars[from];
    const std::uint32_t i = star.count++;
    star.target()[i] = to;
    star.x()[i] = Star::component(order_.points[to].x - order_.points[from].x, scale_);
    star.y()[i] = Star::component(order_.points[to].y - order_.points[from].y, scale_);
    star.certificate()[i] = Star::kNoCertificate;
  }

  // Moves the block's stars into an arena of their present size.
  void compact_stars(std::uint32_t node, std::uint32_t block) {
    const Index first = order_.first_of(node), last = order_.last_of(node);
    std::vector<Star>& stars = skeleton_.stars.stars;
    std::size_t words = StarTable::kSlack;
    for (Index v = first; v < last; ++v) words += Star::words_for(stars[v].count);
    std::vector<std::uint32_t>& arena = skeleton_.stars.arenas[block];
    arena.resize(words);
    std::uint32_t* place = arena.data();
    for (Index v = first; v < last; ++v) {
      Star& star = stars[v];
      for (std::size_t row = 0; row < 4; ++row) {
        std::copy_n(star.words + row * star.capacity, star.count, place + row * star.count);
      }
      star.words = place;
      star.capacity = star.count;
      place += Star::words_for(star.count);
    }
  }

  const KdOrder& order_;
  const HullEdges& hull_;
  CandidateBlocks& blocks_;
  const Context& context_;
  LmtSkeleton& skeleton_;
  double scale_;
  std::vector<std::vector<CandidatePair>> incoming_;  // edges from earlier blocks, by block
};

}  // namespace

LmtSkeleton find_lmt_skeleton(const KdOrder& order, const HullEdges& hull, CandidateBlocks blocks,
                              const Context& context) {
  LmtSkeleton skeleton;
  LmtStage(order, hull, blocks, context, skeleton).run();
  return skeleton;
}

}  // namespace mwt
