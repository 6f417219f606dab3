#include "algorithms/triangle_lp/triangle_lp.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/max_points.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/common/solve_scaled.h"
#include "algorithms/proof/cover_duals.h"
#include "algorithms/triangle_lp/empty_triangles.h"
#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

std::vector<Edge> hull_boundary(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  std::vector<Edge> boundary;
  for (std::size_t i = 0; i < hull.size(); ++i) boundary.push_back({hull[i], hull[(i + 1) % hull.size()]});
  return boundary;
}

// The hull is certain, and everything else one region.
void note_proof(Points points, const std::vector<Edge>& boundary, std::span<const Triangle> triangles,
                const std::vector<Triangle>& cover, Context& context) {
  const ScopedPhase phase(context, "proof");
  DualRegion region;
  std::vector<bool> is_on_hull(points.size(), false);
  for (const Edge& edge : boundary) {
    region.places.push_back(edge.a);
    is_on_hull[edge.a] = true;
  }
  region.walk_sizes = {static_cast<std::uint32_t>(boundary.size())};
  for (Index v = 0; v < points.size(); ++v) {
    if (!is_on_hull[v]) region.places.push_back(v);
  }
  std::vector<std::uint32_t> place(points.size());
  for (std::uint32_t i = 0; i < region.places.size(); ++i) place[region.places[i]] = i;
  std::vector<Edge> sides;
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) sides.push_back(directed_edge(triangle, i));
  }
  std::vector<Edge> on_hull = undirected_edges(boundary);
  for (const Edge& edge : undirected_edges(std::move(sides))) {
    if (std::binary_search(on_hull.begin(), on_hull.end(), edge)) continue;
    region.open_edges.push_back({std::min(place[edge.a], place[edge.b]), std::max(place[edge.a], place[edge.b])});
  }
  std::sort(region.open_edges.begin(), region.open_edges.end());
  add_cover_duals(region, {points, triangles, boundary, cover.size(), context.deadline, cover});
  ProofTrace& trace = *context.proof;
  trace.lower_bound = next_down(cycle_length(points, convex_hull(points)).lower + region.lower_bound);
  trace.regions.push_back(std::move(region));
  trace.is_complete = true;
}

// For triangles, columns and what is kept by side of them.
constexpr std::uint64_t kBytesPerTriangle = 128;

std::optional<std::vector<Triangle>> find_empty_triangles(Points points, Context& context) {
  const ScopedPhase phase(context, "empty_triangles");
  const std::uint64_t bytes_for_sets = points.size() * points.size() * (points.size() / 64 + 1) * 8;
  if (!context.fits(bytes_for_sets)) return {};
  const std::size_t most = context.memory_bytes ? (*context.memory_bytes - bytes_for_sets) / kBytesPerTriangle
                                                : std::numeric_limits<std::size_t>::max();
  return empty_triangles(points, most, context.deadline);
}

Solution cover_hull(Points points, Context& context) {
  const std::vector<Edge> boundary = hull_boundary(points);
  const Triangulation start{static_cast<Index>(points.size()), canonical_triangles(delaunay_triangulation(points))};
  Solution solution;
  const std::optional<std::vector<Triangle>> triangles = find_empty_triangles(points, context);
  if (!triangles) {
    solution.triangulation = start;
    solution.optimum = {cycle_length(points, convex_hull(points)).lower, weight(points, start).upper};
    solution.stop_reason = context.deadline_passed() ? StopReason::deadline : StopReason::memory;
    if (context.proof != nullptr) *context.proof = trace_of_bound(solution.optimum->lower);
    return solution;
  }
  TriangleCover cover = [&] {
    const ScopedPhase phase(context, "program");
    return lightest_triangle_cover(
        {points, *triangles, boundary, start.triangles.size(), context.deadline, start.triangles});
  }();
  if (context.proof != nullptr) note_proof(points, boundary, *triangles, cover.triangles, context);
  solution.triangulation = {start.point_count, std::move(cover.triangles)};
  solution.optimum = cover.optimum;
  solution.stop_reason = cover.stop_reason;
  solution.counters = {{"empty_triangles", static_cast<double>(triangles->size())},
                       {"programs", static_cast<double>(cover.programs)},
                       {"branchings", static_cast<double>(cover.branchings)}};
  return solution;
}

}  // namespace

Solution solve_triangle_program(Points points, Context& context) {
  require_max_points("triangle_lp", points, context);
  Solution solution = [&] {
    const OtherDeadline leaving_time(context, deadline_before_heuristics(context.deadline, points.size()));
    return cover_hull(points, context);
  }();
  if (solution.stop_reason) improve_by_heuristics(points, context, solution);
  return solution;
}

AlgorithmInfo triangle_lp_entry() {
  AlgorithmInfo info;
  info.name = "triangle_lp";
  info.summary =
      "lightest cover of the hull by empty triangles: linear programming with branching, certified by dual bounds";
  info.source =
      "G. B. Dantzig, A. J. Hoffman, T. C. Hu, Triangulations (tilings) and certain block triangular matrices, "
      "Mathematical Programming 31, 1985";
  info.guarantee = "optimal, up to the certified interval it returns";
  info.time = "a few linear programs of O(n^2) rows; exponential in the worst case";
  info.space = "O(n^3), O(n^2) for uniform points";
  info.exactness = Exactness::exact;
  info.has_proofs = true;
  info.max_n = 150;
  info.version = 2;
  info.parameters = {{"max_points", ParameterType::integer, "400", "largest number of points it takes"}};
  info.function = [](Points points, Context& context) { return solve_scaled(points, context, solve_triangle_program); };
  return info;
}

}  // namespace mwt
