// Dual values of a region that was cut open: lower bounds on all its triangulations, whether they contain the cuts or
// not.
//
// Give every candidate a dual value y on one side and -y on the other. For a triangle t let r(t) be half the length of
// its sides that are no boundary edges, less the dual values of its sides towards t. A triangulation's length is the
// dual value of the boundary plus the sum of its r(t) (G. B. Dantzig, A. J. Hoffman, T. C. Hu, Math. Programming 31
// (1985)).
//
// The program of the cut-open polygon gives dual values: a chord's value less half its length towards the part that it
// cuts off. Then r >= 0 for every triangle whose sides cross no cut: it is the program's recursion. The boundary's dual
// value is the value of the whole, without the cuts' lengths. What is missing comes from two kinds of triangles:
//   (1) a triangle with a side that crosses a cut ("loose"): the dual values of these sides are balanced until no loose
//       triangle, or hardly any, has r < 0;
//   (2) at either end of a cut c, c is in the triangulation, or one triangle there contains its first piece. If all of
//       these triangles at one end have r >= u, and at the other r >= v, and u + v <= |c|, then u + v may be taken from
//       all of them and from |c|, which is what r charges for c as a side, and added to the bound. What a triangle has
//       paid is gone: no triangle pays twice.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "algorithms/deadline.h"
#include "algorithms/exact/holes/cut_polygon.h"
#include "algorithms/exact/holes/loose_triangles.h"

namespace mwt {

/// Improves the bound and removes candidates that no triangulation within reach of an upper bound contains.
class CutDuals {
 public:
  /// `polygon` must stay alive. Its program must have a triangulation.
  explicit CutDuals(const CutPolygon& polygon);

  /// LooseTriangles::find(): nothing else may be called if this fails.
  [[nodiscard]] bool find_loose_triangles(std::size_t limit, const Deadline& deadline);

  /// One round: balances dual values, charges cuts. The bound only rises.
  void improve(const Deadline& deadline);

  /// Certified: no triangulation of the region by candidates has a smaller total length of diagonals, cuts included.
  [[nodiscard]] double lower_bound() const { return lower_bound_; }

  /// Removes the candidates that by the dual values are in no triangulation of total length `upper` or less; returns
  /// how many. `with_chords`: looks at chords too, which takes as long as the polygon's program.
  std::size_t remove_expensive(double upper, bool with_chords);

  /// Of candidates, by halfedge of polygon.graph.
  [[nodiscard]] bool is_alive(std::uint32_t halfedge) const { return is_alive_[halfedge]; }

  /// Whether every triangulation of the region of total length `upper` or less contains the cut.
  [[nodiscard]] bool is_certain(std::size_t cut, double upper) const;

  [[nodiscard]] std::size_t loose_triangles() const { return loose_.size(); }
  [[nodiscard]] std::size_t alive_crossing() const { return loose_.crossing().size(); }

 private:
  using Number = LooseTriangles::Number;

  void set_costs();
  [[nodiscard]] double reduced_cost(Number triangle) const;
  [[nodiscard]] double min_of(std::span<const Number> triangles) const;
  [[nodiscard]] double min_left_of(std::uint32_t halfedge) const { return min_of(loose_.left_of(halfedge)); }
  [[nodiscard]] double min_at(std::size_t cut, std::size_t end) const { return min_of(loose_.straddling(cut, end)); }
  double balance_once();
  void charge(std::size_t cut);
  void update_lower_bound();
  void kill(std::uint32_t halfedge);
  void drop_dead_triangles();
  std::size_t remove_expensive_crossing(double gap);
  std::size_t remove_expensive_chords(double gap);

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  const CutPolygon& polygon_;
  LooseTriangles loose_;
  std::vector<double> paid_by_;              // by loose triangle: for cuts
  std::vector<double> length_;               // by halfedge
  std::vector<double> cost_;                 // by halfedge: its part of r of the triangle on its left
  std::vector<bool> is_alive_;               // by halfedge
  std::vector<std::uint32_t> cut_halfedge_;  // by cut, from its smaller end
  std::vector<double> unpaid_;               // by cut: of its length
  double paid_ = 0;
  double value_ = 0;        // of the whole polygon, rounded down
  double error_ = 0;        // of a reduced cost
  double bound_ = 0;        // by the present dual values: what reduced costs add to
  double lower_bound_ = 0;  // the best one so far
};

}  // namespace mwt
