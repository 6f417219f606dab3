#include "algorithms/exact/proof/strip_proof.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/exact/holes/strip.h"
#include "algorithms/exact/proof/hole_cuts.h"
#include "algorithms/exact/proof/outlined_region.h"
#include "algorithms/proof/dual_leaf.h"
#include "algorithms/proof/polygon_duals.h"

namespace mwt {

namespace {

// Checking a proof with more dual values would take too long.
constexpr std::size_t kMaxDuals = 20'000'000;

// What the region costs at least if nothing fits: more than any optimum.
constexpr std::int64_t kNeverFits = PolygonDuals::kNever;

class StripProof {
 public:
  StripProof(DualRegion& region, const LocalRegion& local, const Deadline& deadline)
      : region_(region), local_(local), outlined_(region, local), open_(outlined_.open_edges()), deadline_(deadline) {}

  bool run(std::span<const Edge> known) {
    if (!make()) return false;
    choose_unit(known);
    if (!lay_out()) return false;
    if (!known.empty() && add_potentials_leaf(outlined_.target_of(known))) return true;
    return add_tree();
  }

  bool run_leaf(std::int64_t target) { return make() && lay_out() && add_potentials_leaf(target); }

 private:
  using Place = Strip::Place;
  using OpenEdge = std::uint32_t;  // position in open_
  using NodeNumber = std::uint32_t;
  static constexpr Place kRepeated = -1;

  struct DirectedDual {
    Edge side;  // from a to b; the other side has the negative value
    std::int64_t dual;
  };

  // An edge between two places of one boundary, and what lies behind it.
  struct Chord {
    Place to;
    std::int64_t cost;  // of what it cuts off, and once more its half; 0 for a side of the boundary
    std::int64_t dual;  // of its side towards what it cuts off
  };
  using Chords = std::vector<std::vector<Chord>>;  // by place of one period, ascending
  // An edge across, from an outer place of the first period.
  struct Node {
    Place outer, inner;
    OpenEdge edge;
    std::int64_t half;
  };
  // An edge across, or its copy a period later.
  struct RowEntry {
    Place inner;
    NodeNumber node;
  };
  // At an edge across, or its copy a period later: what a cheapest path from the cut at hand costs.
  struct Arrival {
    Place inner;
    NodeNumber node;
    std::int64_t half;
    std::int64_t cost;  // kNeverFits: there is no path
  };

  bool make() {
    auto strip = make_strip(local_.points, outlined_.as_face(2));
    if (!strip) return false;
    strip_ = *std::move(strip);
    cuts_.emplace(local_.points, strip_.inner.vertex, open_);
    return true;
  }

  bool lay_out() {
    if (!add_chain(strip_.outer, false, outer_) || !add_chain(strip_.inner, true, inner_)) return false;
    list_nodes();
    list_chord_duals();
    return true;
  }

  bool add_tree() {
    if (cuts_->edges().size() * nodes_.size() > kMaxDuals) return false;
    is_out_.assign(open_.size(), false);
    add_base();
    std::int64_t least = kNeverFits;
    for (const OpenEdge cut : cuts_->edges()) {
      if (has_passed(deadline_)) return give_up();
      add_branch(region_, cut);
      least = std::min(least, add_leaf_of(cut));
      is_out_[cut] = true;
    }
    add_impossible_leaf();
    outlined_.prove(least);
    return true;
  }

  bool give_up() {
    region_.tree.clear();
    return false;
  }

  // If nothing is known, so that no optimum has more than 57 bits.
  void choose_unit(std::span<const Edge> known) {
    if (!known.empty()) return outlined_.choose_unit(total_length(local_.points, known));
    const int diagonal_bits = std::ilogb(static_cast<double>(3 * local_.points.size())) + 1;
    const int bits = std::min(50, OutlinedRegion::kBits - diagonal_bits);
    region_.unit_exponent = std::ilogb(outlined_.longest_edge()) + 1 - bits;
  }

  [[nodiscard]] std::int64_t half(Index a, Index b) const { return outlined_.half(a, b); }

