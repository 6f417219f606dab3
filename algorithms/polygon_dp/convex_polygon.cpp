#include "algorithms/polygon_dp/convex_polygon.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <limits>
#include <new>
#include <numeric>
#include <optional>
#include <utility>

#include "algorithms/common/lightest_heuristic.h"
#include "algorithms/common/other_deadline.h"
#include "algorithms/exact/usable_threads.h"
#include "algorithms/polygon_dp/convex_bounds.h"
#include "algorithms/polygon_dp/convex_program.h"
#include "algorithms/polygon_dp/preorder.h"
#include "geometry/predicates.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

class ConvexSolver {
 public:
  ConvexSolver(std::vector<Point> polygon, Context& context)
      : polygon_(std::move(polygon)), context_(context), cycle_(polygon_.size()) {
    std::iota(cycle_.begin(), cycle_.end(), 0U);
    hull_ = cycle_length(polygon_, cycle_);
  }

  ConvexPolygonSolution run() {
    consider_heuristics();
    raise_lower(hull_.lower);
    const bool fits = context_.fits(ConvexProgram::bytes(polygon_.size()));
    const bool bounds_come_first = context_.deadline || !fits;
    if (bounds_come_first) try_bounds();
    result_.stop_reason = fits ? try_program() : StopReason::memory;
    if (result_.stop_reason && !bounds_come_first) try_bounds();
    return std::move(result_);
  }

 private:
  // For at most a third of the time.
  void consider_heuristics() {
    const ScopedPhase phase(context_, "heuristics");
    const auto now = deadline_clock();
    const Deadline& whole = context_.deadline;
    const OtherDeadline share(context_, whole ? whole.moved_to(now + (*whole - now) / 3) : Deadline(whole));
    consider(lightest_heuristic(polygon_, context_).triangles);
  }

  void consider(std::vector<Triangle> triangles) {
    const double found = weight(polygon_, {static_cast<Index>(polygon_.size()), triangles}).upper;
    if (found >= result_.weight_of_optimum.upper) return;
    result_.triangles = std::move(triangles);
    result_.weight_of_optimum.upper = found;
  }

  void raise_lower(double bound) { result_.weight_of_optimum.lower = std::max(result_.weight_of_optimum.lower, bound); }

  // With longer and longer intervals, each step four times as long as the one before.
  void try_bounds() {
    constexpr std::size_t kMaxReach = 8;
    const ScopedPhase phase(context_, "coarse_programs");
    const std::size_t size = polygon_.size();
    for (std::size_t reach = 1; reach <= kMaxReach && reach * kTile * 14 <= size; reach *= 2) {
      if (context_.deadline_passed() || !context_.fits(bytes_for_convex_bounds(size, reach))) return;
      try {
        std::optional<ConvexBounds> bounds = bound_convex_polygon(chords(), reach, context_.deadline);
        if (!bounds) return;
        if (!bounds->triangles.empty()) consider(std::move(bounds->triangles));
        raise_lower(next_down(hull_.lower + bounds->diagonals_at_least));
      } catch (const std::bad_alloc&) {
        return;  // there is less memory than the context states
      }
    }
  }

  // What stops it, if anything.
  std::optional<StopReason> try_program() {
    const ScopedPhase phase(context_, "interval_program");
    const auto progress = [&](double share) {
      if (context_.progress) context_.progress("interval program", share);
    };
    try {
      const ConvexChords all_chords = chords();
      ConvexProgram program(all_chords);
      if (!program.run(context_.deadline, progress)) return StopReason::deadline;
      consider(program.triangles());
      raise_lower(next_down(hull_.lower + program.diagonals_at_least()));
      return {};
    } catch (const std::bad_alloc&) {
      return StopReason::memory;
    }
  }

  // In units that the best triangulation so far fits in.
  [[nodiscard]] ConvexChords chords() const { return {polygon_, result_.weight_of_optimum.upper}; }

  std::vector<Point> polygon_;
  Context& context_;
  std::vector<Index> cycle_;
  Interval hull_;  // the polygon's length
  ConvexPolygonSolution result_{{}, {0, std::numeric_limits<double>::infinity()}, {}};
};

template <class Number>
void renumber(std::vector<Triangle>& triangles, const Number& number) {
  for (Triangle& triangle : triangles) {
    for (Index& corner : triangle) corner = number(corner);
  }
}

ConvexPolygonSolution triangulate_small(Points points, std::span<const Index> polygon, PolygonObjective objective) {
  PolygonTriangulation optimum = triangulate_polygon(points, polygon, objective);
  if (objective == PolygonObjective::perimeter) {  // 2 weight - hull
    const std::vector<Index> cycle(polygon.begin(), polygon.end());
    const Interval twice = optimum.cost + cycle_length(points, cycle);
    optimum.cost = {0.5 * twice.lower, 0.5 * twice.upper};
  }
  return {std::move(optimum.triangles), optimum.cost, {}};
}

}  // namespace

ConvexPolygonSolution triangulate_convex_polygon(Points points, std::span<const Index> polygon,
                                                 PolygonObjective objective, Context& context) {
  if (polygon.size() <= kSmallPolygon) return triangulate_small(points, polygon, objective);
  // From a strict corner on.
  const auto first = std::min_element(polygon.begin(), polygon.end(),
                                      [&](Index a, Index b) { return lexicographically_less(points[a], points[b]); });
  const auto shift = static_cast<std::size_t>(first - polygon.begin());
  std::vector<Point> own;
  own.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) own.push_back(points[polygon[(i + shift) % polygon.size()]]);
  tbb::task_arena arena(usable_threads(context));
  ConvexPolygonSolution solution = arena.execute([&] { return ConvexSolver(std::move(own), context).run(); });
  renumber(solution.triangles, [&](Index v) { return static_cast<Index>((v + shift) % polygon.size()); });
  solution.triangles = in_preorder(std::move(solution.triangles), polygon.size());
  renumber(solution.triangles, [&](Index v) { return polygon[v]; });
  return solution;
}

}  // namespace mwt
