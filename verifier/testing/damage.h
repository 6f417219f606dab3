// For tests only: ways to damage a proof.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "verifier/exact.h"
#include "verifier/testing/proof.h"

namespace mwt::verifier::testing {

/// What a way to damage works on: a proof of an optimum, and the points in the proof's order.
struct Patient {
  Proof proof;
  std::vector<Point> points;

  [[nodiscard]] bool has_edge(Index a, Index b) const {
    for (const Corners& t : proof.triangles) {
      int ends = 0;
      for (const Index corner : t) ends += corner == a || corner == b ? 1 : 0;
      if (ends == 2) return true;
    }
    return false;
  }
};

/// Drawing from small ranges; the same everywhere.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  std::size_t below(std::size_t limit) { return random_() % limit; }
  template <class Value>
  Value& pick(std::vector<Value>& values) {
    return values[below(values.size())];
  }

 private:
  std::mt19937 random_;
};

enum class Harm {
  certain,   ///< what the proof says after that is false or no proof: always to be refused
  possible,  ///< the step may have been needed or not; what is proved after that must still be true
};

struct Damage {
  std::string name;
  Harm harm;
  std::function<bool(Patient&, Dice&)> apply;  ///< false if there is nothing to damage in this way
};

namespace damage {

inline EdgeStep* step_of_kind(Proof& proof, std::uint64_t kind, std::size_t min_edges) {
  for (EdgeStep& step : proof.steps) {
    if (step.tag == kind && step.edges.size() >= min_edges) return &step;
  }
  return nullptr;
}

inline EdgeEnds some_edge_of_the_optimum(Patient& patient, Dice& dice) {
  const Corners& t = dice.pick(patient.proof.triangles);
  const std::size_t i = dice.below(3);
  return {t[i], t[(i + 1) % 3]};
}

/// Any two points that the optimum does not join, with no point between them.
inline bool find_edge_outside(Patient& patient, Dice& dice, EdgeEnds& edge) {
  const auto n = patient.points.size();
  for (int tries = 0; tries < 200; ++tries) {
    const auto a = static_cast<Index>(dice.below(n)), b = static_cast<Index>(dice.below(n));
    bool is_free = a != b && !patient.has_edge(a, b);
    for (std::size_t i = 0; i < n && is_free; ++i) {
      is_free = !is_inside_segment(patient.points[i], patient.points[a], patient.points[b]);
    }
    if (!is_free) continue;
    edge = {a, b};
    return true;
  }
  return false;
}

inline std::int64_t max_dual(const RegionStep& region) {
  std::int64_t largest = 1;
  for (const TreeNode& node : region.tree) {
    for (const std::int64_t dual : node.side_duals) largest = std::max(largest, std::abs(dual));
  }
  return largest;
}

inline TreeNode* some_leaf(RegionStep& region, Dice& dice) {
  for (int tries = 0; tries < 100; ++tries) {
    TreeNode& node = dice.pick(region.tree);
    if (node.is_leaf && !node.side_duals.empty()) return &node;
  }
  return nullptr;
}

/// Every damage to a list of edges goes before all else or at its place; forged ones stand first, where most is open.
inline void insert_first(Proof& proof, const EdgeStep& step) { proof.steps.insert(proof.steps.begin(), step); }

}  // namespace damage