  // The boundary repeated twice as a polygon: all chords lie in it. `is_reversed`: its order is that of falling places.
  bool add_chain(const Strip::Chain& chain, bool is_reversed, Chords& chords) {
    const Place period = chain.period();
    chords.resize(static_cast<std::size_t>(period));
    if (period == 0) return true;
    std::vector<Index> corners;
    for (Place p = 0; p <= 2 * period; ++p) corners.push_back(chain.vertex_at(is_reversed ? -p : p));
    struct Diagonal {
      std::array<std::uint32_t, 2> ends;
      Place from, to;
    };
    std::vector<Diagonal> all;
    for (Place from = 0; from < period; ++from) {
      for (const Place to : chain.chord[static_cast<std::size_t>(from)]) {
        if (to == from + 1) {
          chords[static_cast<std::size_t>(from)].push_back({to, 0, 0});
          continue;
        }
        const Place first = is_reversed ? (2 * period - to) % period : from, last = first + to - from;
        const auto begin = static_cast<std::uint32_t>(first), end = static_cast<std::uint32_t>(last);
        all.push_back({{begin, end}, from, to});
        const auto shift = static_cast<std::uint32_t>(period);
        if (end + shift < corners.size()) all.push_back({{begin + shift, end + shift}, kRepeated, to});
      }
    }
    std::sort(all.begin(), all.end(), [](const auto& d, const auto& e) { return d.ends < e.ends; });
    std::vector<std::array<std::uint32_t, 2>> diagonals;
    for (const Diagonal& diagonal : all) diagonals.push_back(diagonal.ends);
    const auto solved = PolygonDuals().solve(local_.points, corners, diagonals, deadline_, region_.unit_exponent);
    if (!solved) return false;
    const DualNode& leaf = solved->tree.front();
    for (std::size_t i = 0; i < all.size(); ++i) {
      const auto& [ends, from, to] = all[i];
      if (from == kRepeated) continue;
      const std::int64_t dual = -leaf.edge_duals[i];
      const std::int64_t cost = std::min(kNeverFits, dual + half(corners[ends[0]], corners[ends[1]]));
      chords[static_cast<std::size_t>(from)].push_back({to, cost, dual});
    }
    for (auto& row : chords)
      std::sort(row.begin(), row.end(), [](const Chord& c, const Chord& d) { return c.to < d.to; });
    return true;
  }

  void list_nodes() {
    std::vector<std::pair<Edge, OpenEdge>> numbers;
    for (OpenEdge e = 0; e < open_.size(); ++e) numbers.emplace_back(make_edge(open_[e].a, open_[e].b), e);
    std::sort(numbers.begin(), numbers.end());
    node_of_.assign(open_.size(), kNoIndex);
    for (Place a = 0; a < strip_.outer.period(); ++a) {
      first_.push_back(static_cast<NodeNumber>(nodes_.size()));
      for (const Place s : strip_.across[static_cast<std::size_t>(a)]) {
        const Index v = strip_.outer.vertex_at(a), w = strip_.inner.vertex_at(s);
        const OpenEdge edge = std::lower_bound(numbers.begin(), numbers.end(), std::pair(make_edge(v, w), 0U))->second;
        node_of_[edge] = static_cast<NodeNumber>(nodes_.size());
        nodes_.push_back({a, s, edge, half(v, w)});
        across_.push_back(edge);
      }
    }
    first_.push_back(static_cast<NodeNumber>(nodes_.size()));
    std::sort(across_.begin(), across_.end());
    cost_of_.resize(open_.size());
  }

  [[nodiscard]] Index inner_vertex(NodeNumber node) const { return strip_.inner.vertex_at(nodes_[node].inner); }

  void list_chord_duals() {
    for (const bool is_outer : {true, false}) {
      const Strip::Chain& chain = is_outer ? strip_.outer : strip_.inner;
      for (Place from = 0; from < chain.period(); ++from) {
        for (const Chord& chord : (is_outer ? outer_ : inner_)[static_cast<std::size_t>(from)]) {
          if (chord.to == from + 1) continue;
          const std::int64_t dual = is_outer ? -chord.dual : chord.dual;
          chord_duals_.push_back({{chain.vertex_at(from), chain.vertex_at(chord.to)}, dual});
        }
      }
    }
    std::sort(chord_duals_.begin(), chord_duals_.end(), [](const auto& d, const auto& e) { return d.side < e.side; });
  }

