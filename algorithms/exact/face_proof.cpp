#include "algorithms/exact/face_proof.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <unordered_map>

#include "algorithms/exact/cut_proof.h"
#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_walk.h"
#include "algorithms/exact/faces/walk_diagonals.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/exact/holes/region_triangles.h"
#include "algorithms/proof/cover_duals.h"
#include "algorithms/proof/polygon_duals.h"
#include "algorithms/proof_trace.h"
#include "geometry/undirected_edges.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using Place = std::uint32_t;

constexpr std::size_t kBlock = 4096;            // vertices per task
constexpr std::size_t kLongWalk = 64;           // longer walks are collected one after the other
constexpr std::size_t kMaxTriangles = 100'000;  // of a region's linear program

// What one task found, in a fixed order.
struct Part {
  std::vector<DualRegion> regions;
  LengthSum certain;
  std::vector<Edge> certain_edges;
  std::vector<Corner> long_walks;
  std::vector<Walk> composite_walks;
  std::vector<Index> isolated;
};

class FaceProof {
 public:
  FaceProof(CandidateGraph graph, std::span<const Triangle> triangles, const Context& context)
      : graph_(std::move(graph)), triangles_(triangles), context_(context), walker_(graph_) {}

  void run() {
    outer_face_ = walker_->owner_of_outer_face();
    const std::size_t blocks = (graph_.points.size() + kBlock - 1) / kBlock;
    parts_.resize(blocks);
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
      const std::size_t end = std::min(graph_.points.size(), (block + 1) * kBlock);
      note_block(static_cast<Index>(block * kBlock), static_cast<Index>(end), parts_[block]);
    });
    note_long_walks();
    remove_crossing();
    note_composite_faces();
    assemble();
  }

 private:
  void note_block(Index begin, Index end, Part& part) {
    Walk walk;
    for (Index v = begin; v < end; ++v) {
      bool is_isolated = true;
      for (std::uint32_t h = graph_.first[v]; h < graph_.first[v + std::size_t{1}]; ++h) {
        if (graph_.certain[h] == 0) continue;
        is_isolated = false;
        const Index target = graph_.target[h];
        if (v < target) {
          part.certain.add(graph_.points[v], graph_.points[target]);
          part.certain_edges.push_back({v, target});
        }
        const WalkEnd walk_end = walker_->walk(v, h, kLongWalk, walk);
        if (walk_end == WalkEnd::too_long) part.long_walks.push_back({v, h, 0});
        if (walk_end == WalkEnd::closed && h != outer_face_) note_walk(walk, part);
      }
      if (is_isolated) part.isolated.push_back(v);
    }
  }

  void note_walk(const Walk& walk, Part& part) {
    const bool has_candidates = std::any_of(walk.begin(), walk.end(), [](const Corner& c) { return c.candidates > 0; });
    if (!has_candidates && walk.size() == 3) return;
    const auto diagonals = diagonals_of_walk(graph_, walk);
    if (!diagonals) return part.composite_walks.push_back(walk);
    if (walk.size() > kLongWalk && has_passed(context_.deadline)) return;  // no more than what takes no time
    std::vector<Index> corners;
    for (const Corner& corner : walk) corners.push_back(corner.vertex);
    part.regions.push_back(polygons_.local().solve(graph_.points, corners, *diagonals));
  }

  void note_long_walks() {
    std::vector<bool> is_visited(graph_.target.size());
    std::vector<Walk> walks;
    for (const Part& part : parts_) {
      for (const Corner& start : part.long_walks) {
        if (is_visited[start.halfedge]) continue;
        Walk walk = walker_->corners_of_face(start.vertex, start.halfedge);
        for (const Corner& corner : walk) is_visited[corner.halfedge] = true;
        if (start.halfedge != outer_face_) walks.push_back(std::move(walk));
      }
    }
    const std::size_t blocks = parts_.size();
    parts_.resize(blocks + walks.size());
    tbb::parallel_for(std::size_t{0}, walks.size(), [&](std::size_t i) { note_walk(walks[i], parts_[blocks + i]); });
  }

  // Those in faces that are no polygons: a candidate that crosses a certain edge leads out of its face at both ends.
  [[nodiscard]] std::vector<Edge> suspects() const {
    std::vector<Edge> edges;
    for (const Part& part : parts_) {
      for (const Walk& walk : part.composite_walks) {
        for (const Corner& corner : walk) {
          for (std::uint32_t i = 0; i < corner.candidates; ++i) {
            edges.push_back({corner.vertex, candidate_of(graph_, corner, i)});
          }
        }
      }
      for (const Index vertex : part.isolated) {
        for (const Index target : graph_.star(vertex)) edges.push_back({vertex, target});
      }
    }
    return undirected_edges(std::move(edges));
  }

  // Deletes the candidates that cross certain edges. Their faces are walked again: some are polygons now.
  void remove_crossing() {
    removed_ = *find_crossing_candidates(graph_, suspects(), Deadline(), &crossed_);
    if (removed_.empty()) return;
    std::vector<std::vector<Edge>> starts(parts_.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (const Walk& walk : parts_[i].composite_walks) {
        starts[i].push_back({walk.back().vertex, graph_.target[walk.back().halfedge]});
      }
      parts_[i].composite_walks.clear();
    }
    remove_edges(graph_, removed_);
    walker_.emplace(graph_);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      for (const Edge& start : starts[i]) {
        const std::uint32_t halfedge = walker_->corner_towards(start.a, start.b).halfedge;
        note_walk(walker_->corners_of_face(start.a, halfedge), parts_[i]);
      }
    }
  }

  void note_composite_faces() {
    std::vector<Walk> walks;
    std::vector<Index> isolated;
    for (Part& part : parts_) {
      std::move(part.composite_walks.begin(), part.composite_walks.end(), std::back_inserter(walks));
      isolated.insert(isolated.end(), part.isolated.begin(), part.isolated.end());
    }
    if (walks.empty()) return;
    known_ = canonical_triangles({static_cast<Index>(graph_.points.size()), {triangles_.begin(), triangles_.end()}});
    const std::vector<FaceRegion> regions = group_into_regions(graph_, *walker_, walks, isolated);
    std::vector<std::optional<DualRegion>> noted(regions.size());
    tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) { noted[i] = note_region(regions[i]); });
    parts_.emplace_back();
    for (auto& region : noted) {
      if (region) parts_.back().regions.push_back(*std::move(region));
    }
  }

  // Nothing if there are too many triangles or the deadline has passed.
  [[nodiscard]] std::optional<DualRegion> note_region(const FaceRegion& region) const {
    if (has_passed(context_.deadline)) return {};
    const LocalRegion local = make_local(graph_.points, region);
    DualRegion result = outline(local);
    if (region.components != 2 || !add_cut_duals(result, local, context_.deadline)) {
      const auto triangles = region_triangles(local.points, local.sides, kMaxTriangles, context_.deadline);
      if (!triangles) return {};
      const std::vector<Triangle> start = known_among(local, *triangles);
      const TriangleCoverProblem problem{local.points,      *triangles, local.boundary, region.triangle_count(),
                                         context_.deadline, start};
      add_cover_duals(result, problem);
    }
    for (Index& place : result.places) place = local.vertices[place];
    return result;
  }

  // Places by local numbers: closed walks along the boundary, in any order, then points that are on none.
  static DualRegion outline(const LocalRegion& local) {
    DualRegion result;
    std::vector<Place> place_of(local.points.size(), 0);
    std::vector<bool> has_place(local.points.size(), false);
    std::vector<std::vector<Index>> next(local.points.size());
    for (const Edge& side : local.boundary) next[side.a].push_back(side.b);
    const auto add_place = [&](Index v) {
      place_of[v] = static_cast<Place>(result.places.size());
      has_place[v] = true;
      result.places.push_back(v);
    };
    // Where the boundary meets itself, any way to go on makes closed walks in the end.
    for (Index v = 0; v < local.points.size(); ++v) {
      while (!next[v].empty()) {
        const std::size_t first = result.places.size();
        for (Index at = v; !next[at].empty();) {
          add_place(at);
          const Index to = next[at].back();
          next[at].pop_back();
          at = to;
        }
        result.walk_sizes.push_back(static_cast<std::uint32_t>(result.places.size() - first));
      }
    }
    for (Index v = 0; v < local.points.size(); ++v) {
      if (!has_place[v]) add_place(v);
    }
    for (std::size_t i = local.boundary.size(); i < local.sides.size(); i += 2) {  // each in both directions
      const Place a = place_of[local.sides[i].a], b = place_of[local.sides[i].b];
      result.open_edges.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(result.open_edges.begin(), result.open_edges.end());
    return result;
  }

  // Those triangles of a region that the triangulation has.
  [[nodiscard]] std::vector<Triangle> known_among(const LocalRegion& local, const std::vector<Triangle>& all) const {
    std::vector<Triangle> result;
    for (const Triangle& triangle : all) {
      Triangle t = triangle;
      for (Index& corner : t) corner = local.vertices[corner];
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      if (std::binary_search(known_.begin(), known_.end(), t)) result.push_back(triangle);
    }
    return result;
  }

  void assemble() {
    ProofTrace& trace = *context_.proof;
    EdgeConclusions certain{EdgeReason::uncrossed, {}, {}};
    LengthSum length;
    DoubleDouble lower;  // in doubles, hundreds of thousands of regions would lose too much
    for (Part& part : parts_) {
      certain.edges.insert(certain.edges.end(), part.certain_edges.begin(), part.certain_edges.end());
      length.add(part.certain);
      for (DualRegion& region : part.regions) {
        lower = lower + DoubleDouble(region.lower_bound);
        trace.regions.push_back(std::move(region));
      }
    }
    trace.edges.push_back(std::move(certain));
    if (!removed_.empty()) {
      trace.edges.push_back({EdgeReason::crosses_certain, std::move(removed_), std::move(crossed_)});
    }
    const DoubleDouble sum = lower + DoubleDouble(length.enclosure().lower);
    trace.lower_bound = std::max(0.0, next_down(next_down(sum.high)));
    trace.is_complete = true;
  }

  CandidateGraph graph_;
  std::span<const Triangle> triangles_;
  const Context& context_;
  std::optional<FaceWalker> walker_;
  std::uint32_t outer_face_ = 0;
  tbb::enumerable_thread_specific<PolygonDuals> polygons_;
  std::vector<Part> parts_;
  std::vector<Edge> removed_, crossed_;
  std::vector<Triangle> known_;  // the triangulation, canonical; only if there are composite faces
};

}  // namespace

void note_faces(CandidateGraph graph, std::span<const Triangle> triangles, const Context& context) {
  FaceProof(std::move(graph), triangles, context).run();
}

}  // namespace mwt
