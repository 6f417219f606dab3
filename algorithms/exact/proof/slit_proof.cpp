#include "algorithms/exact/proof/slit_proof.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/exact/division/disjoint_sets.h"
#include "algorithms/exact/proof/hole_cuts.h"
#include "algorithms/exact/proof/outlined_region.h"
#include "algorithms/exact/proof/strip_proof.h"
#include "algorithms/proof/dual_leaf.h"
#include "algorithms/proof/polygon_duals.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

// Checking a proof with more dual values would take too long.
constexpr std::size_t kMaxSlitDuals = 20'000'000;

class SlitProof {
 public:
  SlitProof(DualRegion& region, const LocalRegion& local, const Deadline& deadline)
      : region_(region), local_(local), outlined_(region, local), open_(outlined_.open_edges()), deadline_(deadline) {}

  bool run(std::span<const Edge> known) {
    const std::optional<HoleCuts> cuts = fewest_cuts();
    if (!cuts || cuts->edges().size() * open_.size() > kMaxSlitDuals) return false;
    outlined_.choose_unit(total_length(local_.points, known));
    const std::int64_t target = outlined_.target_of(known);
    remaining_ = open_;
    for (const std::uint32_t cut : cuts->edges()) {
      if (!add_leaf_with(cut, target)) return give_up();
      std::erase(remaining_, open_[cut]);
    }
    add_leaf(region_, [&](Index from, Index to) { return PolygonDuals::kNever * cuts->crossing_of_ray(from, to); });
    outlined_.prove(target);
    return true;
  }

 private:
  bool give_up() {
    region_.tree.clear();
    return false;
  }

  // Of all components but the outer one.
  [[nodiscard]] std::optional<HoleCuts> fewest_cuts() const {
    DisjointSets sets(local_.points.size());
    for (const Edge& side : local_.boundary) sets.unite(side.a, side.b);
    std::map<std::size_t, std::vector<Index>> components;
    for (Index v = 0; v < local_.points.size(); ++v) components[sets.find(v)].push_back(v);
    components.erase(sets.find(0));  // points are in lexicographic order: the first is outside
    std::optional<HoleCuts> fewest;
    for (const auto& [name, hole] : components) {
      HoleCuts cuts(local_.points, hole, open_);
      if (!fewest || cuts.edges().size() < fewest->edges().size()) fewest = std::move(cuts);
    }
    return fewest;
  }

  // The region in which the cut is one of the boundary, in both directions.
  [[nodiscard]] LocalRegion with_slit(const Edge& cut) const {
    LocalRegion slit{local_.vertices, local_.points, local_.boundary, {}};
    slit.boundary.push_back(cut);
    slit.boundary.push_back({cut.b, cut.a});
    slit.sides = slit.boundary;
    for (const auto& [a, b] : remaining_) {
      const bool crosses =
          segments_cross(local_.points[a], local_.points[b], local_.points[cut.a], local_.points[cut.b]);
      if (!crosses && Edge{a, b} != cut) slit.sides.insert(slit.sides.end(), {{a, b}, {b, a}});
    }
    return slit;
  }

  bool add_leaf_with(std::uint32_t cut, std::int64_t target) {
    const LocalRegion slit = with_slit(open_[cut]);
    DualRegion part = outline_of(slit);
    part.unit_exponent = region_.unit_exponent;
    const std::int64_t own = outlined_.half(open_[cut].a, open_[cut].b);
    if (!add_strip_leaf(part, slit, target - 2 * own, deadline_)) return false;
    std::vector<std::pair<Edge, std::int64_t>> duals = values_by_side(part);
    for (auto& [side, dual] : duals) {
      if (side == open_[cut] || side == Edge{open_[cut].b, open_[cut].a}) dual += own;  // no side of the boundary here
    }
    add_branch(region_, cut);
    add_leaf(region_, [&](Index from, Index to) -> std::int64_t {
      const auto found = std::lower_bound(duals.begin(), duals.end(), Edge{from, to},
                                          [](const auto& value, const Edge& side) { return value.first < side; });
      return found != duals.end() && found->first == Edge{from, to} ? found->second : 0;
    });
    return true;
  }

  static std::vector<std::pair<Edge, std::int64_t>> values_by_side(const DualRegion& part) {
    std::vector<std::pair<Edge, std::int64_t>> values;
    const DualNode& leaf = part.tree.front();
    std::size_t first = 0, side = 0;
    for (const std::uint32_t size : part.walk_sizes) {
      for (std::size_t i = 0; i < size; ++i, ++side) {
        values.push_back({{part.places[first + i], part.places[first + (i + 1) % size]}, leaf.side_duals[side]});
      }
      first += size;
    }
    for (std::size_t i = 0; i < part.open_edges.size(); ++i) {
      const Index a = part.places[part.open_edges[i][0]], b = part.places[part.open_edges[i][1]];
      values.push_back({{a, b}, leaf.edge_duals[i]});
      values.push_back({{b, a}, leaf.other_duals[i]});
    }
    std::sort(values.begin(), values.end());
    return values;
  }

  DualRegion& region_;
  const LocalRegion& local_;
  OutlinedRegion outlined_;
  const std::vector<Edge>& open_;
  const Deadline& deadline_;
  std::vector<Edge> remaining_;  // open edges not decided to be out
};

}  // namespace

bool add_slit_duals(DualRegion& region, const LocalRegion& local, std::span<const Edge> known,
                    const Deadline& deadline) {
  return SlitProof(region, local, deadline).run(known);
}

}  // namespace mwt
