#include "algorithms/exact/candidates/lmt_skeleton.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <utility>

#include "algorithms/common/rows.h"
#include "algorithms/exact/candidates/near_points.h"
#include "algorithms/exact/search_stopped.h"
#include "algorithms/proof_trace.h"

namespace mwt {

namespace {

// Coarsely by length, longest first: exact order within one part in 16 of an octave does not matter.
std::vector<CandidatePair> longest_first(Points points, double scale, const std::vector<CandidatePair>& pairs) {
  constexpr int kShift = 20;  // keeps a float's exponent and three bits of its mantissa
  constexpr std::size_t kBuckets = std::size_t{1} << (31 - kShift);
  std::vector<std::uint16_t> bucket_of(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const double x = (points[pairs[i].p].x - points[pairs[i].q].x) * scale;
    const double y = (points[pairs[i].p].y - points[pairs[i].q].y) * scale;
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(static_cast<float>(x * x + y * y));
    bucket_of[i] = static_cast<std::uint16_t>(kBuckets - 1 - (bits >> kShift));
  }
  return file_in_rows<CandidatePair>(kBuckets,
                                     [&](const auto& file) {
                                       for (std::size_t i = 0; i < pairs.size(); ++i) file(bucket_of[i], pairs[i]);
                                     })
      .values;
}

class LmtStage {
 public:
  LmtStage(const KdOrder& order, const HullEdges& hull, DiamondTest& test, const Context& context,
           LmtSkeleton& skeleton)
      : order_(order),
        hull_(hull),
        test_(test),
        blocks_(test.blocks()),
        context_(context),
        skeleton_(skeleton),
        scale_(distance_scale(order)),
        incoming_(blocks_.count()),
        deleted_(context.proof != nullptr ? 2 * std::size_t{blocks_.count()} : 0) {}

  void run() {
    skeleton_.stars.stars.resize(order_.points.size());
    skeleton_.stars.arenas.resize(blocks_.count());
    outer_ = test_.find_outer(context_);
    file_incoming();
    skeleton_.counters = descend(1).counters;
    note_deletions();
  }

 private:
  // What one block after the other uses: its candidates, and its stars while their edges are examined.
  struct Workspace {
    std::vector<CandidatePair> inner;
    StarArena arena;
  };

  // What a node hands to its parent: the edges that leave it, from smaller ends inside.
  struct NodeResult {
    std::vector<CandidatePair> leaving;
    LmtCounters counters;
  };

  // Nodes of one level do not disturb each other, and those below a node come before it: higher numbers first.
  void note_deletions() const {
    if (context_.proof == nullptr) return;
    EdgeConclusions conclusions{EdgeReason::not_locally_minimal, {}, {}};
    conclusions.edges.reserve(skeleton_.counters.deleted);
    for (std::size_t node = deleted_.size(); node-- > 1;) {
      conclusions.edges.insert(conclusions.edges.end(), deleted_[node].begin(), deleted_[node].end());
    }
    context_.proof->edges.push_back(std::move(conclusions));
  }

  std::vector<Edge>* log_of(std::uint32_t node) { return deleted_.empty() ? nullptr : &deleted_[node]; }

  void file_incoming() {
    for (const auto& outer : outer_) {
      for (const CandidatePair& pair : outer) incoming_[blocks_.block_of(pair.q)].push_back(pair);
    }
  }

  NodeResult descend(std::uint32_t node) {
    if (node >= blocks_.count()) return process_block(node - blocks_.count());
    NodeResult low, high;
    tbb::parallel_invoke([&] { low = descend(2 * node); }, [&] { high = descend(2 * node + 1); });
    const Index end = order_.last_of(node);
    NodeResult result;
    result.counters = low.counters;
    result.counters.add(high.counters);
    std::vector<CandidatePair> between;
    for (const CandidatePair& pair : low.leaving) (pair.q < end ? between : result.leaving).push_back(pair);
    result.leaving.insert(result.leaving.end(), high.leaving.begin(), high.leaving.end());
    result.counters.add(delete_edges_without_certificate(
        skeleton_.stars, order_.points, hull_, longest_first(order_.points, scale_, between), context_, log_of(node)));
    return result;
  }

  NodeResult process_block(std::uint32_t block) {
    if (context_.deadline_passed())
      throw SearchStopped(StopReason::deadline, "the deadline passed during the LMT stage");
    const std::uint32_t node = blocks_.node_of(block);
    auto& [inner, arena] = workspaces_.local();
    test_.take_inner(block, context_, inner);
    build_stars(block, inner, arena);
    incoming_[block] = std::vector<CandidatePair>();  // {} would keep the memory
    NodeResult result;
    result.counters = delete_edges_without_certificate(
        skeleton_.stars, order_.points, hull_, longest_first(order_.points, scale_, inner), context_, log_of(node));
    compact_stars(node, block);
    result.leaving = std::move(outer_[block]);
    return result;
  }

