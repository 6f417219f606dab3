// Where local searches start: a triangulation by name, as a mesh that can be changed.
#pragma once

#include <string>

#include "algorithms/algorithm.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// The declaration of the parameter `start`, for the entries of local searches.
[[nodiscard]] ParameterInfo start_parameter(const std::string& default_value);

/// The triangulation that context.parameters.text("start") names:
///   delaunay, greedy   as the algorithms of those names;
///   sweep, quadtree, hull_insertion   as the algorithms of those names with their default parameters;
///   random             the Delaunay triangulation after 10 n random flips, seeded by context.seed;
///   anything else      a file, whose triangulation the caller has put into context.start.
/// InputError if there is none; NotApplicable as that algorithm throws it. Preconditions: as delaunay_triangulation().
/// Time as that algorithm takes.
[[nodiscard]] PlanarMesh start_mesh(Points points, const Context& context);

/// The same, with kBetaSkeletonMark (beta_skeleton_edges.h) on its edges that are beta-skeleton edges.
[[nodiscard]] PlanarMesh start_mesh_with_beta_skeleton(Points points, const Context& context);

/// Flips `count` random edges of the mesh where they can be flipped. Deterministic for a seed.
void flip_at_random(PlanarMesh& mesh, std::uint64_t seed, std::size_t count);

}  // namespace mwt
