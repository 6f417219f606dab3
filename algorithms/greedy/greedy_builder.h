// Turns a Delaunay triangulation into the greedy triangulation: the method of README.md.
#pragma once

#include <limits>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/faces.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/greedy/queue/candidate_queue.h"

namespace mwt {

/// One use. Invariant between steps: the mesh is the constrained Delaunay triangulation of the points with the edges of
/// kFixedMark as constraints.
class GreedyBuilder {
 public:
  /// Faces with more edges than `large_face` are made smaller first, for the cache's sake.
  GreedyBuilder(PlanarMesh& mesh, const Context& context, std::size_t large_face = 10'000)
      : mesh_(mesh),
        context_(context),
        order_(mesh.points(), mesh.labels()),
        sorted_(mesh, order_),
        heap_(order_),
        stars_(mesh),
        insertion_(mesh, stars_),
        faces_(mesh, order_, stars_, insertion_, context, large_face) {}

  GreedyCounters run();

 private:
  void fix_certain_edges();
  void solve();
  [[nodiscard]] bool stopped_early() const { return counters_.stopped_early || faces_.stopped_early(); }
  void start_queue();
  void empty_queue();
  void decide_order();
  void fetch_ahead(std::size_t next);
  void fetch_ears_ahead() const;

  [[nodiscard]] bool is_candidate(MeshEdge e) const;
  [[nodiscard]] bool faces_acute_angle(Halfedge h) const;
  [[nodiscard]] bool closes_ear(Halfedge h) const;
  [[nodiscard]] bool is_settled(MeshEdge e) const;
  [[nodiscard]] bool comes_first(MeshEdge e) const;
  void push_if_candidate(MeshEdge e);
  void push_candidates_around(MeshEdge e);
  void push_edge(MeshEdge e);
  void take_from_heap();

  void fix(MeshEdge e);
  void look_for_ear(const Wedge& wedge);
  void look_at_triangle(Halfedge side);
  [[nodiscard]] bool is_unblocked_ear(const Wedge& wedge);
  void insert_ear(const Candidate& ear);

  PlanarMesh& mesh_;
  const Context& context_;
  EdgeOrder order_;
  EdgeSorter sorted_;
  CandidateHeap heap_;
  FixedStars stars_;
  EarInsertion insertion_;
  Faces faces_;
  GreedyCounters counters_;
  std::uint64_t steps_ = 0;
  float min_squared_length_ = std::numeric_limits<float>::infinity();
  std::size_t fetched_ = 0;
};

}  // namespace mwt
