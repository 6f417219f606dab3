#include "verifier/region.h"

#include <algorithm>
#include <limits>

#include "verifier/bounds.h"
#include "verifier/exact.h"
#include "verifier/refused.h"

namespace mwt::verifier {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

// Half lengths and dual values are smaller, so that sums of six of them fit into 64 bits.
constexpr std::int64_t kLimit = std::int64_t{1} << 60;

constexpr std::uint8_t kLeafTag = 0;
constexpr std::uint8_t kBranchTag = 1;

bool is_branch(std::uint8_t tag) {
  require(tag == kLeafTag || tag == kBranchTag, "a node is neither a leaf nor a branch");
  return tag == kBranchTag;
}

}  // namespace

Region::Region(Points points, const PointTree& tree, ProofReader& proof) : points_(points), tree_(tree) {
  unit_exponent_ = static_cast<long>(proof.signed_number());
  require(unit_exponent_ > -5000 && unit_exponent_ < 5000, "the unit of length is out of range");
  // Closed walks around the region, which is to their left, and then the points that no certain edge meets. The fewer
  // than 3 n certain edges have two sides each.
  const std::size_t max_places = 7 * points.size();
  std::vector<Index> places;
  Index last = 0;
  const auto read_places = [&](std::uint64_t count) {
    for (std::uint64_t i = 0; i < count; ++i) {
      require(places.size() < max_places, "a region has too many places");
      places.push_back(last = proof.index_near(last, points.size()));
    }
  };
  std::uint64_t walks = proof.number();
  require(walks > 0, "a region has no boundary");
  for (; walks > 0; --walks) {
    const std::size_t first = places.size();
    read_places(proof.number());
    require(places.size() >= first + 2, "a walk around a region has fewer than two sides");
    for (std::size_t i = first; i < places.size(); ++i) {
      sides_.push_back({places[i], i + 1 < places.size() ? places[i + 1] : places[first]});
    }
  }
  read_places(proof.number());
  const std::uint64_t open = proof.number();
  std::vector<std::uint64_t> from;
  for (std::uint64_t i = 0, place = 0, from_here = 0; i < open; ++i) {
    const std::uint64_t step = proof.number();
    require(step < places.size() - place, "an edge's end is not among the places of the region");
    place += step;
    from_here = step == 0 ? from_here + 1 : 1;
    require(from_here < places.size() - place, "more edges begin at a place than end at later ones");
    from.push_back(place);
  }
  for (const std::uint64_t place : from) {
    const std::uint64_t to = place + 1 + proof.number_below(places.size());
    require(to < places.size(), "an edge's end is not among the places of the region");
    open_edges_.push_back({places[place], places[to]});
  }
  corners_ = places;
  std::sort(corners_.begin(), corners_.end());
  corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
  spokes_.resize(corners_.size());
  edge_to_.assign(corners_.size(), kNone);
  for (const Side& side : sides_) edge_of_side_.push_back(add_edge(side.from, side.to, false));
  for (const OpenEdge& edge : open_edges_) edge_of_open_.push_back(add_edge(edge.a, edge.b, true));
  compute_half_lengths();
}

// The number of the edge, which is new unless this is the second side of a certain edge.
Region::EdgeNumber Region::add_edge(Index from, Index to, bool is_open) {
  const auto corner_of = [&](Index point) {
    return static_cast<Corner>(std::lower_bound(corners_.begin(), corners_.end(), point) - corners_.begin());
  };
  require(from != to, "an edge of a region ends where it begins");
  const Corner a = corner_of(std::min(from, to)), b = corner_of(std::max(from, to));
  auto& spokes = spokes_[a];
  const auto place =
      std::lower_bound(spokes.begin(), spokes.end(), b, [](const Spoke& s, Corner c) { return s.to < c; });
  const bool is_new = place == spokes.end() || place->to != b;
  if (is_new) {
    spokes.insert(place, {b, static_cast<EdgeNumber>(edges_.size())});
    edges_.push_back({a, b, is_open});
  }
  const EdgeNumber number = is_new ? static_cast<EdgeNumber>(edges_.size() - 1) : place->edge;
  RegionEdge& edge = edges_[number];
  bool& has_side = from < to ? edge.has_forward : edge.has_backward;
  require(is_new || (!is_open && !edge.is_open && !has_side), "an edge appears twice in a region");
  has_side = true;
  if (is_open) edge.has_forward = edge.has_backward = true;
  return number;
}

void Region::compute_half_lengths() {
  for (RegionEdge& edge : edges_) {
    if (!edge.is_open) continue;
    const Bounds half = scaled(length(points_[corners_[edge.a]], points_[corners_[edge.b]]), -unit_exponent_ - 1);
    edge.half_length = floor_below(half, kLimit);
    require(edge.half_length < kLimit, "the unit of length is too small");
  }
}

