// Steps 2 and 3 of a proof: edges that leave the candidates, and edges that are certain.
#pragma once

#include <vector>

#include "verifier/bounds.h"
#include "verifier/edge_set.h"
#include "verifier/point_tree.h"

namespace mwt::verifier {

/// What is proved so far. Invariant: every minimum weight triangulation consists of candidates and contains all certain
/// edges. Each function below keeps it, or throws Refused and says why the step does not follow.
///
/// Deletions of edges that are no candidates any more, and marks of edges that are certain already, need no reason:
/// they change nothing.
class Reductions {
 public:
  /// Begins with the candidates of diamond_candidates() and the hull (counter-clockwise, with all points on it), whose
  /// edges every triangulation contains.
  Reductions(Points points, const PointTree& tree, EdgeSet candidates, const std::vector<Index>& hull);

  [[nodiscard]] const EdgeSet& candidates() const { return candidates_; }
  [[nodiscard]] const EdgeSet& certain() const { return certain_; }

  /// The edge is not locally minimal: each pair of empty triangles of candidates on its two sides makes a strictly
  /// convex quadrilateral whose other diagonal is shorter, so that a flip would shorten any triangulation with the edge
  /// (M. T. Dickerson, M. H. Montague 1996).
  void remove_not_minimal(Index a, Index b);

  /// The edge crosses a certain one.
  void remove_crossing(Index a, Index b, Index certain_a, Index certain_b);

  /// No candidate that is a side of an empty triangle of candidates with corner a crosses the edge, or the same holds
  /// for b: a triangulation without the edge would have such a triangle where the edge leaves that end.
  void mark_uncrossed(Index a, Index b);

  /// No point sees the edge at an angle of more than arcsin(1 / 1.17682): it belongs to the beta-skeleton, which is
  /// part of every minimum weight triangulation (S.-W. Cheng, Y.-F. Xu 2001).
  void mark_beta_skeleton(Index a, Index b);

  [[nodiscard]] Bounds weight_of_certain() const;

  /// A lower bound on the weight of every triangulation that consists of candidates: inner points have three edges at
  /// least, those on the hull two, and each edge two ends.
  [[nodiscard]] Bounds bound_by_degrees(const std::vector<Index>& hull) const;

 private:
  [[nodiscard]] bool is_empty(Index a, Index b, Index c) const { return tree_.is_empty(a, b, c); }
  [[nodiscard]] bool is_flippable(Index a, Index b, Index left, Index right) const;
  [[nodiscard]] bool is_interrupted(Index a, Index b) const;
  [[nodiscard]] bool is_crossed_near(Index s, Index t) const;

  Points points_;
  const PointTree& tree_;
  EdgeSet candidates_;
  EdgeSet certain_;
  std::vector<Index> left_, right_, common_;  // space for remove_not_minimal()
};

}  // namespace mwt::verifier