  // Of an edge that is no chord, 0.
  [[nodiscard]] std::int64_t chord_dual(Index from, Index to) const {
    const auto find = [&](const Edge& side) -> std::optional<std::int64_t> {
      const auto found = std::lower_bound(chord_duals_.begin(), chord_duals_.end(), side,
                                          [](const DirectedDual& d, const Edge& s) { return d.side < s; });
      return found != chord_duals_.end() && found->side == side ? std::optional(found->dual) : std::nullopt;
    };
    if (const auto dual = find({from, to})) return *dual;
    const auto other = find({to, from});
    return other ? -*other : 0;
  }

  void add_base() {
    add_leaf(region_, [&](Index from, Index to) { return chord_dual(from, to); });
    DualNode& base = region_.tree.back();
    base.kind = DualNode::Kind::base;
    base.other_duals.clear();
  }

  // One leaf that proves `target` units, if there is one.
  bool add_potentials_leaf(std::int64_t target) {
    const std::optional<std::vector<std::int64_t>> potential = potentials(target);
    if (!potential) return false;
    std::vector<DirectedDual> across;
    for (NodeNumber n = 0; n < nodes_.size(); ++n)
      across.push_back(
          {{strip_.outer.vertex_at(nodes_[n].outer), strip_.inner.vertex_at(nodes_[n].inner)}, (*potential)[n]});
    std::sort(across.begin(), across.end(), [](const auto& d, const auto& e) { return d.side < e.side; });
    const auto find = [&](Index from, Index to) -> std::int64_t {
      const auto found = std::lower_bound(across.begin(), across.end(), Edge{from, to},
                                          [](const DirectedDual& d, const Edge& s) { return d.side < s; });
      return found != across.end() && found->side == Edge{from, to} ? found->dual : 0;
    };
    add_leaf(region_, [&](Index from, Index to) {
      return chord_dual(from, to) + find(from, to) - find(to, from) + target * cuts_->crossing_of_ray(from, to);
    });
    outlined_.prove(target);
    return true;
  }

  // By node: so that no arc costs less than nothing if those that contain the point beyond the hole cost less by
  // `target`. Bellman and Ford, all arcs in the order of the outer boundary, round after round.
  [[nodiscard]] std::optional<std::vector<std::int64_t>> potentials(std::int64_t target) {
    constexpr int kMaxSearchRounds = 100;
    constexpr std::int64_t kTooLow = -(std::int64_t{1} << 59);
    const Place period = strip_.outer.period();
    std::vector<std::vector<RowEntry>> rows(2 * static_cast<std::size_t>(period));
    for (Place i = 0; i < 2 * period; ++i) {
      const Place place = i % period, shift = i < period ? 0 : strip_.inner.period();
      for (NodeNumber n = first_[static_cast<std::size_t>(place)]; n < first_[static_cast<std::size_t>(place) + 1]; ++n)
        rows[static_cast<std::size_t>(i)].push_back({nodes_[n].inner + shift, n});
    }
    std::vector<std::int64_t> potential(nodes_.size(), 0);
    bool is_changed = true, is_too_low = false;
    const auto offer = [&](NodeNumber from, const Chord& chord, NodeNumber to, Index apex, const Edge& opposite) {
      if (chord.cost >= kNeverFits) return;
      const bool is_beyond = apex == cuts_->from() && cuts_->crossing_of_ray(opposite.a, opposite.b) > 0;
      const std::int64_t cost = nodes_[from].half + chord.cost + nodes_[to].half - (is_beyond ? target : 0);
      if (potential[from] + cost >= potential[to]) return;
      potential[to] = potential[from] + cost;
      is_changed = true;
      is_too_low = is_too_low || potential[to] < kTooLow;
    };
    for (int round = 0; is_changed; ++round) {
      if (round == kMaxSearchRounds || is_too_low || has_passed(deadline_)) return {};
      is_changed = false;
      for (Place i = 0; i < period; ++i) {
        const auto& row = rows[static_cast<std::size_t>(i)];
        follow_inner_chords(row, [&](const RowEntry& from, const Chord& chord, const RowEntry& to) {
          const Index outer = strip_.outer.vertex_at(i), s = inner_vertex(from.node), t = inner_vertex(to.node);
          // At one of its two inner corners the triangle may contain the point.
          offer(from.node, chord, to.node, s == cuts_->from() ? s : t,
                s == cuts_->from() ? Edge{outer, t} : Edge{s, outer});
        });
        for (const Chord& chord : outer_[static_cast<std::size_t>(i)]) {
          if (chord.to > i + period) break;
          follow_outer_chord(row, rows[static_cast<std::size_t>(chord.to)],
                             [&](const RowEntry& from, const RowEntry& to) {
                               const Edge opposite{strip_.outer.vertex_at(i), strip_.outer.vertex_at(chord.to)};
                               offer(from.node, chord, to.node, inner_vertex(from.node), opposite);
                             });
        }
      }
    }
    return potential;
  }