// In preorder: a leaf, or an edge and what follows if it is in, then if it is out.
std::vector<Leaf> Region::read_leaves(ProofReader& proof) {
  std::vector<Leaf> leaves;
  std::vector<Decision> path;
  do {
    while (is_branch(proof.byte())) {
      path.push_back({edge_of_open_[proof.number_below(open_edges_.size())], true, {}});
      decide(path.back());
    }
    leaves.push_back(read_leaf(proof));
    while (!path.empty() && !path.back().is_in) {
      take_back(path.back());
      path.pop_back();
    }
    if (!path.empty()) {
      take_back(path.back());
      path.back().is_in = false;
      decide(path.back());
    }
  } while (!path.empty());
  return leaves;
}

void Region::decide(Decision& decision) {
  RegionEdge& chosen = edges_[decision.edge];
  require(!chosen.is_decided_in && !chosen.is_removed, "an edge is decided on twice");
  decision.removed.clear();
  if (decision.is_in) {
    chosen.is_decided_in = true;
    const auto end = [&](Corner corner) -> const Point& { return points_[corners_[corner]]; };
    for (const EdgeNumber number : edge_of_open_) {
      const RegionEdge& other = edges_[number];
      const bool is_crossed = do_cross(end(chosen.a), end(chosen.b), end(other.a), end(other.b));
      if (is_crossed && !other.is_removed) decision.removed.push_back(number);
    }
  } else {
    decision.removed.push_back(decision.edge);
  }
  for (const EdgeNumber number : decision.removed) edges_[number].is_removed = true;
}

void Region::take_back(const Decision& decision) {
  edges_[decision.edge].is_decided_in = false;
  for (const EdgeNumber number : decision.removed) edges_[number].is_removed = false;
}

Leaf Region::read_leaf(ProofReader& proof) {
  const auto read_dual = [&] {
    const std::int64_t dual = proof.signed_number();
    require(dual > -kLimit && dual < kLimit, "a dual value is out of range");
    return dual;
  };
  Leaf leaf;
  const auto add_dual = [&](std::int64_t dual) {
    require(!__builtin_add_overflow(leaf.sum, dual, &leaf.sum), "the dual values of a region are too large");
  };
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    RegionEdge& edge = edges_[edge_of_side_[i]];
    const std::int64_t dual = read_dual();
    (sides_[i].from < sides_[i].to ? edge.forward : edge.backward) = dual;
    add_dual(dual);
  }
  for (std::size_t i = 0; i < open_edges_.size(); ++i) {
    RegionEdge& edge = edges_[edge_of_open_[i]];
    const bool is_forward = open_edges_[i].a < open_edges_[i].b;
    const std::int64_t dual = read_dual();
    const std::int64_t other = edge.is_decided_in ? read_dual() : -dual;
    edge.forward = is_forward ? dual : other;
    edge.backward = is_forward ? other : dual;
    add_dual(dual + other);
  }
  leaf.worst = worst_triangle();
  return leaf;
}

// The least r(t), or 0 if none is negative.
std::int64_t Region::worst_triangle() {
  std::int64_t worst = 0;
  for (Corner a = 0; a < spokes_.size(); ++a) {
    for (const Spoke& spoke : spokes_[a]) {
      if (!edges_[spoke.edge].is_removed) edge_to_[spoke.to] = spoke.edge;
    }
    for (const Spoke& ab : spokes_[a]) {
      if (edge_to_[ab.to] == kNone) continue;
      for (const Spoke& bc : spokes_[ab.to]) {
        const EdgeNumber ac = edge_to_[bc.to];
        if (ac != kNone && !edges_[bc.edge].is_removed) look_at(edges_[ab.edge], edges_[bc.edge], edges_[ac], worst);
      }
    }
    for (const Spoke& spoke : spokes_[a]) edge_to_[spoke.to] = kNone;
  }
  return worst;
}

// Whether the three edges bound a triangle and which way round it goes is looked at only if it would matter.
void Region::look_at(const RegionEdge& ab, const RegionEdge& bc, const RegionEdge& ac, std::int64_t& worst) const {
  const std::int64_t halves = ab.half_length + bc.half_length + ac.half_length;
  const Index a = corners_[ab.a], b = corners_[ab.b], c = corners_[bc.b];
  const std::int64_t left = halves - ab.forward - bc.forward - ac.backward;
  const bool has_left = ab.has_forward && bc.has_forward && ac.has_backward;
  if (has_left && left < worst && turn(points_[a], points_[b], points_[c]) > 0 && tree_.is_empty(a, b, c)) worst = left;
  const std::int64_t right = halves - ab.backward - bc.backward - ac.forward;
  const bool has_right = ab.has_backward && bc.has_backward && ac.has_forward;
  if (has_right && right < worst && turn(points_[a], points_[b], points_[c]) < 0 && tree_.is_empty(a, c, b))
    worst = right;
}

}  // namespace mwt::verifier
