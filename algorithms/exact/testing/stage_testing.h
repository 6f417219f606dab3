// For tests only: instances of all families, and the front stages of the exact solver one after the other.
#pragma once

#include <tbb/parallel_for.h>

#include <set>
#include <string>
#include <vector>

#include "algorithms/exact/candidates/certain_edges.h"
#include "algorithms/exact/candidates/diamond_candidates.h"
#include "algorithms/exact/candidates/kd_order.h"
#include "algorithms/exact/candidates/lmt_skeleton.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/convex_hull.h"
#include "geometry/point_set.h"
#include "geometry/triangulation.h"

namespace mwt::stage_testing {

struct NamedInstance {
  std::string name;
  std::vector<Point> points;
};

/// Appends an instance of the family, unless it has none of n points or these are no point set (all collinear).
inline void append(std::vector<NamedInstance>& instances, const std::string& family, Index n, std::uint64_t seed = 1,
                   const std::map<std::string, std::string>& parameters = {}) {
  const std::string name = family + " n=" + std::to_string(n) + " seed=" + std::to_string(seed);
  try {
    instances.push_back({name, make_point_set(generate(family, n, seed, parameters), name).points});
  } catch (const InputError&) {
  }
}

/// Every family at these sizes, where it has them.
inline std::vector<NamedInstance> instances_of_all_families(const std::vector<Index>& sizes, std::uint64_t seeds = 1) {
  std::vector<NamedInstance> instances;
  for (const GeneratorInfo& family : generators()) {
    for (const Index n : sizes) {
      for (std::uint64_t seed = 1; seed <= (family.seeded ? seeds : 1); ++seed) {
        append(instances, family.name, n, seed);
      }
    }
  }
  return instances;
}

inline HullEdges hull_of(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  HullEdges edges;
  edges.next.assign(points.size(), kNoIndex);
  for (std::size_t i = 0; i < hull.size(); ++i) edges.next[hull[i]] = hull[(i + 1) % hull.size()];
  return edges;
}

/// All that the diamond test finds, by blocks.
struct DiamondCandidates {
  std::vector<std::vector<CandidatePair>> inner;
  std::vector<std::vector<CandidatePair>> outer;
};

inline DiamondCandidates diamond_candidates(const KdOrder& order) {
  DiamondTest test(order);
  DiamondCandidates candidates;
  candidates.outer = test.find_outer(Context());
  candidates.inner.resize(test.blocks().count());
  tbb::parallel_for(std::uint32_t{0}, test.blocks().count(),
                    [&](std::uint32_t block) { test.take_inner(block, Context(), candidates.inner[block]); });
  return candidates;
}

inline LmtSkeleton lmt_skeleton(const KdOrder& order) {
  DiamondTest test(order);
  return find_lmt_skeleton(order, hull_of(order.points), test, Context());
}

inline CandidateGraph candidate_graph(const KdOrder& order) {
  return mark_certain_edges(order.points, lmt_skeleton(order).stars, Context{});
}

inline std::set<Edge> edges_in(const DiamondCandidates& candidates) {
  std::set<Edge> edges;
  for (const auto* lists : {&candidates.inner, &candidates.outer}) {
    for (const auto& pairs : *lists) {
      for (const auto& [p, q] : pairs) edges.insert(make_edge(p, q));
    }
  }
  return edges;
}

inline std::set<Edge> edges_in(const StarTable& table) {
  std::set<Edge> edges;
  for (Index v = 0; v < table.stars.size(); ++v) {
    const Star& star = table.stars[v];
    for (std::uint32_t i = 0; i < star.count; ++i) edges.insert(make_edge(v, star.target()[i]));
  }
  return edges;
}

/// The triangulation's edges by the order's indices instead of the instance's.
inline std::vector<Edge> reordered_edges(const KdOrder& order, const Triangulation& triangulation) {
  std::vector<Index> place(order.original.size());
  for (Index i = 0; i < place.size(); ++i) place[order.original[i]] = i;
  std::vector<Edge> edges = edges_of(triangulation);
  for (Edge& edge : edges) edge = make_edge(place[edge.a], place[edge.b]);
  return edges;
}

}  // namespace mwt::stage_testing
