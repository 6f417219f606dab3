#include "algorithms/exact/face_proof.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "algorithms/exact/division/crossing_candidates.h"
#include "algorithms/exact/faces/face_region.h"
#include "algorithms/exact/faces/face_traversal.h"
#include "algorithms/exact/faces/walk_diagonals.h"
#include "algorithms/exact/holes/local_region.h"
#include "algorithms/exact/holes/region_triangles.h"
#include "algorithms/exact/strip_proof.h"
#include "algorithms/proof/cover_duals.h"
#include "algorithms/proof/polygon_duals.h"
#include "algorithms/proof_trace.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using Place = std::uint32_t;

constexpr std::size_t kMaxTriangles = 100'000;  // of a region's linear program

struct ProofPart : FacePart {
  std::vector<DualRegion> regions;
};

class FaceProof {
 public:
  FaceProof(CandidateGraph graph, std::span<const Triangle> triangles, const Context& context)
      : faces_(std::move(graph)), triangles_(triangles), context_(context) {}

  void run() {
    const auto note = [this](const Walk& walk, ProofPart& part) { note_walk(walk, part); };
    faces_.run(note);
    removed_ = *find_crossing_candidates(faces_.graph(), faces_.open_candidates(), Deadline(), &crossed_);
    faces_.remove_candidates(removed_, note);
    note_composite_faces();
    assemble();
  }

 private:
  void note_walk(const Walk& walk, ProofPart& part) {
    if (is_triangle(walk)) return;
    const auto diagonals = diagonals_of_walk(faces_.graph(), walk);
    if (!diagonals) return part.composite_walks.push_back(walk);
    if (walk.size() > kLongWalk && has_passed(context_.deadline)) return;  // no more than what takes no time
    if (!context_.fits(PolygonDuals::bytes_for(diagonals->size()))) return;
    std::vector<Index> corners;
    for (const Corner& corner : walk) corners.push_back(corner.vertex);
    auto region = polygons_.local().solve(faces_.graph().points, corners, *diagonals, context_.deadline);
    if (region) part.regions.push_back(*std::move(region));
  }

  void note_composite_faces() {
    const std::vector<FaceRegion> regions = faces_.take_composite_faces();
    if (regions.empty()) return;
    const auto point_count = static_cast<Index>(faces_.graph().points.size());
    const Triangulation known{point_count, {triangles_.begin(), triangles_.end()}};
    known_ = canonical_triangles(known);
    known_edges_ = edges_of(known);
    std::vector<std::optional<DualRegion>> noted(regions.size());
    tbb::parallel_for(std::size_t{0}, regions.size(), [&](std::size_t i) { noted[i] = note_region(regions[i]); });
    ProofPart& part = faces_.parts().emplace_back();
    for (auto& region : noted) {
      if (region) part.regions.push_back(*std::move(region));
    }
  }

  // Nothing if there are too many triangles or the deadline has passed.
  [[nodiscard]] std::optional<DualRegion> note_region(const FaceRegion& region) const {
    if (has_passed(context_.deadline)) return {};
    const LocalRegion local = make_local(faces_.graph().points, region);
    DualRegion result = outline(local);
    if (region.components != 2 || !add_duals_around_hole(result, local, region.diagonal_count())) {
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

  [[nodiscard]] bool add_duals_around_hole(DualRegion& result, const LocalRegion& local, std::size_t diagonals) const {
    if (!context_.fits(3 * PolygonDuals::bytes_for(result.open_edges.size()))) return false;
    return add_strip_duals(result, local, known_length(result, local, diagonals), context_.deadline);
  }

  // Of the region's open edges that the triangulation has, if they triangulate it.
  [[nodiscard]] std::optional<double> known_length(const DualRegion& outline, const LocalRegion& local,
                                                   std::size_t diagonals) const {
    double sum = 0;
    for (const auto& [from, to] : outline.open_edges) {
      const Index a = outline.places[from], b = outline.places[to];
      const Edge edge = make_edge(local.vertices[a], local.vertices[b]);
      if (!std::binary_search(known_edges_.begin(), known_edges_.end(), edge)) continue;
      sum += length(local.points[a], local.points[b]).high;
      --diagonals;
    }
    return diagonals == 0 ? std::optional(sum) : std::nullopt;
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
    trace.edges.push_back({EdgeReason::uncrossed, edges_marked(faces_.graph(), 1), {}});
    LengthSum length;
    DoubleDouble lower;  // in doubles, hundreds of thousands of regions would lose too much
    for (ProofPart& part : faces_.parts()) {
      length.add(part.certain);
      for (DualRegion& region : part.regions) {
        lower = lower + DoubleDouble(region.lower_bound);
        trace.regions.push_back(std::move(region));
      }
    }
    if (!removed_.empty()) {
      trace.edges.push_back({EdgeReason::crosses_certain, std::move(removed_), std::move(crossed_)});
    }
    const DoubleDouble sum = lower + DoubleDouble(length.enclosure().lower);
    trace.lower_bound = std::max(0.0, next_down(next_down(sum.high)));
    trace.is_complete = true;
  }

  FaceTraversal<ProofPart> faces_;
  std::span<const Triangle> triangles_;
  const Context& context_;
  tbb::enumerable_thread_specific<PolygonDuals> polygons_;
  std::vector<Edge> removed_, crossed_;
  // The triangulation, canonical, and its edges; only if there are composite faces.
  std::vector<Triangle> known_;
  std::vector<Edge> known_edges_;
};

}  // namespace

void note_faces(CandidateGraph graph, std::span<const Triangle> triangles, const Context& context) {
  FaceProof(std::move(graph), triangles, context).run();
}

}  // namespace mwt