  // Paths of triangles from the cut once around the hole to its copy; between the two lie all edges across that do not
  // cross it. Returns what they cost at least.
  std::int64_t add_leaf_of(OpenEdge cut) {
    const Node& start = nodes_[node_of_[cut]];
    const Place period = strip_.outer.period();
    lay_out_rows(start);
    rows_.front().front().cost = 0;
    for (Place i = 0; i < period; ++i) {
      const Place place = (start.outer + i) % period;
      follow_inner_chords(rows_[static_cast<std::size_t>(i)], offer);
      for (const Chord& chord : outer_[static_cast<std::size_t>(place)]) {
        const Place reached = i + chord.to - place;
        if (reached > period) break;
        follow_outer_chord(rows_[static_cast<std::size_t>(i)], rows_[static_cast<std::size_t>(reached)],
                           [&](const Arrival& from, Arrival& to) { offer(from, chord, to); });
      }
    }
    follow_inner_chords(rows_.back(), offer);
    add_changes(cut);
    return rows_.back().back().cost;
  }

  // By outer place, from the cut's to that of its copy; ascending.
  void lay_out_rows(const Node& start) {
    const Place outer = strip_.outer.period(), inner = strip_.inner.period();
    rows_.resize(static_cast<std::size_t>(outer) + 1);
    for (Place i = 0; i <= outer; ++i) {
      auto& row = rows_[static_cast<std::size_t>(i)];
      row.clear();
      const Place place = (start.outer + i) % outer, shift = start.outer + i < outer ? 0 : inner;
      for (NodeNumber n = first_[static_cast<std::size_t>(place)]; n < first_[static_cast<std::size_t>(place) + 1];
           ++n) {
        const Node& node = nodes_[n];
        const bool is_between = node.inner + shift >= start.inner && node.inner + shift <= start.inner + inner;
        if (is_between && !is_out_[node.edge]) row.push_back({node.inner + shift, n, node.half, kNeverFits});
      }
    }
  }

  static void offer(const Arrival& from, const Chord& chord, Arrival& to) {
    to.cost = std::min(to.cost, from.cost + from.half + chord.cost + to.half);
  }

  // Calls visit(from, chord, to) for the triangles at one outer place, with entries of its row.
  template <class Row, class Visit>
  void follow_inner_chords(Row& row, const Visit& visit) const {
    const Place period = strip_.inner.period();
    if (period == 0) return;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Place place = ((row[i].inner % period) + period) % period, shift = row[i].inner - place;
      std::size_t reached = i + 1;
      for (const Chord& chord : inner_[static_cast<std::size_t>(place)]) {
        while (reached < row.size() && row[reached].inner < chord.to + shift) ++reached;
        if (reached == row.size()) break;
        if (row[reached].inner == chord.to + shift) visit(row[i], chord, row[reached]);
      }
    }
  }