inline std::vector<Damage> damages_to_reductions() {
  using namespace damage;
  return {
      {"deletion dropped", Harm::possible,
       [](Patient& p, Dice& dice) {
         EdgeStep* const step = step_of_kind(p.proof, 1, 1);
         if (step != nullptr)
           step->edges.erase(step->edges.begin() + static_cast<std::ptrdiff_t>(dice.below(step->edges.size())));
         return step != nullptr;
       }},
      {"deletions exchanged", Harm::possible,
       [](Patient& p, Dice& dice) {
         EdgeStep* const step = step_of_kind(p.proof, 1, 2);
         if (step != nullptr) std::swap(dice.pick(step->edges), dice.pick(step->edges));
         return step != nullptr;
       }},
      {"all deletions dropped", Harm::possible,
       [](Patient& p, Dice&) {
         std::erase_if(p.proof.steps, [](const EdgeStep& step) { return step.tag == 1; });
         return true;
       }},
      {"edge of the optimum deleted first", Harm::certain,
       [](Patient& p, Dice& dice) {
         insert_first(p.proof, {1, {some_edge_of_the_optimum(p, dice)}, {}});
         return true;
       }},
      {"edge of the optimum deleted last", Harm::certain,
       [](Patient& p, Dice& dice) {
         p.proof.steps.push_back({1, {some_edge_of_the_optimum(p, dice)}, {}});
         return true;
       }},
      {"edge outside the optimum called certain", Harm::certain,
       [](Patient& p, Dice& dice) {
         EdgeEnds edge;
         if (!find_edge_outside(p, dice, edge)) return false;
         p.proof.steps.push_back({3, {edge}, {}});
         return true;
       }},
      {"edge outside the optimum called part of the beta-skeleton", Harm::certain,
       [](Patient& p, Dice& dice) {
         EdgeEnds edge;
         if (!find_edge_outside(p, dice, edge)) return false;
         insert_first(p.proof, {4, {edge}, {}});
         return true;
       }},
      {"edge of the optimum said to cross a certain one", Harm::certain,
       [](Patient& p, Dice& dice) {
         p.proof.steps.push_back({2, {some_edge_of_the_optimum(p, dice)}, {some_edge_of_the_optimum(p, dice)}});
         return true;
       }},
      {"edge said to cross one that is not certain", Harm::certain,
       [](Patient& p, Dice& dice) {
         EdgeEnds edge;
         if (!find_edge_outside(p, dice, edge)) return false;
         p.proof.steps.push_back({2, {some_edge_of_the_optimum(p, dice)}, {edge}});
         return true;
       }},
      {"certain edge dropped", Harm::possible,
       [](Patient& p, Dice& dice) {
         EdgeStep* const step = step_of_kind(p.proof, 3, 1);
         if (step != nullptr)
           step->edges.erase(step->edges.begin() + static_cast<std::ptrdiff_t>(dice.below(step->edges.size())));
         return step != nullptr;
       }},
      {"edge from a point to itself", Harm::certain,
       [](Patient& p, Dice& dice) {
         const auto v = static_cast<Index>(dice.below(p.points.size()));
         p.proof.steps.push_back({1 + 2 * dice.below(2), {{v, v}}, {}});
         return true;
       }},
      {"edge to a point that does not exist", Harm::certain,
       [](Patient& p, Dice& dice) {
         p.proof.steps.push_back({1 + 2 * dice.below(2), {{0, static_cast<Index>(p.points.size())}}, {}});
         return true;
       }},
      {"step of an unknown kind", Harm::certain,
       [](Patient& p, Dice& dice) {
         p.proof.steps.push_back({6 + dice.below(100), {some_edge_of_the_optimum(p, dice)}, {}});
         return true;
       }},
  };
}

