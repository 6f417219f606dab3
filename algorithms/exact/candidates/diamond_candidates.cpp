#include "algorithms/exact/candidates/diamond_candidates.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include "algorithms/exact/candidates/long_edges.h"
#include "algorithms/exact/candidates/near_points.h"
#include "algorithms/exact/search_stopped.h"

namespace mwt {

namespace {

// An edge this many times as long as the distance from one of its ends to its nearest neighbour is tested against all
// points if it is longer than the near points reach: they are many along a curve, but all on it.
constexpr float kManyTimesNearest = 32;

// So is any edge this many times as long: points so close to an end count as on the edge's line for floats.
constexpr float kVeryManyTimesNearest = 1e4F;

constexpr std::uint16_t kNeverDead = 0x7F80;  // upper half of the float infinity

// The code of the largest representable distance not above `distance`: comparable with codes of dead distances.
std::uint16_t code_of(float distance) {
  return static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(distance) >> 16);
}

// A range of bins, first .. first + count - 1 around the circle.
struct BinRange {
  int first;
  int count;
};

// The bins of all directions from a point of one box to a point of the other. Precondition: the boxes are at least
// kMinDistance apart.
BinRange directions_between(const Box& from, const Box& to, double scale) {
  const auto low_x = static_cast<float>((to.min_x - from.max_x) * scale),
             high_x = static_cast<float>((to.max_x - from.min_x) * scale);
  const auto low_y = static_cast<float>((to.min_y - from.max_y) * scale),
             high_y = static_cast<float>((to.max_y - from.min_y) * scale);
  const float center = bin_position(0.5F * (low_x + high_x), 0.5F * (low_y + high_y));
  float least = 0, most = 0;
  for (const auto& [x, y] : {std::pair{low_x, low_y}, {low_x, high_y}, {high_x, low_y}, {high_x, high_y}}) {
    float turn = bin_position(x, y) - center;
    if (turn > kDirectionBins / 2.0F) turn -= kDirectionBins;
    if (turn < -kDirectionBins / 2.0F) turn += kDirectionBins;
    least = std::min(least, turn);
    most = std::max(most, turn);
  }
  constexpr float kRounding = 0.01F;  // of a bin: far more than what floats lose
  const int first = static_cast<int>(std::floor(center + least - kRounding));
  const int last = static_cast<int>(std::floor(center + most + kRounding));
  return {(first + kDirectionBins) % kDirectionBins, std::min(last - first + 1, kDirectionBins)};
}

bool has_open_direction(const DeadDistances& dead) { return dead.farthest() >= kNeverDead; }

}  // namespace

std::uint32_t PointBlocks::block_of(Index p) const {
  // The inverse of KdOrder::first_of at the blocks' level, up to rounding.
  auto block = static_cast<std::uint32_t>(std::uint64_t{p} * count_ / order_.points.size());
  while (order_.last_of(node_of(block)) <= p) ++block;
  return block;
}

DiamondTest::DiamondTest(const KdOrder& order)
    : order_(order),
      blocks_(order),
      scale_(distance_scale(order)),
      nearest_square_(order.points.size()),
      dead_(blocks_.count()),
      dead_of_node_(2 * std::size_t{order.leaf_count}) {
  tbb::parallel_for(std::uint32_t{0}, blocks_.count(), [&](std::uint32_t block) { compute_dead_distances_of(block); });
  for (std::uint32_t node = order_.leaf_count - 1; node >= 1; --node) {
    set_maximum(node, std::span<const DeadDistances>(dead_of_node_).subspan(2 * std::size_t{node}, 2));
  }
}

void DiamondTest::compute_dead_distances_of(std::uint32_t block) {
  const Index first = order_.first_of(blocks_.node_of(block));
  dead_[block].resize(order_.last_of(blocks_.node_of(block)) - first);
  NearPointsFinder finder(order_);
  for (std::uint32_t leaf = blocks_.first_leaf_of(block); leaf < blocks_.last_leaf_of(block); ++leaf) {
    find_nearest(leaf);
    const std::size_t size = order_.last_of(leaf) - order_.first_of(leaf);
    const auto dead = std::span(dead_[block]).subspan(order_.first_of(leaf) - first, size);
    compute_dead_distances(finder.find(leaf), dead);
    if (std::any_of(dead.begin(), dead.end(), has_open_direction)) {
      compute_dead_distances(finder.add_samples(leaf), dead);
    }
    set_maximum(leaf, dead);
  }
}

