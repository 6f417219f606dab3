#include "algorithms/exact/proof/face_proof.h"

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
#include "algorithms/exact/proof/cut_proof.h"
#include "algorithms/exact/proof/outlined_region.h"
#include "algorithms/exact/proof/slit_proof.h"
#include "algorithms/exact/proof/strip_proof.h"
#include "algorithms/proof/cover_duals.h"
#include "algorithms/proof/polygon_duals.h"
#include "algorithms/proof_trace.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

constexpr std::size_t kMaxTriangles = 100'000;  // of a region's linear program

// A bound this near to a known length, relatively, proves it.
constexpr double kEnough = 2e-13;

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

  // The first of these ways that proves what the known triangulation weighs, else the best bound. Nothing if there is
  // none, because there are too many triangles or the deadline has passed.
  [[nodiscard]] std::optional<DualRegion> note_region(const FaceRegion& region) const {
    if (has_passed(context_.deadline)) return {};
    const LocalRegion local = make_local(faces_.graph().points, region);
    const DualRegion outline = outline_of(local);
    if (!context_.fits(3 * PolygonDuals::bytes_for(outline.open_edges.size()))) return {};
    std::vector<Edge> known = known_edges(outline, local);
    if (known.size() != region.diagonal_count()) known.clear();
    double enough = 0;
    for (const auto& [a, b] : known) enough += length(local.points[a], local.points[b]).high;
    enough *= 1 - kEnough;
    DualRegion best;
    const auto improve = [&](const auto& fill) {
      DualRegion attempt = outline;
      if (fill(attempt) && (best.tree.empty() || attempt.lower_bound > best.lower_bound)) best = std::move(attempt);
      return !best.tree.empty() && best.lower_bound >= enough;  // 0 if nothing is known
    };
    bool is_enough = false;
    if (region.components == 2)
      is_enough = improve([&](DualRegion& dual) { return add_strip_duals(dual, local, known, context_.deadline); });
    if (!is_enough) {
      is_enough = improve(
          [&](DualRegion& dual) { return add_cut_duals(dual, local, region.components, known, context_.deadline); });
    }
    if (!is_enough && region.components == 3 && !known.empty())
      is_enough = improve([&](DualRegion& dual) { return add_slit_duals(dual, local, known, context_.deadline); });
    if (!is_enough) improve([&](DualRegion& dual) { return add_duals_of_covers(dual, region, local); });
    if (best.tree.empty()) return {};
    for (Index& place : best.places) place = local.vertices[place];
    return best;
  }

  bool add_duals_of_covers(DualRegion& dual, const FaceRegion& region, const LocalRegion& local) const {
    const auto triangles = region_triangles(local.points, local.sides, kMaxTriangles, context_.deadline);
    if (!triangles) return false;
    const std::vector<Triangle> start = known_among(local, *triangles);
    add_cover_duals(dual,
                    {local.points, *triangles, local.boundary, region.triangle_count(), context_.deadline, start});
    return true;
  }

  // Of the region's open edges, by local numbers.
  [[nodiscard]] std::vector<Edge> known_edges(const DualRegion& outline, const LocalRegion& local) const {
    std::vector<Edge> result;
    for (const auto& [from, to] : outline.open_edges) {
      const Index a = outline.places[from], b = outline.places[to];
      const Edge edge = make_edge(local.vertices[a], local.vertices[b]);
      if (std::binary_search(known_edges_.begin(), known_edges_.end(), edge)) result.push_back(make_edge(a, b));
    }
    std::sort(result.begin(), result.end());
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