inline std::vector<Damage> damages_to_regions() {
  using namespace damage;
  // Large means that it matters for the bound.
  const auto with_region = [](const std::function<bool(Patient&, RegionStep&, Dice&)>& change) {
    return [change](Patient& p, Dice& dice) {
      if (p.proof.regions.empty()) return false;
      return change(p, dice.pick(p.proof.regions), dice);
    };
  };
  return {
      {"region dropped", Harm::certain,
       [](Patient& p, Dice& dice) {
         auto& regions = p.proof.regions;
         if (regions.empty()) return false;
         regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(dice.below(regions.size())));
         return true;
       }},
      {"region given twice", Harm::certain,
       [](Patient& p, Dice& dice) {
         if (p.proof.regions.empty()) return false;
         p.proof.regions.push_back(dice.pick(p.proof.regions));
         return true;
       }},
      {"dual value of a side raised", Harm::certain, with_region([](Patient&, RegionStep& region, Dice& dice) {
         if (region.tree.size() != 1) return false;
         dice.pick(region.tree.front().side_duals) += max_dual(region) / 2 + 1;
         return true;
       })},
      {"dual value of a side lowered", Harm::possible, with_region([](Patient&, RegionStep& region, Dice& dice) {
         TreeNode* const leaf = some_leaf(region, dice);
         if (leaf == nullptr) return false;
         dice.pick(leaf->side_duals) -= max_dual(region) / 2 + 1;
         return true;
       })},
      {"dual value of a diagonal changed", Harm::possible, with_region([](Patient&, RegionStep& region, Dice& dice) {
         TreeNode* const leaf = some_leaf(region, dice);
         if (leaf == nullptr || leaf->edge_duals.empty()) return false;
         dice.pick(leaf->edge_duals).front() += (dice.below(2) == 0 ? 1 : -1) * (max_dual(region) / 2 + 1);
         return true;
       })},
      {"dual values of two diagonals exchanged", Harm::possible,
       with_region([](Patient&, RegionStep& region, Dice& dice) {
         TreeNode* const leaf = some_leaf(region, dice);
         if (leaf == nullptr || leaf->edge_duals.size() < 2) return false;
         std::swap(dice.pick(leaf->edge_duals).front(), dice.pick(leaf->edge_duals).front());
         return true;
       })},
      {"dual value beyond 2^60", Harm::certain, with_region([](Patient&, RegionStep& region, Dice& dice) {
         TreeNode* const leaf = some_leaf(region, dice);
         if (leaf == nullptr) return false;
         dice.pick(leaf->side_duals) =
             std::numeric_limits<std::int64_t>::max() - static_cast<std::int64_t>(dice.below(9));
         return true;
       })},
      {"diagonal left out", Harm::possible, with_region([](Patient&, RegionStep& region, Dice& dice) {
         if (region.open_edges.empty() || region.tree.size() != 1) return false;
         const std::size_t i = dice.below(region.open_edges.size());
         region.open_edges.erase(region.open_edges.begin() + static_cast<std::ptrdiff_t>(i));
         auto& duals = region.tree.front().edge_duals;
         duals.erase(duals.begin() + static_cast<std::ptrdiff_t>(i));
         return true;
       })},
      {"diagonal of the optimum left out", Harm::certain, with_region([](Patient& p, RegionStep& region, Dice& dice) {
         std::vector<Index> places;
         for (const auto& walk : region.walks) places.insert(places.end(), walk.begin(), walk.end());
         places.insert(places.end(), region.isolated.begin(), region.isolated.end());
         if (region.tree.size() != 1) return false;
         for (std::size_t tries = 0; tries < 20 && !region.open_edges.empty(); ++tries) {
           const std::size_t i = dice.below(region.open_edges.size());
           if (!p.has_edge(places[region.open_edges[i][0]], places[region.open_edges[i][1]])) continue;
           region.open_edges.erase(region.open_edges.begin() + static_cast<std::ptrdiff_t>(i));
           auto& duals = region.tree.front().edge_duals;
           duals.erase(duals.begin() + static_cast<std::ptrdiff_t>(i));
           return true;
         }
         return false;
       })},
      {"unit doubled", Harm::certain, with_region([](Patient&, RegionStep& region, Dice&) {
         ++region.unit_exponent;
         return true;
       })},
      {"unit halved", Harm::certain, with_region([](Patient&, RegionStep& region, Dice&) {
         --region.unit_exponent;
         return true;
       })},
      {"unit far too small", Harm::certain, with_region([](Patient&, RegionStep& region, Dice&) {
         region.unit_exponent -= 40;
         return true;
       })},
      {"walk backwards", Harm::certain, with_region([](Patient&, RegionStep& region, Dice& dice) {
         if (region.walks.empty()) return false;
         auto& walk = dice.pick(region.walks);
         std::reverse(walk.begin(), walk.end());
         return true;
       })},
      {"region outside the hull", Harm::certain,
       [](Patient& p, Dice&) {
         const std::vector<Index> hull = hull_of(p.points);
         RegionStep region{-40, {hull}, {}, {}, {TreeNode{}}};
         std::reverse(region.walks.front().begin(), region.walks.front().end());
         region.tree.front().side_duals.assign(hull.size(), 1 << 20);
         p.proof.regions.push_back(region);
         return true;
       }},
      {"place left out of a walk", Harm::certain, with_region([](Patient&, RegionStep& region, Dice&) {
         if (region.walks.empty() || region.walks.front().size() < 3 || region.tree.size() != 1) return false;
         region.walks.front().erase(region.walks.front().begin());
         region.tree.front().side_duals.erase(region.tree.front().side_duals.begin());
         return true;
       })},
      {"decision on an edge that is already decided", Harm::certain,
       with_region([](Patient&, RegionStep& region, Dice&) {
         if (region.open_edges.empty()) return false;
         region.tree.insert(region.tree.begin(), 2, TreeNode{false, 0, {}, {}});
         return true;
       })},
      {"branch with one case only", Harm::certain, with_region([](Patient&, RegionStep& region, Dice&) {
         if (region.open_edges.empty()) return false;
         region.tree.insert(region.tree.begin(), TreeNode{false, 0, {}, {}});
         return true;
       })},
  };
}

