// Which edges of a face nothing can cross any more: bounds for the lengths of greedy edges that may yet come.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "algorithms/greedy/greedy_marks.h"
#include "geometry/mesh/planar_mesh.h"

namespace mwt {

/// For each edge of a face a number below which no greedy edge that crosses it has its squared length; infinite for
/// those that are certainly greedy. What can cross an edge is an ear at one of its ends (lemma 5 in PROOFS.md), so that
/// the stars of the vertices give the bounds (lemma 6).
///
/// Floating point with a margin, rounded towards crossings: an edge reported as greedy is greedy under any tie rule.
/// Preconditions of all: the mesh is a Delaunay triangulation constrained by the edges of kFixedMark, all greedy; the
/// edges of the face have kFaceMark, and no others outside kFixedMark have.
class CrossingBounds {
 public:
  explicit CrossingBounds(PlanarMesh& mesh) : mesh_(mesh) {}

  /// A guess, from a thousand edges, whether most edges of the face are certain. O(1).
  [[nodiscard]] bool is_promising(std::span<const MeshEdge> face);

  /// Finds the bounds; 4 bytes per edge of the mesh. False, and none found, if it takes more steps than that.
  [[nodiscard]] bool find(std::span<const MeshEdge> face, std::size_t max_steps_per_edge = 16);

  /// Whether e is certainly greedy. Precondition: e is of the face of the last find(), which succeeded.
  [[nodiscard]] bool is_certain(MeshEdge e) const { return bounds_[e] == kNeverCrossed; }

 private:
  static constexpr float kNeverCrossed = std::numeric_limits<float>::infinity();

  struct Spoke {
    Halfedge halfedge;
    double x, y;  // from the common origin
    double squared_length;
    double bound;  // from pairs of spokes
  };
  enum class Turn { left, right };
  /// Points in the directions between two vectors, no nearer than sqrt(`squared`). For turns to the right all is seen
  /// in a mirror: `near` is always met first by who turns left from `far`.
  struct Sight {
    Spoke far;
    Spoke near;
    double squared;
  };

  [[nodiscard]] bool may_be_crossed(Halfedge h) const {
    return !is_fixed(mesh_, h) && bounds_[edge_of(h)] != kNeverCrossed;
  }
  [[nodiscard]] Spoke spoke_to(Index apex, Index v, Turn turn) const;
  [[nodiscard]] Spoke spoke(Halfedge h, Turn turn = Turn::left) const;
  [[nodiscard]] Halfedge first_of_wedge(Halfedge h) const;
  void collect_wedge(Halfedge first);

  [[nodiscard]] bool seems_certain(MeshEdge e);
  void judge_star(Halfedge h);
  void judge_wedge();
  [[nodiscard]] bool judge_pairs();
  void judge_pair(std::size_t first, std::size_t last);
  [[nodiscard]] bool spread(std::size_t max_steps);
  void look_through(Halfedge window, Turn turn);
  [[nodiscard]] double beyond(Halfedge side, double squared) const;
  void look_past(const Sight& sight, Halfedge first, Turn turn);
  void give_up_star(Halfedge h);
  void collect_half_turn(const Sight& sight, Halfedge first, Turn turn);
  [[nodiscard]] double min_squared(const Sight& sight, std::size_t i, Turn turn) const;
  void lower(Halfedge h, double bound);
  void forget_lowered();

  PlanarMesh& mesh_;
  std::unique_ptr<float[]> bounds_;  // by edge, set for the edges of the face
  std::vector<bool> is_judged_;      // by vertex, for those of the face; no longer once given up
  std::vector<Spoke> spokes_;
  std::vector<std::size_t> by_length_;  // of spokes_, without the first and the last, from long to short
  KeptVector<MeshEdge> lowered_;        // those with kLoweredMark are waiting to be looked through again
  std::size_t steps_ = 0;
};

}  // namespace mwt
