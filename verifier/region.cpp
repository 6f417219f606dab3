#include "verifier/region.h"

#include <algorithm>

#include "verifier/bounds.h"
#include "verifier/exact.h"
#include "verifier/refused.h"

namespace mwt::verifier {

namespace {

// Half lengths and dual values are smaller, so that sums of six of them fit into 64 bits.
constexpr std::int64_t kLimit = std::int64_t{1} << 60;

// The cost of a side that no triangle can have. Others lie between -kLimit and 2 kLimit: with one that is absent, three
// costs add up to more than 0, and they fit into 64 bits.
constexpr std::int64_t kAbsent = 2 * kLimit;

// One below the other: each takes memory, but few bytes in a file that is compressed.
constexpr std::size_t kMaxBases = 16;

enum class Node : std::uint8_t { leaf = 0, branch = 1, base = 2, changes = 3 };

Node read_node(ProofReader& proof) {
  const std::uint8_t tag = proof.byte();
  require(tag <= 3, "a node is of an unknown kind");
  return Node{tag};
}

void add_to(std::int64_t& sum, std::int64_t dual) {
  require(!__builtin_add_overflow(sum, dual, &sum), "the dual values of a region are too large");
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
  cost_to_.assign(corners_.size(), {kAbsent, kAbsent});
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

// In preorder: a leaf, or an edge and what follows if it is in, then if it is out, or dual values and what is below
// them.
void Region::read_leaves(ProofReader& proof, const std::function<void(const Leaf&)>& visit) {
  std::vector<Decision> path;
  do {
    Node node = read_node(proof);
    for (; node == Node::branch || node == Node::base; node = read_node(proof)) {
      if (node == Node::base) {
        add_base(path.size(), read_leaf(proof));
        continue;
      }
      path.push_back({edge_of_open_[proof.number_below(open_edges_.size())], true, {}});
      decide(path.back());
    }
    visit(node == Node::leaf ? read_leaf(proof) : read_changes(proof));
    take_back_and_go_on(path);
  } while (!path.empty());
}

// To the other case of the last decision that has been followed in one case only.
void Region::take_back_and_go_on(std::vector<Decision>& path) {
  while (!path.empty() && !path.back().is_in) {
    take_back(path.back());
    path.pop_back();
  }
  while (!bases_.empty() && bases_.back().decisions >= path.size()) {
    bases_.pop_back();
    is_loaded_ = false;
  }
  if (path.empty()) return;
  take_back(path.back());
  path.back().is_in = false;
  decide(path.back());
}

void Region::decide(Decision& decision) {
  RegionEdge& chosen = edges_[decision.edge];
  require(!chosen.is_decided_in && !chosen.is_removed, "an edge is decided on twice");
  decision.removed.clear();
  if (decision.is_in) {
    chosen.is_decided_in = true;
    const auto point = [&](Corner corner) -> const Point& { return points_[corners_[corner]]; };
    std::vector<int> side;  // of the chosen edge's line, by corner
    for (Corner c = 0; c < corners_.size(); ++c) side.push_back(turn(point(chosen.a), point(chosen.b), point(c)));
    for (const EdgeNumber number : edge_of_open_) {
      const RegionEdge& other = edges_[number];
      if (side[other.a] * side[other.b] > 0 || other.is_removed) continue;
      if (do_cross(point(chosen.a), point(chosen.b), point(other.a), point(other.b)))
        decision.removed.push_back(number);
    }
  } else {
    decision.removed.push_back(decision.edge);
  }
  for (const EdgeNumber number : decision.removed) {
    edges_[number].is_removed = true;
    update_cost(number);
  }
}

void Region::take_back(const Decision& decision) {
  edges_[decision.edge].is_decided_in = false;
  for (const EdgeNumber number : decision.removed) {
    edges_[number].is_removed = false;
    update_cost(number);
  }
}

std::int64_t Region::read_dual(ProofReader& proof) {
  const std::int64_t dual = proof.signed_number();
  require(dual > -kLimit && dual < kLimit, "a dual value is out of range");
  return dual;
}

// All dual values.
Leaf Region::read_leaf(ProofReader& proof) {
  Leaf leaf;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    RegionEdge& edge = edges_[edge_of_side_[i]];
    const std::int64_t dual = read_dual(proof);
    (sides_[i].from < sides_[i].to ? edge.forward : edge.backward) = dual;
    add_to(leaf.sum, dual);
  }
  for (std::size_t i = 0; i < open_edges_.size(); ++i) {
    RegionEdge& edge = edges_[edge_of_open_[i]];
    const bool is_forward = open_edges_[i].a < open_edges_[i].b;
    const std::int64_t dual = read_dual(proof);
    const std::int64_t other = edge.is_decided_in ? read_dual(proof) : -dual;
    edge.forward = is_forward ? dual : other;
    edge.backward = is_forward ? other : dual;
    add_to(leaf.sum, dual + other);
  }
  update_costs();
  leaf.worst = worst_triangle();
  is_loaded_ = false;
  return leaf;
}

// The dual values just read.
void Region::add_base(std::size_t decisions, const Leaf& leaf) {
  require(bases_.size() < kMaxBases, "too many dual values are to be changed");
  bases_.push_back({decisions, {}, leaf});
  for (const RegionEdge& edge : edges_) bases_.back().duals.push_back({edge.forward, edge.backward});
  is_loaded_ = true;
  if (!around_.empty()) return;
  around_.resize(corners_.size());
  for (Corner a = 0; a < spokes_.size(); ++a) {
    for (const Spoke& spoke : spokes_[a]) {
      around_[a].push_back({spoke.to, spoke.edge});
      around_[spoke.to].push_back({a, spoke.edge});
    }
  }
  is_changed_.assign(edges_.size(), false);
}

// Those that differ from the last base. What triangles without changed sides cost is known.
Leaf Region::read_changes(ProofReader& proof) {
  require(!bases_.empty(), "a leaf changes dual values where there are none");
  const Base& base = bases_.back();
  if (!is_loaded_) {
    for (EdgeNumber i = 0; i < edges_.size(); ++i) {
      edges_[i].forward = base.duals[i].forward;
      edges_[i].backward = base.duals[i].backward;
    }
    update_costs();
    is_loaded_ = true;
  }
  Leaf leaf = base.leaf;
  std::uint64_t place = 0;
  for (std::uint64_t count = proof.number(), i = 0; i < count; ++i) {
    require(place < sides_.size(), "a change is out of range");
    place += proof.number_below(sides_.size() - place);
    RegionEdge& edge = note_change(edge_of_side_[place]);
    const std::int64_t dual = read_dual(proof);
    std::int64_t& known = sides_[place].from < sides_[place].to ? edge.forward : edge.backward;
    add_to(leaf.sum, dual - known);
    known = dual;
    ++place;
  }
  place = 0;
  for (std::uint64_t count = proof.number(), i = 0; i < count; ++i) {
    require(place < open_edges_.size(), "a change is out of range");
    place += proof.number_below(open_edges_.size() - place);
    RegionEdge& edge = note_change(edge_of_open_[place]);
    const bool is_forward = open_edges_[place].a < open_edges_[place].b;
    const std::int64_t dual = read_dual(proof);
    const std::int64_t other = edge.is_decided_in ? read_dual(proof) : -dual;
    add_to(leaf.sum, dual + other - (edge.forward + edge.backward));
    edge.forward = is_forward ? dual : other;
    edge.backward = is_forward ? other : dual;
    ++place;
  }
  for (const EdgeNumber number : changed_) update_cost(number);
  leaf.worst = std::min(leaf.worst, worst_changed_triangle());
  for (const EdgeNumber number : changed_) {
    edges_[number].forward = base.duals[number].forward;
    edges_[number].backward = base.duals[number].backward;
    is_changed_[number] = false;
    update_cost(number);
  }
  changed_.clear();
  return leaf;
}

Region::RegionEdge& Region::note_change(EdgeNumber number) {
  if (!is_changed_[number]) changed_.push_back(number);
  is_changed_[number] = true;
  return edges_[number];
}

Region::SideCosts Region::costs_of(const RegionEdge& edge) {
  return {edge.has_forward && !edge.is_removed ? edge.half_length - edge.forward : kAbsent,
          edge.has_backward && !edge.is_removed ? edge.half_length - edge.backward : kAbsent};
}

void Region::update_costs() {
  for (auto& spokes : spokes_) {
    for (Spoke& spoke : spokes) spoke.cost = costs_of(edges_[spoke.edge]);
  }
}

void Region::update_cost(EdgeNumber number) {
  const RegionEdge& edge = edges_[number];
  auto& spokes = spokes_[edge.a];
  std::lower_bound(spokes.begin(), spokes.end(), edge.b, [](const Spoke& s, Corner c) { return s.to < c; })->cost =
      costs_of(edge);
}

// The least r(t), or 0 if none is negative.
std::int64_t Region::worst_triangle() {
  std::int64_t worst = 0;
  for (Corner a = 0; a < spokes_.size(); ++a) look_around(a, spokes_[a], worst);
  return worst;
}

// The least r(t) of triangles with a changed side, or 0 if none is negative. Each is found around that end of a changed
// side at which more sides changed.
std::int64_t Region::worst_changed_triangle() {
  std::vector<Corner> ends;
  for (const EdgeNumber number : changed_) {
    ends.push_back(edges_[number].a);
    ends.push_back(edges_[number].b);
  }
  std::sort(ends.begin(), ends.end());
  const auto changes_at = [&](Corner c) {
    const auto [begin, end] = std::equal_range(ends.begin(), ends.end(), c);
    return end - begin;
  };
  std::vector<Corner> centres;
  for (const EdgeNumber number : changed_) {
    const auto& [a, b] = std::pair(edges_[number].a, edges_[number].b);
    centres.push_back(changes_at(a) < changes_at(b) ? b : a);
  }
  std::sort(centres.begin(), centres.end());
  centres.erase(std::unique(centres.begin(), centres.end()), centres.end());
  std::int64_t worst = 0;
  for (const Corner centre : centres) look_around(centre, around_[centre], worst);
  return worst;
}

// At the triangles v b c, b < c, with b and c among these neighbours of v.
template <class Neighbours>
void Region::look_around(Corner v, const Neighbours& neighbours, std::int64_t& worst) {
  for (const auto& neighbour : neighbours) {
    const SideCosts cost = costs_of(edges_[neighbour.edge]);
    cost_to_[neighbour.to] = v < neighbour.to ? cost : SideCosts{cost.backward, cost.forward};
  }
  for (const auto& neighbour : neighbours) {
    const Corner b = neighbour.to;
    const SideCosts vb = cost_to_[b];
    if (vb.forward == kAbsent && vb.backward == kAbsent) continue;
    for (const Spoke& bc : spokes_[b]) {
      const SideCosts& vc = cost_to_[bc.to];
      const std::int64_t left = vb.forward + bc.cost.forward + vc.backward;
      const std::int64_t right = vb.backward + bc.cost.backward + vc.forward;
      if (left < worst) look_at(v, b, bc.to, left, worst);
      if (right < worst) look_at(v, bc.to, b, right, worst);
    }
  }
  for (const auto& neighbour : neighbours) cost_to_[neighbour.to] = {kAbsent, kAbsent};
}

// Whether this is a triangle that goes round counter-clockwise is looked at only where it matters.
void Region::look_at(Corner a, Corner b, Corner c, std::int64_t cost, std::int64_t& worst) const {
  const Index p = corners_[a], q = corners_[b], r = corners_[c];
  if (turn(points_[p], points_[q], points_[r]) > 0 && tree_.is_empty(p, q, r)) worst = cost;
}

}  // namespace mwt::verifier
