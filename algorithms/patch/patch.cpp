#include "algorithms/patch/patch.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <vector>

#include "algorithms/common/beta_skeleton_edges.h"
#include "algorithms/common/start.h"
#include "algorithms/patch/patch_polygon.h"
#include "algorithms/step_trace.h"
#include "base/error.h"
#include "geometry/mesh/distance.h"

namespace mwt {

namespace {

constexpr std::array<std::uint32_t, 2> kQueuedMarks = {512, 1024};  // the triangle of this smallest halfedge is queued

Halfedge name_of_triangle(const PlanarMesh& mesh, Halfedge h) {
  return std::min(h, std::min(mesh.next(h), mesh.previous(h)));
}

float longest_side(const PlanarMesh& mesh, Halfedge h) {
  const auto squared = [&](Halfedge side) { return mesh.record(edge_of(side)).squared_length; };
  return std::max(squared(h), std::max(squared(mesh.next(h)), squared(mesh.previous(h))));
}

// The squared length that one edge in `share` reaches.
float long_squared_length(const PlanarMesh& mesh, std::size_t share) {
  std::vector<float> lengths(mesh.edge_count());
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) lengths[e] = mesh.record(e).squared_length;
  const auto place = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / share);
  std::nth_element(lengths.begin(), place, lengths.end(), std::greater<float>());
  return *place;
}

double length_in_mesh(const PlanarMesh& mesh, const Edge& edge) {
  return rounded_distance(mesh.point(edge.a), mesh.point(edge.b));
}

// What the last improvement changed.
TracedPatch traced_patch(const PlanarMesh& mesh, const PatchPolygon& polygon) {
  std::vector<Edge> before = polygon.present(), after;
  for (const MeshEdge e : polygon.inner()) after.push_back(make_edge(mesh.origin(2 * e), mesh.target(2 * e)));
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  const auto in_caller = [&](const Edge& edge) { return make_edge(mesh.label(edge.a), mesh.label(edge.b)); };
  TracedPatch traced;
  for (const Edge& edge : before) {
    if (std::binary_search(after.begin(), after.end(), edge)) continue;
    traced.removed.push_back(in_caller(edge));
    traced.gain += length_in_mesh(mesh, edge) * mesh.unit();
  }
  for (const Edge& edge : after) {
    if (std::binary_search(before.begin(), before.end(), edge)) continue;
    traced.added.push_back(in_caller(edge));
    traced.gain -= length_in_mesh(mesh, edge) * mesh.unit();
  }
  return traced;
}

class PatchSearch {
 public:
  PatchSearch(PlanarMesh& mesh, const PatchOptions& options, const Context& context)
      : mesh_(mesh), options_(options), context_(context), polygon_(mesh, options.k) {}

  /// Only patches at triangles with a side of at least this squared length.
  PatchResult run(float min_squared_length) {
    min_squared_length_ = min_squared_length;
    for (MeshEdge e = 0; e < mesh_.edge_count(); ++e) {
      if (mesh_.record(e).squared_length < min_squared_length) continue;
      enqueue(2 * e);
      if (!is_outer(2 * e + 1)) enqueue(2 * e + 1);
    }
    for (int pass = 0; !queue_.empty() && (options_.passes == 0 || pass < options_.passes); ++pass) {
      std::vector<Halfedge> round;
      round.swap(queue_);
      for (const Halfedge h : round) {
        if ((mesh_.marks(edge_of(h)) & kQueuedMarks[h & 1]) == 0) continue;
        unqueue(h);
        if (out_of_time()) return clean_up();
        try_patch(h);
      }
    }
    return clean_up();
  }

 private:
  [[nodiscard]] bool is_outer(Halfedge h) const { return (h & 1) == 1 && mesh_.is_hull(edge_of(h)); }

  void enqueue(Halfedge h) {
    const Halfedge name = name_of_triangle(mesh_, h);
    if (longest_side(mesh_, name) < min_squared_length_) return;
    std::uint32_t& marks = mesh_.marks(edge_of(name));
    if ((marks & kQueuedMarks[name & 1]) != 0) return;
    marks |= kQueuedMarks[name & 1];
    queue_.push_back(name);
  }

  void unqueue(Halfedge h) { mesh_.marks(edge_of(h)) &= ~kQueuedMarks[h & 1]; }

  void try_patch(Halfedge h) {
    polygon_.grow(h, options_.k, options_.beta_skeleton ? kBetaSkeletonMark : 0);
    if (is_known_to_fail()) return;
    ++result_.patches;
    // No patch reaches beyond an enclosed one, and this one will be optimal: nothing is left to do for its triangles.
    if (polygon_.is_enclosed()) {
      for (const Halfedge triangle : polygon_.triangles()) unqueue(triangle);
    }
    if (!polygon_.improve()) return;
    ++result_.improved;
    if (context_.steps != nullptr) context_.steps->patches.push_back(traced_patch(mesh_, polygon_));
    failed_.fill(0);
    if (polygon_.is_enclosed()) return;
    for (const Halfedge side : polygon_.boundary()) {
      enqueue(side);
      if (!is_outer(twin(side))) enqueue(twin(side));
    }
    for (const MeshEdge e : polygon_.inner()) enqueue(2 * e);
  }