std::span<const DeadDistances> DiamondTest::dead_of_leaf(std::uint32_t leaf) const {
  const std::uint32_t block = blocks_.block_of_leaf(leaf);
  const Index first = order_.first_of(leaf);
  return std::span(dead_[block]).subspan(first - order_.first_of(blocks_.node_of(block)), order_.last_of(leaf) - first);
}

void DiamondTest::find_nearest(std::uint32_t leaf) {
  const Index first = order_.first_of(leaf), last = order_.last_of(leaf);
  for (Index p = first; p < last; ++p) {
    float nearest = std::numeric_limits<float>::infinity();
    for (Index q = first; q < last; ++q) {
      if (q != p) nearest = std::min(nearest, scaled_square(p, q));
    }
    nearest_square_[p] = nearest;
  }
}

float DiamondTest::scaled_square(Index p, Index q) const {
  const double x = (order_.points[p].x - order_.points[q].x) * scale_;
  const double y = (order_.points[p].y - order_.points[q].y) * scale_;
  return static_cast<float>(x * x + y * y);
}

void DiamondTest::set_maximum(std::uint32_t node, std::span<const DeadDistances> parts) {
  DeadDistances& maximum = dead_of_node_[node];
  for (const DeadDistances& part : parts) {
    for (std::size_t bin = 0; bin < part.code.size(); ++bin) {
      maximum.code[bin] = std::max(maximum.code[bin], part.code[bin]);
    }
  }
}

std::vector<Index> DiamondTest::possible_hull_points() const {
  std::vector<Index> found;
  for (std::uint32_t leaf = order_.leaf_count; leaf < 2 * order_.leaf_count; ++leaf) {
    if (!has_open_direction(dead_of_node_[leaf])) continue;
    const auto dead = dead_of_leaf(leaf);
    for (Index i = 0; i < dead.size(); ++i) {
      if (has_open_direction(dead[i])) found.push_back(order_.first_of(leaf) + i);
    }
  }
  return found;
}

// Whether an edge between a point of the leaf and one of the node may pass.
bool DiamondTest::may_connect(std::uint32_t leaf, std::uint32_t node) const {
  const Box& from = order_.boxes[leaf];
  const Box& to = order_.boxes[node];
  const float distance = box_distance(from, to, scale_);
  if (distance < kMinDistance) return true;
  const std::uint16_t code = code_of(distance);
  if (code >= std::min(dead_of_node_[leaf].farthest(), dead_of_node_[node].farthest())) return false;
  const BinRange range = directions_between(from, to, scale_);
  const DeadDistances& here = dead_of_node_[leaf];
  const DeadDistances& there = dead_of_node_[node];
  for (int i = 0; i < range.count; ++i) {
    const int bin = (range.first + i) % kDirectionBins;
    const int opposite = (bin + kDirectionBins / 2) % kDirectionBins;
    const auto dead =
        std::min(here.code[static_cast<std::size_t>(bin)], there.code[static_cast<std::size_t>(opposite)]);
    if (code < dead) return true;
  }
  return false;
}

// The leaves below the root with an edge to `leaf`, perhaps, of nodes that may be visited, in tree order.
template <class MayVisit>
void DiamondTest::collect_partners(std::uint32_t leaf, std::uint32_t root, const MayVisit& may_visit,
                                   FlatLeafTest& flat, Partners& partners) const {
  partners.clear();
  flat.start(leaf, std::bit_cast<float>(std::uint32_t{dead_of_node_[leaf].farthest()} << 16));
  std::array<Partner, 64> stack{{{root, ~0U >> (32 - (order_.last_of(leaf) - order_.first_of(leaf)))}}};
  std::size_t height = 1;  // of a path in the tree and its siblings
  while (height > 0) {
    auto [node, open] = stack[--height];
    if (!may_visit(node) || !may_connect(leaf, node)) continue;
    open = flat.with_edges_into(node, open);
    if (open == 0) continue;
    if (order_.is_leaf(node)) {
      partners.push_back({node, open});
    } else {
      stack[height++] = {2 * node + 1, open};
      stack[height++] = {2 * node, open};
    }
  }
}

