#include "algorithms/patch/patch.h"

#include <algorithm>
#include <array>
#include <vector>

#include "algorithms/patch/patch_polygon.h"
#include "algorithms/start/start.h"
#include "algorithms/start/walls.h"
#include "geometry/error.h"

namespace mwt {

namespace {

constexpr std::array<std::uint32_t, 2> kQueuedMarks = {512, 1024};  // the triangle of this smallest halfedge waits

class PatchSearch {
 public:
  PatchSearch(PlanarMesh& mesh, const PatchOptions& options, const Context& context)
      : mesh_(mesh), options_(options), context_(context), polygon_(mesh, options.k) {}

  PatchResult run() {
    for (Halfedge h = 0; h < 2 * mesh_.edge_count(); ++h) {
      if (!is_outer(h) && name_of_triangle(h) == h) enqueue(h);
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

  [[nodiscard]] Halfedge name_of_triangle(Halfedge h) const {
    return std::min(h, std::min(mesh_.next(h), mesh_.previous(h)));
  }

  void enqueue(Halfedge h) {
    const Halfedge name = name_of_triangle(h);
    std::uint32_t& marks = mesh_.marks(edge_of(name));
    if ((marks & kQueuedMarks[name & 1]) != 0) return;
    marks |= kQueuedMarks[name & 1];
    queue_.push_back(name);
  }

  void unqueue(Halfedge h) { mesh_.marks(edge_of(h)) &= ~kQueuedMarks[h & 1]; }

  void try_patch(Halfedge h) {
    polygon_.grow(h, options_.k, options_.walls ? kWallMark : 0);
    ++result_.patches;
    // No patch reaches beyond an enclosed one, and this one will be optimal: nothing is left to do for its triangles.
    if (polygon_.is_enclosed()) {
      for (const Halfedge triangle : polygon_.triangles()) unqueue(triangle);
    }
    if (!polygon_.improve()) return;
    ++result_.improved;
    if (polygon_.is_enclosed()) return;
    for (const Halfedge side : polygon_.boundary()) {
      enqueue(side);
      if (!is_outer(twin(side))) enqueue(twin(side));
    }
    for (const MeshEdge e : polygon_.inner()) enqueue(2 * e);
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
  std::vector<Halfedge> queue_;
  PatchResult result_;
};

PatchOptions options_of(const Parameters& parameters) {
  PatchOptions options;
  const std::int64_t k = parameters.integer("k"), passes = parameters.integer("passes");
  if (k < 2 || k > kLargestPatch) {
    throw InputError("patch: k=" + std::to_string(k) + " is not between 2 and " + std::to_string(kLargestPatch));
  }
  if (passes < 0 || passes > 1'000'000)
    throw InputError("patch: passes=" + std::to_string(passes) + " is not between 0 and 1000000");
  options.k = static_cast<int>(k);
  options.passes = static_cast<int>(passes);
  options.walls = parameters.text("walls") == "on";
  return options;
}

Solution run_patch(Points points, Context& context) {
  const PatchOptions options = options_of(context.parameters);
  const auto start = [&] {
    const ScopedPhase phase(context, "start");
    return options.walls ? start_mesh_with_walls(points, context) : start_mesh(points, context);
  };
  PlanarMesh mesh = start();
  const ScopedPhase phase(context, "patch");
  const PatchResult result = improve_by_patches(mesh, options, context);
  Solution solution;
  solution.triangulation = mesh.triangulation();
  solution.counters = {{"patches", static_cast<double>(result.patches)},
                       {"improved", static_cast<double>(result.improved)}};
  solution.stopped_early = result.stopped_early;
  return solution;
}

}  // namespace

PatchResult improve_by_patches(PlanarMesh& mesh, const PatchOptions& options, const Context& context) {
  return PatchSearch(mesh, options, context).run();
}

AlgorithmInfo patch_entry() {
  AlgorithmInfo info;
  info.name = "patch";
  info.summary = "re-triangulates patches of k triangles optimally until none improves (large-neighbourhood search)";
  info.source =
      "this project; sub-solver: G. T. Klincsek, Minimal triangulations of polygonal domains (1980); walls: S.-W. "
      "Cheng, "
      "Y.-F. Xu, On beta-skeleton as a subgraph of the minimum weight triangulation (2001)";
  info.guarantee =
      "never worse than its start: with start=greedy the O(sqrt n) of greedy (Levcopoulos, Krznaric 1998); optimal if "
      "one "
      "patch covers a convex polygon";
  info.time = "O(n k^3) per pass; a few passes in practice";
  info.space = "O(n + k^2)";
  info.largest_n = 10'000'000;
  info.parameters = {
      {"k", ParameterType::integer, "6", "triangles per patch, 2 to 128"},
      start_parameter("greedy"),
      {"walls",
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
