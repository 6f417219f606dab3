// For tests only: regions with a chosen number of holes, and what dual values prove of them by the definition.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/exact/holes/region_solver.h"
#include "algorithms/exact/holes/region_triangles.h"
#include "algorithms/exact/testing/hole_instances.h"
#include "algorithms/proof/half_length.h"
#include "algorithms/proof_trace.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt::region_instances {

/// A ring around holes that are points or small triangles, and an optimum of it.
struct Instance {
  LocalRegion local;
  std::size_t components = 0;
  std::vector<Edge> optimum;  ///< diagonals, a < b, ascending
  double length = 0;          ///< of these
};

inline Instance make(std::size_t ring, std::size_t holes, double jitter, std::uint64_t seed) {
  hole_instances::Random random(seed);
  std::vector<Point> points;
  std::vector<Edge> boundary;
  for (std::size_t i = 0; i < ring; ++i) {  // convex, so that no pair of points is outside
    const double angle =
        6.2831853 * (static_cast<double>(i) + jitter * hole_instances::uniform(random)) / static_cast<double>(ring);
    points.push_back({std::cos(angle), std::sin(angle)});
  }
  for (Index i = 0; i < ring; ++i) boundary.push_back({i, static_cast<Index>((i + 1) % ring)});
  for (std::size_t hole = 0; hole < holes; ++hole) {
    const double angle = 6.2831853 * static_cast<double>(hole) / static_cast<double>(holes) + .3;
    const double radius =
        holes == 1 ? .1 * hole_instances::uniform(random) : .35 + .2 * hole_instances::uniform(random);
    const Point centre{radius * std::cos(angle), radius * std::sin(angle)};
    const auto first = static_cast<Index>(points.size());
    if (random() % 2 == 0) {
      points.push_back(centre);
      continue;
    }
    hole_instances::append_ring(points, centre, .08, 3, 1e-2, random);
    for (Index i = 0; i < 3; ++i) boundary.push_back({first + (i + 1) % 3, first + i});  // the hole on the right
  }
  FaceRegion region;
  for (Index v = 0; v < points.size(); ++v) region.vertices.push_back(v);
  region.boundary = boundary;
  region.components = holes + 1;
  std::set<Edge> sides;
  for (const Edge& side : boundary) sides.insert(make_edge(side.a, side.b));
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) {
      const bool crosses = std::any_of(sides.begin(), sides.end(), [&](const Edge& side) {
        return segments_cross(points[a], points[b], points[side.a], points[side.b]);
      });
      if (!crosses && !sides.contains({a, b})) region.candidates.push_back({a, b});
    }
  }
  Instance result;
  result.local = make_local(points, region);
  result.components = region.components;
  const RegionSolution solution = solve_region(points, region, {});
  result.length = solution.diagonals.enclosure().upper;
  std::vector<Index> place(points.size());
  for (Index i = 0; i < points.size(); ++i) place[result.local.vertices[i]] = i;
  for (const Triangle& t : solution.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge = make_edge(t[i], t[(i + 1) % 3]);
      if (!sides.contains(edge)) result.optimum.push_back(make_edge(place[edge.a], place[edge.b]));
    }
  }
  std::sort(result.optimum.begin(), result.optimum.end());
  result.optimum.erase(std::unique(result.optimum.begin(), result.optimum.end()), result.optimum.end());
  return result;
}

/// Rings of 5 to 16 points around 1 to `max_holes` holes, half of them nearly regular.
inline std::vector<Instance> some(std::size_t count, std::size_t max_holes) {
  std::vector<Instance> result;
  for (std::size_t i = 0; i < count; ++i)
    result.push_back(make(5 + i % 12, 1 + i % max_holes, i % 4 < 2 ? 1e-6 : .8, i + 1));
  return result;
}

/// What a region's tree proves, by the definition in verifier/README.md, in units: for each leaf the sum of its dual
/// values and, for every triangle of a triangulation, the worst reduced cost of any.
class NaiveEvaluation {
 public:
  NaiveEvaluation(const LocalRegion& local, const DualRegion& region, std::size_t triangle_count)
      : local_(local), region_(region), triangle_count_(triangle_count) {
    triangles_ = *region_triangles(local.points, local.sides, std::numeric_limits<std::size_t>::max(), {});
    for (const auto& [from, to] : region.open_edges) open_.push_back(make_edge(region.places[from], region.places[to]));
  }