inline std::vector<Damage> damages_to_the_rest() {
  using namespace damage;
  const auto claim = [](const std::string& name, double lower, double upper) {
    return Damage{name, Harm::certain, [lower, upper](Patient& p, Dice&) {
                    p.proof.claimed_lower *= lower;
                    p.proof.claimed_upper *= upper;
                    return true;
                  }};
  };
  return {
      claim("claim: lower end raised", 1 + 1e-9, 1 + 2e-9),
      claim("claim: upper end lowered", 1 - 2e-9, 1 - 1e-9),
      claim("claim: both ends raised", 1.5, 1.5),
      claim("claim: ends exchanged", 1.1, 0.9),
      claim("claim: negative", -1, 1),
      claim("claim: no number", std::numeric_limits<double>::quiet_NaN(), 1),
      claim("claim: no number above", 1, std::numeric_limits<double>::quiet_NaN()),
      {"hash changed", Harm::certain,
       [](Patient& p, Dice& dice) {
         dice.pick(p.proof.hash) ^= static_cast<std::uint8_t>(1U << dice.below(8));
         return true;
       }},
      {"number of points changed", Harm::certain,
       [](Patient& p, Dice& dice) {
         p.proof.point_count += dice.below(2) == 0 ? std::uint64_t{1} : ~std::uint64_t{0};
         return true;
       }},
      {"point twice in the order", Harm::certain,
       [](Patient& p, Dice& dice) {
         const std::size_t i = dice.below(p.proof.order.size() - 1);
         p.proof.order[i] = p.proof.order[i + 1];
         return true;
       }},
      {"order shifted", Harm::certain,
       [](Patient& p, Dice&) {
         std::rotate(p.proof.order.begin(), p.proof.order.begin() + 1, p.proof.order.end());
         return true;
       }},
      {"triangle dropped", Harm::certain,
       [](Patient& p, Dice&) {
         p.proof.triangles.pop_back();
         return true;
       }},
      {"triangle twice", Harm::certain,
       [](Patient& p, Dice& dice) {
         p.proof.triangles.push_back(dice.pick(p.proof.triangles));
         return true;
       }},
      {"triangle replaced by another", Harm::certain,
       [](Patient& p, Dice& dice) {
         if (p.proof.triangles.size() < 2) return false;
         const std::size_t i = dice.below(p.proof.triangles.size() - 1);
         p.proof.triangles[i] = p.proof.triangles[i + 1];
         return true;
       }},
      {"triangle turned over", Harm::certain,
       [](Patient& p, Dice& dice) {
         Corners& t = dice.pick(p.proof.triangles);
         std::swap(t[0], t[1]);
         return true;
       }},
      {"corner of a triangle replaced", Harm::certain,
       [](Patient& p, Dice& dice) {
         Index& corner = dice.pick(p.proof.triangles)[dice.below(3)];
         const auto other = static_cast<Index>(dice.below(p.points.size()));
         if (other == corner) return false;
         corner = other;
         return true;
       }},
  };
}

/// All of them.
inline std::vector<Damage> damages() {
  std::vector<Damage> all = damages_to_reductions();
  for (auto* const more : {damages_to_regions, damages_to_the_rest}) {
    for (Damage& one : more()) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace mwt::verifier::testing
