// Steps 4 to 6 of a proof: lower bounds on what the edges that are not certain weigh, region by region.
//
// An edge that is a candidate but not certain is open. Every minimum weight triangulation T consists of the certain
// edges and of open ones, so w(T) = w(certain edges) + w(open edges of T).
//
// The proof puts sides of certain edges (each has two, of which one lies outside for edges of the hull) and open edges
// into regions, each into one at most; the others are in region 0. Checked: the three sides of every empty triangle of
// candidates lie in one region, the triangle's.
//
// A region has a unit of length and dual values y, integers: one for each of its sides of certain edges; for an open
// edge ab one for each of its two sides, y(ab) = -y(ba). For a triangle t let r(t) be the sum over its three sides of h
// - y, where h is half the side's length in units, rounded down, if the edge is open, and 0 if it is certain. In T each
// side of a certain edge belongs to one triangle, and so do both sides of each open edge of T. Summed over the
// triangles of T in the region,
//     w(open edges of T in the region) >= sum of h = sum of y over sides of certain edges + sum of r(t)
//                                      >= sum of y over sides of certain edges + N min(0, min r(t)),
// N being the number of T's triangles in the region, or more, and the minimum running over all empty triangles of
// candidates in the region. (G. B. Dantzig, A. J. Hoffman, T. C. Hu 1985: y solves the dual of their linear program.)
// In region 0 all dual values are 0.
//
// A decision on an open edge e of the region divides the possibilities for T. Without e: no triangle has e as a side.
// With e: no triangle has a side that crosses e; and as both sides of e belong to one triangle each, both have dual
// values of their own, which count like those of sides of certain edges. A tree of decisions proves the least of what
// its leaves prove.
#pragma once

#include <cstdint>
#include <vector>

#include "verifier/bounds.h"
#include "verifier/point_tree.h"
#include "verifier/proof_reader.h"
#include "verifier/reductions.h"
#include "verifier/region.h"
#include "verifier/triangulation.h"

namespace mwt::verifier {

class Regions {
 public:
  /// All must stay alive, and the reductions may not go on.
  Regions(Points points, const PointTree& tree, const Reductions& reductions, const std::vector<Index>& hull);

  /// Reads the next region and checks what its dual values prove.
  void read(ProofReader& proof);

  /// After the last region: checks that no empty triangle has sides in different regions, and returns a lower bound on
  /// the weight of the open edges of every minimum weight triangulation. The triangulation serves to count triangles.
  [[nodiscard]] Bounds lower_bound(const std::vector<Corners>& triangulation) const;

  [[nodiscard]] std::size_t count() const { return outcomes_.size(); }

 private:
  using Label = std::uint32_t;  // the number of a region

  // A candidate in the star of one end, with the regions of its sides: left and right as seen from there.
  struct Spoke {
    Index to;
    Label left = 0;
    Label right = 0;
  };
  struct Outcome {
    long unit_exponent;
    std::vector<Leaf> leaves;
  };

  [[nodiscard]] const Spoke* find(Index from, Index to) const;
  [[nodiscard]] Spoke* find(Index from, Index to);
  void label_side(const Side& side, Label label);
  void label_open_edge(const OpenEdge& edge, Label label);
  void check_labels_of_triangles() const;
  [[nodiscard]] std::vector<std::uint64_t> count_triangles(const std::vector<Corners>& triangulation) const;

  Points points_;
  const PointTree& tree_;
  const Reductions& reductions_;
  std::vector<Index> next_on_hull_;  // by point
  std::vector<std::vector<Spoke>> stars_;
  std::vector<Outcome> outcomes_;  // of regions 1, 2, ...
};

}  // namespace mwt::verifier