  void build_stars(std::uint32_t block, const std::vector<CandidatePair>& inner, StarArena& arena) {
    const Index first = order_.first_of(blocks_.node_of(block)), last = order_.last_of(blocks_.node_of(block));
    std::vector<Star>& stars = skeleton_.stars.stars;
    for (const auto& [p, q] : inner) {
      ++stars[p].capacity;
      ++stars[q].capacity;
    }
    for (const auto& [p, q] : outer_[block]) ++stars[p].capacity;
    for (const auto& [p, q] : incoming_[block]) ++stars[q].capacity;
    std::size_t halfedges = 0;
    for (Index v = first; v < last; ++v) halfedges += stars[v].capacity;
    arena.reset(halfedges);
    for (Index v = first; v < last; ++v) stars[v] = arena.allot(stars[v].capacity);
    // In this order each star's targets ascend, as DiamondTest promises.
    for (const auto& [p, q] : incoming_[block]) append(q, p);
    for (const auto& [p, q] : inner) {
      append(p, q);
      append(q, p);
    }
    for (const auto& [p, q] : outer_[block]) append(p, q);
    assert(std::all_of(stars.begin() + first, stars.begin() + last,
                       [](const Star& star) { return std::ranges::is_sorted(star.targets()); }));
  }

  void append(Index from, Index to) {
    const Point &p = order_.points[from], &q = order_.points[to];
    skeleton_.stars.stars[from].append(to, Star::component(q.x - p.x, scale_), Star::component(q.y - p.y, scale_));
  }

  // Moves the block's stars into an arena of their present size.
  void compact_stars(std::uint32_t node, std::uint32_t block) {
    const Index first = order_.first_of(node), last = order_.last_of(node);
    std::vector<Star>& stars = skeleton_.stars.stars;
    std::size_t halfedges = 0;
    for (Index v = first; v < last; ++v) halfedges += stars[v].count;
    StarArena arena(halfedges);
    for (Index v = first; v < last; ++v) stars[v] = compact_copy(stars[v], arena);
    skeleton_.stars.arenas[block] = std::move(arena);
  }

  const KdOrder& order_;
  const HullEdges& hull_;
  DiamondTest& test_;
  const PointBlocks& blocks_;
  const Context& context_;
  LmtSkeleton& skeleton_;
  double scale_;
  std::vector<std::vector<CandidatePair>> outer_;     // edges to later blocks, by block
  std::vector<std::vector<CandidatePair>> incoming_;  // edges from earlier blocks, by block
  tbb::enumerable_thread_specific<Workspace> workspaces_;
  std::vector<std::vector<Edge>> deleted_;  // by node, if a proof is wanted
};

}  // namespace

LmtSkeleton find_lmt_skeleton(const KdOrder& order, const HullEdges& hull, DiamondTest& test, const Context& context) {
  LmtSkeleton skeleton;
  LmtStage(order, hull, test, context, skeleton).run();
  return skeleton;
}

std::uint64_t examine_between_large_stars(StarTable& table, const KdOrder& order, const HullEdges& hull,
                                          const Context& context) {
  const std::vector<Star>& stars = table.stars;
  std::vector<CandidatePair> edges;
  for (Index v = 0; v < stars.size(); ++v) {
    if (stars[v].count <= Star::kMaxExamined) continue;
    for (const Index w : stars[v].targets()) {
      if (v < w && stars[w].count > Star::kMaxExamined) edges.push_back({v, w});
    }
  }
  // Of few edges more may be tried: a plate with two holes and 3,000 points is then connected. Of more, up to kTooMany,
  // some at first: between chains that face each other nearly all of the longest go, in a wheel none.
  constexpr std::size_t kMany = std::size_t{1} << 20, kTooMany = std::size_t{1} << 22, kProbe = std::size_t{1} << 14;
  const auto sorted = longest_first(order.points, distance_scale(order), edges);
  const bool is_probed = edges.size() >= kMany && edges.size() < kTooMany;
  const std::size_t probe = is_probed ? kProbe : 0;
  std::vector<Edge> deleted;
  LmtCounters counters = delete_edges_without_certificate(table, order.points, hull, std::span(sorted).first(probe),
                                                          context, &deleted, 8 * Star::kMaxExaminedAtLast);
  const std::uint32_t factor = edges.size() < kMany ? 2 : counters.deleted > probe / 2 ? 8 : 1;
  counters.add(delete_edges_without_certificate(table, order.points, hull, std::span(sorted).subspan(probe), context,
                                                &deleted, factor * Star::kMaxExaminedAtLast));
  if (context.proof != nullptr)
    context.proof->edges.push_back({EdgeReason::not_locally_minimal, std::move(deleted), {}});
  if (context.deadline_passed()) throw SearchStopped(StopReason::deadline, "the deadline passed during the LMT stage");
  return counters.deleted;
}

}  // namespace mwt