  double length() {
    std::size_t node = 0;
    const double units = evaluate(node);
    return std::ldexp(units, region_.unit_exponent);
  }

 private:
  double evaluate(std::size_t& node) {
    const DualNode& here = region_.tree.at(node++);
    switch (here.kind) {
      case DualNode::Kind::branch: {
        const Edge edge = open_[here.edge];
        in_.insert(edge);
        const double if_in = evaluate(node);
        in_.erase(edge);
        out_.insert(edge);
        const double if_out = evaluate(node);
        out_.erase(edge);
        return std::min(if_in, if_out);
      }
      case DualNode::Kind::base: base_ = &here; return evaluate(node);
      case DualNode::Kind::leaf: return proved_by(here);
      case DualNode::Kind::changed_leaf: break;
    }
    DualNode whole = *base_;
    if (whole.other_duals.empty()) {
      for (const std::int64_t dual : whole.edge_duals) whole.other_duals.push_back(-dual);
    }
    for (std::size_t i = 0; i < here.changed_sides.size(); ++i)
      whole.side_duals[here.changed_sides[i]] = here.side_duals[i];
    for (std::size_t i = 0; i < here.changed_edges.size(); ++i) {
      whole.edge_duals[here.changed_edges[i]] = here.edge_duals[i];
      whole.other_duals[here.changed_edges[i]] = here.other_duals.empty() ? -here.edge_duals[i] : here.other_duals[i];
    }
    return proved_by(whole);
  }

  double proved_by(const DualNode& leaf) {
    std::map<Edge, std::int64_t> dual, half;
    std::int64_t sum = 0;
    std::size_t first = 0, side = 0;
    for (const std::uint32_t size : region_.walk_sizes) {
      for (std::size_t i = 0; i < size; ++i, ++side) {
        const Edge edge{region_.places[first + i], region_.places[first + (i + 1) % size]};
        dual[edge] = leaf.side_duals[side];
        half[edge] = 0;
        sum += leaf.side_duals[side];
      }
      first += size;
    }
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const Edge edge{region_.places[region_.open_edges[i][0]], region_.places[region_.open_edges[i][1]]};
      const Edge back{edge.b, edge.a};
      if (is_removed(open_[i])) continue;
      dual[edge] = leaf.edge_duals[i];
      dual[back] = in_.contains(open_[i]) ? leaf.other_duals[i] : -leaf.edge_duals[i];
      if (in_.contains(open_[i])) sum += dual[edge] + dual[back];
      half[edge] = half[back] = std::max<std::int64_t>(
          0, half_length(mwt::length(local_.points[edge.a], local_.points[edge.b]), region_.unit_exponent));
    }
    std::int64_t worst = 0;
    for (const auto& [a, b, c] : triangles_) {
      std::int64_t cost = 0;
      bool is_possible = true;
      for (const Edge& edge : {Edge{a, b}, Edge{b, c}, Edge{c, a}}) {
        const auto found = dual.find(edge);
        is_possible = is_possible && found != dual.end();
        if (is_possible) cost += half[edge] - found->second;
      }
      if (is_possible) worst = std::min(worst, cost);
    }
    return static_cast<double>(sum) + static_cast<double>(worst) * static_cast<double>(triangle_count_);
  }

  [[nodiscard]] bool is_removed(const Edge& edge) const {
    const auto& points = local_.points;
    return out_.contains(edge) || std::any_of(in_.begin(), in_.end(), [&](const Edge& decided) {
             return decided != edge &&
                    segments_cross(points[edge.a], points[edge.b], points[decided.a], points[decided.b]);
           });
  }

  const LocalRegion& local_;
  const DualRegion& region_;
  std::size_t triangle_count_;
  std::vector<Triangle> triangles_;
  std::vector<Edge> open_;
  std::set<Edge> in_, out_;
  const DualNode* base_ = nullptr;
};

}  // namespace mwt::region_instances
