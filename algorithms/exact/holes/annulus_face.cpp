#include "algorithms/exact/holes/annulus_face.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/exact/faces/interval_program.h"
#include "algorithms/exact/holes/strip.h"
#include "algorithms/exact/holes/strip_paths.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

using Place = Strip::Place;
using Position = IntervalProgram::Position;

constexpr double kScale = 0x1p600;

bool are_tiny(const std::vector<Point>& points) {
  return std::all_of(points.begin(), points.end(),
                     [](const Point& p) { return std::abs(p.x) < 0x1p-400 && std::abs(p.y) < 0x1p-400; });
}

// A chain over two periods, in the order of the face's boundary, as intervals.
class ChainProgram {
 public:
  // `is_reversed`: the boundary's order is that of falling places.
  ChainProgram(const Strip::Chain& chain, bool is_reversed, Points points)
      : chain_(chain), is_reversed_(is_reversed), program_(points) {}

  bool compute(const Deadline& deadline) {
    const Place period = chain_.period();
    if (period == 0) return true;
    std::vector<std::vector<Position>> cells(static_cast<std::size_t>(period));
    for (Place from = 0; from < period; ++from) {
      for (const Place to : chain_.chord[static_cast<std::size_t>(from)]) {
        const auto [first, last] = positions_of(from, to);
        cells[first].push_back(last);
      }
    }
    program_.clear();
    for (Place position = 0; position <= 2 * period; ++position) {
      program_.add_position(chain_.vertex_at(is_reversed_ ? -position : position));
      const bool is_second = position >= period;
      if (position == 2 * period) continue;
      auto& row = cells[static_cast<std::size_t>(is_second ? position - period : position)];
      std::sort(row.begin(), row.end());
      for (const Position cell : row) {
        const Position to = is_second ? cell + static_cast<Position>(period) : cell;
        const bool is_repeated = !is_second && cell <= static_cast<Position>(period);
        if (to > static_cast<Position>(2 * period)) break;
        if (is_repeated) {
          program_.add_copy(to, static_cast<Position>(period));
        } else {
          program_.add_cell(to);
        }
      }
    }
    return program_.compute(/*is_closed=*/false, deadline);
  }

  [[nodiscard]] ChordValues values() const {
    ChordValues values;
    for (Place from = 0; from < chain_.period(); ++from) {
      values.emplace_back();
      for (const Place to : chain_.chord[static_cast<std::size_t>(from)]) {
        const auto [first, last] = positions_of(from, to);
        const IntervalProgram::Cell cell = program_.find(first, last);
        values.back().push_back(program_.is_feasible(cell) ? program_.value(cell)
                                                           : DoubleDouble(std::numeric_limits<double>::infinity()));
      }
    }
    return values;
  }

  // Of the part that the chord cuts off.
  void append_triangles(Place from, Place to, std::vector<Triangle>& triangles) {
    const auto [first, last] = positions_of(from, to);
    program_.visit_triangles(first, program_.find(first, last), [&](const Triangle& triangle, bool) {
      triangles.push_back(triangle);
      return true;
    });
  }

 private:
  // The interval of a chord, the first position in the first period.
  [[nodiscard]] std::pair<Position, Position> positions_of(Place from, Place to) const {
    const Place period = chain_.period();
    Place first = is_reversed_ ? -to : from;
    first = ((first % period) + period) % period;
    return {static_cast<Position>(first), static_cast<Position>(first + to - from)};
  }

  const Strip::Chain& chain_;
  bool is_reversed_;
  IntervalProgram program_;
};

class AnnulusSolver {
 public:
  AnnulusSolver(Points points, const FaceRegion& region, double limit, const Deadline& deadline)
      : instance_(points), region_(region), limit_(limit), deadline_(deadline), points_(region.points_among(points)) {
    if (!are_tiny(points_)) return;
    scale_ = kScale;
    for (Point& p : points_) p = {p.x * kScale, p.y * kScale};
  }

  std::optional<AnnulusSolution> run() {
    const std::optional<Strip> strip = make_strip(points_, region_);
    if (!strip) return {};
    // The hole lies on the left of its boundary, where places fall.
    ChainProgram outer(strip->outer, false, points_), inner(strip->inner, true, points_);
    if (!outer.compute(deadline_) || !inner.compute(deadline_)) return {};
    const StripCosts costs{points_, outer.values(), inner.values()};
    StripPaths paths(*strip, costs, deadline_);
    const std::optional<StripPath> path = paths.lightest(unavoidable_edges(points_, *strip), limit_ * scale_);
    AnnulusSolution solution;
    solution.lower_bound = scale_ == 1 ? paths.lower_bound() : next_down(paths.lower_bound() / scale_);
    solution.is_late = !paths.is_complete();
    if (!path) {
      const bool is_infeasible = paths.is_complete() && limit_ == std::numeric_limits<double>::infinity();
      return is_infeasible || solution.lower_bound <= 0 ? std::nullopt : std::optional(std::move(solution));
    }
    if (!append_triangles(*strip, *path, outer, inner, solution.triangles)) return {};
    for (Triangle& triangle : solution.triangles) {
      for (Index& corner : triangle) corner = region_.vertices[corner];
    }
    solution.diagonals = diagonals_length(instance_, region_, solution.triangles);
    solution.lower_bound = std::min(solution.lower_bound, solution.diagonals.enclosure().lower);
    return solution;
  }

 private:
  // Whether they triangulate the region: as many as there must be, and all turn left.
  bool append_triangles(const Strip& strip, const StripPath& path, ChainProgram& outer, ChainProgram& inner,
                        std::vector<Triangle>& triangles) const {
    for (std::size_t i = 1; i < path.edges.size(); ++i) {
      const CrossEdge &e = path.edges[i - 1], &f = path.edges[i];
      if (e.outer != f.outer) {
        triangles.push_back(
            {strip.outer.vertex_at(e.outer), strip.outer.vertex_at(f.outer), strip.inner.vertex_at(e.inner)});
        outer.append_triangles(e.outer, f.outer, triangles);
      } else {
        triangles.push_back(
            {strip.inner.vertex_at(f.inner), strip.inner.vertex_at(e.inner), strip.outer.vertex_at(e.outer)});
        inner.append_triangles(e.inner, f.inner, triangles);
      }
    }
    return triangles.size() == region_.triangle_count() &&
           std::all_of(triangles.begin(), triangles.end(),
                       [&](const Triangle& t) { return orientation(points_[t[0]], points_[t[1]], points_[t[2]]) > 0; });
  }

  Points instance_;
  const FaceRegion& region_;
  double limit_;
  const Deadline& deadline_;
  std::vector<Point> points_;  // by position in region.vertices
  double scale_ = 1;
};

}  // namespace

std::optional<AnnulusSolution> solve_annulus(Points points, const FaceRegion& region, double limit,
                                             const Deadline& deadline) {
  return AnnulusSolver(points, region, limit, deadline).run();
}

}  // namespace mwt
