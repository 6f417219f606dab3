#include "algorithms/quadtree/quadtree.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "algorithms/quadtree/leaf_triangulation.h"
#include "algorithms/step_trace.h"
#include "base/error.h"
#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/mesh/constraint_insertion.h"
#include "geometry/mesh/planar_mesh.h"
#include "geometry/numbers/scaling.h"
#include "geometry/quadtree.h"

namespace mwt {

namespace {

std::vector<Point> selected(Points points, std::span<const Index> chosen) {
  std::vector<Point> result;
  result.reserve(chosen.size());
  for (const Index i : chosen) result.push_back(points[i]);
  return result;
}

// The edges between neighbours on a line.
std::vector<Edge> chain_edges(Points points) {
  const std::vector<Index> order = lexicographic_order(points);
  std::vector<Edge> edges;
  for (std::size_t i = 1; i < order.size(); ++i) edges.push_back(make_edge(order[i - 1], order[i]));
  return edges;
}

std::vector<Edge> delaunay_edges(Points points, std::span<const Index> chosen) {
  const std::vector<Point> local = selected(points, chosen);
  std::vector<Edge> edges = all_collinear(local) ? chain_edges(local) : edges_of(delaunay_triangulation(local));
  for (Edge& edge : edges) edge = make_edge(chosen[edge.a], chosen[edge.b]);
  return edges;
}

Quadtree timed_quadtree(Points points, int capacity, Context& context) {
  const ScopedPhase phase(context, "grid");
  return {points, capacity};
}

// The edges of all leaves' triangulations. `steps` may be null.
std::vector<Edge> leaf_edges(Points points, const Quadtree& tree, int capacity, QuadtreeTriangulation& result,
                             StepTrace* steps) {
  std::vector<Edge> edges;
  edges.reserve(2 * points.size());
  for (const Quadtree::Cell& cell : tree.cells()) {
    if (steps != nullptr) steps->cells.push_back({cell.x, cell.y, cell.right, cell.top, cell.is_leaf, {}});
    if (!cell.is_leaf) continue;
    ++result.leaves;
    const std::span<const Index> chosen = tree.points_of(cell);
    const bool is_overfull = chosen.size() > static_cast<std::size_t>(capacity);
    result.overfull_leaves += is_overfull ? 1 : 0;
    const std::vector<Edge> local = is_overfull ? delaunay_edges(points, chosen) : minimum_weight_edges(points, chosen);
    edges.insert(edges.end(), local.begin(), local.end());
    if (steps != nullptr) steps->cells.back().edges = local;
  }
  return edges;
}

// Depth-first order: the smallest cell that holds both points of an edge is the last one with both in its range.
std::vector<Edge> joints_by_depth(const Quadtree& tree, const std::vector<Edge>& edges) {
  std::vector<std::uint32_t> place(tree.order().size());
  for (std::uint32_t i = 0; i < place.size(); ++i) place[tree.order()[i]] = i;
  std::vector<std::pair<int, Edge>> joints;  // by depth of that cell, deepest first
  for (const Edge& edge : edges) {
    const auto [low, high] = std::minmax(place[edge.a], place[edge.b]);
    // Cells behind the last one that begins at or before `low` hold other points; its ancestors come before it.
    const auto behind = std::upper_bound(tree.cells().begin(), tree.cells().end(), low,
                                         [](std::uint32_t p, const Quadtree::Cell& cell) { return p < cell.first; });
    for (auto cell = behind; cell != tree.cells().begin();) {
      --cell;
      if (cell->last <= high) continue;
      if (!cell->is_leaf) joints.emplace_back(-cell->depth, edge);
      break;
    }
  }
  std::stable_sort(joints.begin(), joints.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  std::vector<Edge> result;
  for (const auto& [depth, edge] : joints) result.push_back(edge);
  return result;
}

void scale_up(std::vector<TracedCell>& cells, int e) {
  for (TracedCell& cell : cells) {
    for (double* const side : {&cell.left, &cell.bottom, &cell.right, &cell.top}) *side = std::ldexp(*side, e);
  }
}

Solution solve(Points points, Context& context) {
  const std::int64_t capacity = context.parameters.integer("capacity");
  if (capacity < 1 || capacity > kMaxLeaf) {
    throw InputError(fmt::format("quadtree: parameter capacity={} is not between 1 and {}", capacity, kMaxLeaf));
  }
  QuadtreeTriangulation result = quadtree_triangulation(points, static_cast<int>(capacity), context);
  Solution solution;
  solution.triangulation = std::move(result.triangulation);
  solution.counters = {{"leaves", static_cast<double>(result.leaves)},
                       {"constraints", static_cast<double>(result.constraints)},
                       {"overfull_leaves", static_cast<double>(result.overfull_leaves)}};
  return solution;
}

}  // namespace

QuadtreeTriangulation quadtree_triangulation(Points points, int capacity, Context& context) {
  if (const int e = exact_scale(points); e != 0) {
    QuadtreeTriangulation result = quadtree_triangulation(exactly_scaled(points), capacity, context);
    if (context.steps != nullptr) scale_up(context.steps->cells, e);
    return result;
  }
  QuadtreeTriangulation result;
  const Quadtree tree = timed_quadtree(points, capacity, context);
  std::vector<Edge> constraints;
  {
    const ScopedPhase phase(context, "leaves");
    constraints = leaf_edges(points, tree, capacity, result, context.steps);
  }
  result.constraints = constraints.size();
  const ScopedPhase phase(context, "merge");
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  insert_constraints(mesh, constraints);
  result.triangulation = mesh.triangulation();
  if (context.steps != nullptr) context.steps->joints = joints_by_depth(tree, edges_of(result.triangulation));
  return result;
}

AlgorithmInfo quadtree_entry() {
  AlgorithmInfo info;
  info.name = "quadtree";
  info.summary = "optimal in the leaves of a quadtree, merged by a constrained Delaunay triangulation";
  info.source = "source report, section 5.4";
  info.guarantee = "none known";
  info.version = 3;
  info.time = "O(n log n)";
  info.space = "O(n)";
  info.max_n = 1'000'000;
  info.has_steps = true;
  info.parameters = {{"capacity", ParameterType::integer, "4", fmt::format("points per leaf, 1 to {}", kMaxLeaf), {}}};
  info.function = solve;
  return info;
}

}  // namespace mwt