// Whether the near points do not decide about the edge. `reach`: the near points are all points within this scaled
// distance of the pair's first point.
bool DiamondTest::is_long(const CandidatePair& pair, float reach) const {
  const float square = scaled_square(pair.p, pair.q);
  const float nearest = std::min(nearest_square_[pair.p], nearest_square_[pair.q]);
  const float enough = square > reach * reach ? kManyTimesNearest : kVeryManyTimesNearest;
  return square > enough * enough * nearest;
}

// collect(leaf, flat, partners) finds the leaves that edges may lead to.
template <class Collect>
void DiamondTest::search_block(std::uint32_t block, const Collect& collect, const Context& context,
                               std::vector<CandidatePair>& candidates) {
  FlatLeafTest flat(order_);
  LongEdgeTest long_edges(order_);
  Partners partners;
  std::array<CandidatePair, KdOrder::kMaxLeaf * KdOrder::kMaxLeaf> found;
  for (std::uint32_t leaf = blocks_.first_leaf_of(block); leaf < blocks_.last_leaf_of(block); ++leaf) {
    collect(leaf, flat, partners);
    if (partners.empty()) continue;
    const std::size_t before = candidates.size();
    const CandidateSearch search{order_.points, flat.near(), order_.first_of(leaf), dead_of_leaf(leaf)};
    const float reach = search.near.distance[static_cast<std::size_t>(search.near.leaves - 1)];
    for (const auto& [partner, open] : partners) {
      const std::size_t count =
          append_candidates(search, {order_.first_of(partner), dead_of_leaf(partner), open}, found.data());
      long_edges.start(leaf, partner);
      std::copy_if(
          found.begin(), found.begin() + static_cast<std::ptrdiff_t>(count), std::back_inserter(candidates),
          [&](const CandidatePair& pair) { return !(is_long(pair, reach) && long_edges.is_excluded(pair.p, pair.q)); });
    }
    add_to_count(candidates.size() - before, context);
  }
}

void DiamondTest::add_to_count(std::size_t found, const Context& context) {
  if (context.deadline_passed())
    throw SearchStopped(StopReason::deadline, "the deadline passed during the diamond test");
  const std::size_t limit = max_candidates(order_.points.size());
  if (count_ += found; count_ > limit)
    throw SearchStopped(StopReason::size, "more than " + std::to_string(limit) + " edges pass the diamond test");
}

std::vector<std::vector<CandidatePair>> DiamondTest::find_outer(const Context& context) {
  std::vector<std::vector<CandidatePair>> outer(blocks_.count());
  tbb::parallel_for(std::uint32_t{0}, blocks_.count(), [&](std::uint32_t block) {
    const Index end = order_.last_of(blocks_.node_of(block));
    const auto reaches_beyond = [&](std::uint32_t node) { return order_.last_of(node) > end; };
    search_block(
        block,
        [&](std::uint32_t leaf, FlatLeafTest& flat, Partners& partners) {
          collect_partners(leaf, 1, reaches_beyond, flat, partners);
        },
        context, outer[block]);
  });
  return outer;
}

void DiamondTest::take_inner(std::uint32_t block, const Context& context, std::vector<CandidatePair>& found) {
  found.clear();
  search_block(
      block,
      [&](std::uint32_t leaf, FlatLeafTest& flat, Partners& partners) {
        const Index first = order_.first_of(leaf);
        collect_partners(
            leaf, blocks_.node_of(block), [&](std::uint32_t node) { return order_.last_of(node) > first; }, flat,
            partners);
      },
      context, found);
  dead_[block] = std::vector<DeadDistances>();  // {} would keep the memory
}

}  // namespace mwt
