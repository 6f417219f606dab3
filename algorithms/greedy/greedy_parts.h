// What the stages of greedy work on together.
#pragma once

namespace mwt {

class Context;
class EarInsertion;
class EdgeOrder;
class FixedStars;
class PlanarMesh;

/// Of one run. Invariant between stages: the mesh is a Delaunay triangulation constrained by the edges of kFixedMark,
/// all of them greedy.
struct GreedyParts {
  PlanarMesh& mesh;
  const EdgeOrder& order;
  FixedStars& stars;
  EarInsertion& insertion;
  const Context& context;
};

}  // namespace mwt