  // Whether a patch of the same triangles was tried since the last improvement, as one in five was; records
  // this one. A collision of 64-bit sums would spare a patch that another start may still find.
  bool is_known_to_fail() {
    std::uint64_t sum = 0;
    for (const std::uint64_t triangle : polygon_.triangles()) {
      const std::uint64_t mixed = (triangle + 1) * 0x9e3779b97f4a7c15ULL;
      sum += (mixed ^ (mixed >> 29)) * 0xbf58476d1ce4e5b9ULL;
    }
    std::uint64_t& place = failed_[sum >> (64 - kFailedBits)];
    const bool is_known = place == sum;
    place = sum;
    return is_known;
  }

  bool out_of_time() {
    if (result_.patches % 64 == 0 && context_.deadline_passed()) result_.stopped_early = true;
    return result_.stopped_early;
  }

  PatchResult clean_up() {
    mesh_.clear_marks(kQueuedMarks[0] | kQueuedMarks[1]);
    return result_;
  }

  PlanarMesh& mesh_;
  PatchOptions options_;
  const Context& context_;
  PatchPolygon polygon_;
  float min_squared_length_ = 0;
  static constexpr int kFailedBits = 8;
  std::array<std::uint64_t, 1U << kFailedBits> failed_{};
  std::vector<Halfedge> queue_;
  PatchResult result_;
};

PatchOptions options_of(const Parameters& parameters) {
  PatchOptions options;
  const std::int64_t k = parameters.integer("k"), passes = parameters.integer("passes");
  if (k < 2 || k > kMaxPatch) {
    throw InputError(fmt::format("patch: k={} is not between 2 and {}", k, kMaxPatch));
  }
  if (passes < 0 || passes > 1'000'000)
    throw InputError(fmt::format("patch: passes={} is not between 0 and 1000000", passes));
  const std::int64_t long_k = parameters.integer("long_k");
  if (long_k < 0 || long_k > kMaxPatch) {
    throw InputError(fmt::format("patch: long_k={} is not between 0 and {}", long_k, kMaxPatch));
  }
  options.k = static_cast<int>(k);
  options.long_k = static_cast<int>(long_k == 0 ? std::min<std::int64_t>(4 * k, kMaxPatch) : long_k);
  options.passes = static_cast<int>(passes);
  options.beta_skeleton = parameters.text("beta_skeleton") == "on";
  return options;
}

Solution run_patch(Points points, Context& context) {
  const PatchOptions options = options_of(context.parameters);
  const auto start = [&] {
    const ScopedPhase phase(context, "start");
    return options.beta_skeleton ? start_mesh_with_beta_skeleton(points, context) : start_mesh(points, context);
  };
  PlanarMesh mesh = start();
  if (context.steps != nullptr) context.steps->start = mesh.triangulation().triangles;
  const ScopedPhase phase(context, "patch");
  const PatchResult result = improve_by_patches(mesh, options, context);
  Solution solution;
  solution.triangulation = mesh.triangulation();
  solution.counters = {{"patches", static_cast<double>(result.patches)},
                       {"improved", static_cast<double>(result.improved)}};
  solution.stop_reason = deadline_if(result.stopped_early);
  return solution;
}

}  // namespace

PatchResult improve_by_patches(PlanarMesh& mesh, const PatchOptions& options, const Context& context) {
  PatchResult result = PatchSearch(mesh, options, context).run(0);
  if (options.long_k <= options.k || result.stopped_early) return result;
  constexpr std::size_t kLongShare = 500;
  PatchOptions of_long = options;
  of_long.k = options.long_k;
  const PatchResult last = PatchSearch(mesh, of_long, context).run(long_squared_length(mesh, kLongShare));
  return {result.patches + last.patches, result.improved + last.improved, last.stopped_early};
}

AlgorithmInfo patch_entry() {
  AlgorithmInfo info;
  info.name = "patch";
  info.summary = "re-triangulates patches of k triangles optimally until none improves (large-neighbourhood search)";
  info.source =
      "this project; sub-solver: G. T. Klincsek, Minimal triangulations of polygonal domains (1980); beta-skeleton "
      "edges: S.-W. Cheng, Y.-F. Xu, On beta-skeleton as a subgraph of the minimum weight triangulation (2001)";
  info.guarantee =
      "never worse than its start: with start=greedy the O(sqrt n) of greedy (Levcopoulos, Krznaric 1998); optimal if "
      "one patch covers a convex polygon";
  info.version = 3;
  info.time = "O(n k^3) per pass; a few passes in practice";
  info.space = "O(n + k^2)";
  info.max_n = 10'000'000;
  info.has_steps = true;
  info.parameters = {
      {"k", ParameterType::integer, "6", "triangles per patch, 2 to 128"},
      {"long_k", ParameterType::integer, "0", "triangles per patch around the longest 0.2% of edges; 0: 4 k; 1: none"},
      start_parameter("greedy"),
      {"beta_skeleton",
       ParameterType::choice,
       "on",
       "whether patches stop at edges that every optimum contains",
       {"on", "off"}},
      {"passes", ParameterType::integer, "0", "rounds over the triangles at most; 0: until no patch improves"},
  };
  info.function = run_patch;
  return info;
}

}  // namespace mwt