  // Calls visit(from, to) for the triangles over a chord of the outer boundary, between the edges at its ends.
  template <class Row, class Visit>
  static void follow_outer_chord(const Row& row, Row& next, const Visit& visit) {
    auto reached = next.begin();
    for (const auto& entry : row) {
      while (reached != next.end() && reached->inner < entry.inner) ++reached;
      if (reached == next.end()) return;
      if (reached->inner == entry.inner) visit(entry, *reached);
    }
  }

  // On the side from outer to inner end the cost, on the other the negative; on the cut's two sides the whole and 0.
  void add_changes(OpenEdge cut) {
    for (const auto& row : rows_) {
      for (const Arrival& arrival : row) cost_of_[nodes_[arrival.node].edge] = arrival.cost;
    }
    DualNode& leaf = region_.tree.emplace_back();
    leaf.kind = DualNode::Kind::changed_leaf;
    for (const OpenEdge e : across_) {
      if (!cost_of_[e]) continue;
      const bool is_from_outer = open_[e].a == strip_.outer.vertex_at(nodes_[node_of_[e]].outer);
      const std::int64_t cost = *std::exchange(cost_of_[e], std::nullopt);
      leaf.changed_edges.push_back(e);
      leaf.edge_duals.push_back(is_from_outer ? cost : e == cut ? 0 : -cost);
      leaf.other_duals.push_back(!is_from_outer ? cost : e == cut ? 0 : -cost);
    }
  }

  // All cuts are out: around every triangle, the sides cross the ray from beyond the hole as often one way as the
  // other.
  void add_impossible_leaf() {
    const DualNode base = region_.tree.front();
    DualNode& leaf = region_.tree.emplace_back();
    leaf.kind = DualNode::Kind::changed_leaf;
    std::uint32_t side = 0, first = 0;
    for (const std::uint32_t size : region_.walk_sizes) {
      for (std::uint32_t i = 0; i < size; ++i, ++side) {
        const std::int64_t change = crossing_of_ray(region_.places[first + i], region_.places[first + (i + 1) % size]);
        if (change == 0) continue;
        leaf.changed_sides.push_back(side);
        leaf.side_duals.push_back(base.side_duals[side] + change);
      }
      first += size;
    }
    for (OpenEdge e = 0; e < open_.size(); ++e) {
      const std::int64_t change = crossing_of_ray(open_[e].a, open_[e].b);
      if (change == 0) continue;
      leaf.changed_edges.push_back(e);
      leaf.edge_duals.push_back(base.edge_duals[e] + change);
    }
  }

  [[nodiscard]] std::int64_t crossing_of_ray(Index from, Index to) const {
    return kNeverFits * cuts_->crossing_of_ray(from, to);
  }

  DualRegion& region_;
  const LocalRegion& local_;
  OutlinedRegion outlined_;  // by local numbers, as everything here
  const std::vector<Edge>& open_;
  const Deadline& deadline_;
  Strip strip_;
  std::optional<HoleCuts> cuts_;
  std::vector<bool> is_out_;
  Chords outer_, inner_;
  std::vector<Node> nodes_;                           // by outer place
  std::vector<DirectedDual> chord_duals_;             // ascending by side
  std::vector<NodeNumber> first_;                     // of each outer place, and the end
  std::vector<NodeNumber> node_of_;                   // by open edge
  std::vector<OpenEdge> across_;                      // ascending
  std::vector<std::vector<Arrival>> rows_;            // of the cut at hand
  std::vector<std::optional<std::int64_t>> cost_of_;  // by open edge
};

}  // namespace

bool add_strip_duals(DualRegion& region, const LocalRegion& local, std::span<const Edge> known,
                     const Deadline& deadline) {
  return StripProof(region, local, deadline).run(known);
}

bool add_strip_leaf(DualRegion& region, const LocalRegion& local, std::int64_t target, const Deadline& deadline) {
  return StripProof(region, local, deadline).run_leaf(target);
}

}  // namespace mwt
