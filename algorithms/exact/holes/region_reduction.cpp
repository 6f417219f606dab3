#include "algorithms/exact/holes/region_reduction.h"

#include <algorithm>
#include <utility>

#include "algorithms/exact/holes/cut_duals.h"
#include "algorithms/exact/holes/cut_polygon.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxLooseTriangles = std::size_t{1} << 24;
constexpr int kMaxRounds = 40;

class Reduction {
 public:
  Reduction(Points points, const FaceRegion& region, double limit, const Deadline& deadline)
      : points_(points), region_(region), limit_(limit), deadline_(deadline) {}

  std::optional<ReducedRegion> run() {
    std::vector<Edge> cuts = shortest_cuts(points_, region_);
    if (cuts.size() + 1 != region_.components) return {};
    polygon_ = cut_open(points_, region_, std::move(cuts), deadline_);
    if (!polygon_ || !polygon_->program.is_feasible(polygon_->program.closing_cell())) return {};
    if (!take_triangulation()) return {};
    CutDuals duals(*polygon_);
    if (!duals.find_loose_triangles(kMaxLooseTriangles, deadline_)) return {};
    improve(duals);
    if (!result_.is_closed()) collect(duals);
    return std::move(result_);
  }

 private:
  [[nodiscard]] Index vertex(Index place) const { return region_.vertices[place]; }

  // Of the cut polygon. Whether all its triangles turn left, so that they cover it once.
  bool take_triangulation() {
    IntervalProgram& program = polygon_->program;
    const bool all_turn_left = program.visit_triangles(0, program.closing_cell(), [&](const Triangle& t, bool) {
      result_.triangles.push_back({vertex(t[0]), vertex(t[1]), vertex(t[2])});
      return orientation(polygon_->points[t[0]], polygon_->points[t[1]], polygon_->points[t[2]]) > 0;
    });
    if (!all_turn_left) return false;
    result_.diagonals = diagonals_length(points_, region_, result_.triangles);
    result_.reach = std::min(limit_, result_.diagonals.enclosure().upper);
    return true;
  }

  // Chords are looked at when the gap has shrunk to a quarter since.
  void improve(CutDuals& duals) {
    double gap_for_chords = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kMaxRounds && !has_passed(deadline_); ++round) {
      const double before = duals.lower_bound();
      duals.improve(deadline_);
      result_.lower_bound = std::clamp(duals.lower_bound(), 0.0, result_.reach);
      if (result_.is_closed()) return;
      const double gap = result_.reach - duals.lower_bound();
      const bool with_chords = gap < gap_for_chords / 4;
      if (with_chords) gap_for_chords = gap;
      const std::size_t removed = duals.remove_expensive(result_.reach, with_chords);
      const bool has_stalled = removed == 0 && duals.lower_bound() - before < gap / 100;
      if (has_stalled && gap >= gap_for_chords / 1.1) return;
      if (has_stalled) gap_for_chords = std::numeric_limits<double>::infinity();  // one last look
    }
  }

  void collect(const CutDuals& duals) {
    const CandidateGraph& graph = polygon_->graph;
    for (Index v = 0; v < graph.points.size(); ++v) {
      for (std::uint32_t h = graph.first[v]; h < graph.first[v + std::size_t{1}]; ++h) {
        const bool is_candidate = polygon_->kind[h] == SideKind::chord || polygon_->kind[h] == SideKind::crossing;
        if (is_candidate && v < graph.target[h] && duals.is_alive(h))
          result_.candidates.push_back({vertex(v), vertex(graph.target[h])});
      }
    }
    for (std::size_t i = 0; i < polygon_->cuts.size(); ++i) {
      const Edge cut{vertex(polygon_->cuts[i].a), vertex(polygon_->cuts[i].b)};
      result_.candidates.push_back(cut);
      if (duals.is_certain(i, result_.reach)) result_.certain.push_back(cut);
    }
    std::sort(result_.candidates.begin(), result_.candidates.end());
  }

  Points points_;
  const FaceRegion& region_;
  double limit_;
  const Deadline& deadline_;
  std::optional<CutPolygon> polygon_;
  ReducedRegion result_;
};

}  // namespace

std::optional<ReducedRegion> reduce_region(Points points, const FaceRegion& region, double limit,
                                           const Deadline& deadline) {
  return Reduction(points, region, limit, deadline).run();
}

}  // namespace mwt
