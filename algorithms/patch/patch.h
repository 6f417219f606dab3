// Large-neighbourhood search: patches of a few triangles are re-triangulated optimally until none improves.
#pragma once

#include "algorithms/algorithm.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

struct PatchOptions {
  int k = 6;                  ///< triangles per patch, 2 .. kMaxPatch
  int long_k = 0;             ///< if more than k: as many, in the end, around the longest edges
  int passes = 0;             ///< rounds at most; 0: until no patch improves
  bool beta_skeleton = true;  ///< whether patches stop at edges with kBetaSkeletonMark (common/beta_skeleton_edges.h)
};

inline constexpr int kMaxPatch = 128;

struct PatchResult {
  std::size_t patches = 0;   ///< re-triangulated
  std::size_t improved = 0;  ///< of these, replaced by something certainly shorter
  bool stopped_early = false;
};

/// Shortens the triangulation patch by patch. Around every triangle the k triangles nearest in the dual graph are
/// taken; they form a weakly simple polygon of at most k + 2 corners (edges between two of them that breadth-first
/// search did not cross are kept as slits), which dynamic programming triangulates optimally in O(k^3). Triangles
/// around an improvement are looked at again in the next round. In the end, patches of long_k triangles at the longest
/// 0.2% of the edges: between clusters few edges carry much of the weight, and small patches do not reach far enough.
///
/// Why positive triangles suffice: they have the same oriented boundary as the patch, so they cover every place of it
/// exactly once; no test for visibility is needed.
/// A patch is replaced only if the new edges are shorter for certain (rounding accounted for, double-double near
/// ties): the result is never longer than the start. Obeys the deadline of `context`. O(n k^3) per round.
/// Deterministic.
PatchResult improve_by_patches(PlanarMesh& mesh, const PatchOptions& options, const Context& context);

[[nodiscard]] AlgorithmInfo patch_entry();

}  // namespace mwt
