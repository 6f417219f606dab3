#include "verifier/regions.h"

#include <algorithm>
#include <limits>

#include "verifier/exact.h"
#include "verifier/refused.h"

namespace mwt::verifier {

namespace {

constexpr Index kNoPoint = std::numeric_limits<Index>::max();

// Leaves of which none proves less than another whatever the number of triangles. Nearly all proofs have one a region.
constexpr std::size_t kMaxLeastLeaves = 10'000;

bool proves_no_less(const Leaf& one, const Leaf& other) { return one.sum >= other.sum && one.worst >= other.worst; }

void keep_if_least(const Leaf& leaf, std::vector<Leaf>& least) {
  if (std::any_of(least.begin(), least.end(), [&](const Leaf& other) { return proves_no_less(leaf, other); })) return;
  std::erase_if(least, [&](const Leaf& other) { return proves_no_less(other, leaf); });
  require(least.size() < kMaxLeastLeaves, "a region has too many leaves");
  least.push_back(leaf);
}

}  // namespace

Regions::Regions(Points points, const PointTree& tree, const Reductions& reductions, const std::vector<Index>& hull)
    : points_(points),
      tree_(tree),
      reductions_(reductions),
      next_on_hull_(points.size(), kNoPoint),
      stars_(points.size()) {
  for (std::size_t i = 0; i < hull.size(); ++i) next_on_hull_[hull[i]] = hull[(i + 1) % hull.size()];
  for (Index v = 0; v < points.size(); ++v) {
    for (const Index to : reductions.candidates().star(v)) stars_[v].push_back({to});
  }
}

// Nothing if the edge is no candidate.
const Regions::Spoke* Regions::find(Index from, Index to) const {
  const auto& star = stars_[from];
  const auto place = std::lower_bound(star.begin(), star.end(), to, [](const Spoke& s, Index v) { return s.to < v; });
  return place != star.end() && place->to == to ? &*place : nullptr;
}
Regions::Spoke* Regions::find(Index from, Index to) {
  return const_cast<Spoke*>(static_cast<const Regions*>(this)->find(from, to));
}

void Regions::label_side(const Side& side, Label label) {
  const auto [from, to] = side;
  if (!reductions_.certain().contains(from, to)) throw Refused("a side of the region is not certain", {from, to});
  if (next_on_hull_[to] == from) throw Refused("the region lies outside the hull", {from, to});
  Label& left = find(from, to)->left;
  if (left != 0) throw Refused("two regions lie on the same side of an edge", {from, to});
  left = find(to, from)->right = label;
}

// Open edges that are no candidates any more may stand in the proof; no triangle has them as a side.
void Regions::label_open_edge(const OpenEdge& edge, Label label) {
  const auto [a, b] = edge;
  if (reductions_.certain().contains(a, b)) throw Refused("an edge of the region is certain", {a, b});
  Spoke* const from_a = find(a, b);
  if (from_a == nullptr) return;
  if (from_a->left != 0) throw Refused("an edge is open in two regions", {a, b});
  Spoke* const from_b = find(b, a);
  from_a->left = from_a->right = from_b->left = from_b->right = label;
}

void Regions::read(ProofReader& proof) {
  Region region(points_, tree_, proof);
  const auto label = static_cast<Label>(outcomes_.size() + 1);
  for (const Side& side : region.sides()) label_side(side, label);
  for (const OpenEdge& edge : region.open_edges()) label_open_edge(edge, label);
  Outcome& outcome = outcomes_.emplace_back(Outcome{region.unit_exponent(), {}});
  region.read_leaves(proof, [&](const Leaf& leaf) { keep_if_least(leaf, outcome.leaves); });
}

void Regions::check_labels_of_triangles() const {
  std::vector<const Spoke*> from_a(points_.size(), nullptr);  // the spokes of the point at hand, by their other ends
  for (Index a = 0; a < stars_.size(); ++a) {
    for (const Spoke& spoke : stars_[a]) from_a[spoke.to] = &spoke;
    for (const Spoke& ab : stars_[a]) {
      if (ab.to < a) continue;
      for (const Spoke& bc : stars_[ab.to]) {
        if (bc.to < ab.to || from_a[bc.to] == nullptr) continue;
        const Spoke& ac = *from_a[bc.to];
        const Index b = ab.to, c = bc.to;
        const bool same_left = ab.left == bc.left && ab.left == ac.right;
        const bool same_right = ab.right == bc.right && ab.right == ac.left;
        if (same_left && same_right) continue;
        const bool turns_left = turn(points_[a], points_[b], points_[c]) > 0;
        if (turns_left ? same_left : same_right) continue;
        if (!(turns_left ? tree_.is_empty(a, b, c) : tree_.is_empty(a, c, b))) continue;
        throw Refused("an empty triangle of candidates has sides in different regions", {a, b, c});
      }
    }
    for (const Spoke& spoke : stars_[a]) from_a[spoke.to] = nullptr;
  }
}

// By region. All triangulations that contain the certain edges and consist of candidates have as many triangles in each
// face of the certain edges, and a face lies in one region, that of its sides. For any other triangulation the answer
// is all triangles for each region.
std::vector<std::uint64_t> Regions::count_triangles(const std::vector<Corners>& triangulation) const {
  std::vector<std::uint64_t> count(outcomes_.size() + 1, 0);
  std::size_t certain_sides = 0, all_certain_sides = 0;
  bool consists_of_candidates = true;
  for (const auto& [a, b, c] : triangulation) {
    const Spoke *const ab = find(a, b), *const bc = find(b, c), *const ca = find(c, a);
    consists_of_candidates = consists_of_candidates && ab != nullptr && bc != nullptr && ca != nullptr;
    if (!consists_of_candidates) break;
    ++count[ab->left];
    for (const auto& [from, to] : {Side{a, b}, Side{b, c}, Side{c, a}}) {
      certain_sides += reductions_.certain().contains(from, to) ? 1 : 0;
    }
  }
  for (Index v = 0; v < points_.size(); ++v) {
    all_certain_sides += reductions_.certain().star(v).size() - (next_on_hull_[v] == kNoPoint ? 0 : 1);
  }
  if (consists_of_candidates && certain_sides == all_certain_sides) return count;
  return std::vector<std::uint64_t>(outcomes_.size() + 1, triangulation.size());
}

Bounds Regions::lower_bound(const std::vector<Corners>& triangulation) const {
  check_labels_of_triangles();
  const std::vector<std::uint64_t> triangles = count_triangles(triangulation);
  Bounds sum = 0;
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    const auto proved_by = [&](const Leaf& leaf) {
      return Bounds(leaf.sum) + Bounds(leaf.worst) * Bounds(triangles[i + 1]);
    };
    Bounds least = proved_by(outcomes_[i].leaves.front());
    for (const Leaf& leaf : outcomes_[i].leaves) {
      if (const Bounds proved = proved_by(leaf); proved < least) least = proved;  // all are exact
    }
    sum += scaled(least, outcomes_[i].unit_exponent);
  }
  return sum;
}

}  // namespace mwt::verifier
