// The linear program of a cover model by column generation, with bounds that hold whatever the simplex method's
// rounding.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/triangle_lp/cover_model.h"
#include "algorithms/triangle_lp/linear_program.h"

namespace mwt {

/// So few columns need no selection.
inline constexpr std::size_t kFewColumns = 500;

/// Columns to begin with: those of a known cover, if there is one, and `per_triangle` times as many as a cover has
/// triangles, but kFewColumns at least: those whose reduced cost is the smallest part of their cost. Relative, or a
/// dense cluster's triangles would leave no place to others. A column may come twice.
[[nodiscard]] std::vector<std::uint32_t> promising_columns(const CoverModel& model, const CoverDuals& duals,
                                                           std::span<const Triangle> known, std::size_t per_triangle);

/// The relaxation x >= 0 of a cover model, restricted to some columns at first, with decisions on edges for branching.
///
/// Besides the triangles there is the empty cover, a variable for covering nothing: it makes every
/// restriction feasible, and costs so much that it is only used where no cover obeys the decisions.
class CoverProgram {
 public:
  /// Begins with `duals` as the dual solution and with `first_columns`.
  CoverProgram(const CoverModel& model, CoverDuals duals, std::span<const std::uint32_t> first_columns,
               const Deadline& deadline);

  /// Forces an inner edge into the covers or out of them, or takes that back.
  void decide(std::uint32_t edge, EdgeDecision decision);

  /// Solves the relaxation and returns a certified lower bound on all covers that obey the decisions, in the model's
  /// unit. Stops as soon as the bound reaches `enough`, and after `max_rounds` programs.
  ///
  /// Column generation and the refinement of the dual values are one loop: all columns are priced with certified
  /// arithmetic; violated ones join; then the reduced costs, multiplied so that the worst becomes about -1, are the
  /// next objective, and its duals improve the dual values by that much smaller steps (A. M. Gleixner, D. E. Steffy, K.
  /// Wolter, "Iterative refinement for linear programming", INFORMS Journal on Computing 28, 2016).
  [[nodiscard]] double solve(double enough, int max_rounds = std::numeric_limits<int>::max());

  /// Whether the last solve() ended with a solution; otherwise numerical trouble or the deadline prevented it.
  [[nodiscard]] bool solved() const { return solved_; }

  /// The last solution's triangles if they are a cover: verified by counting sides, not by rounding.
  [[nodiscard]] std::optional<std::vector<Triangle>> cover() const;

  /// The open inner edge to branch on, if the last solution uses any in part: long and far from whole, as deciding such
  /// an edge changes most.
  [[nodiscard]] std::optional<std::uint32_t> fractional_edge() const;

  /// The dual values behind the largest bound of the last solve().
  [[nodiscard]] const CoverDuals& best_duals() const { return best_duals_; }

  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  static constexpr int kEmptyCover = 0;  // its column in the program
  static constexpr int kNone = -1;

  void add_column(std::uint32_t column);
  bool add_violated_columns(std::vector<PricedColumn> violated);
  int row_of_inner_edge(std::uint32_t edge);
  void update_empty_cover();
  bool optimise(LinearProgram::Method method, double scale);
  [[nodiscard]] double max_useful_cost(double scale) const;
  void set_reduced_costs(double scale);
  void add_program_duals(double scale);
  [[nodiscard]] double primal_value() const;
  [[nodiscard]] std::vector<double> edge_use() const;

  const CoverModel& model_;
  Deadline deadline_;
  LinearProgram program_;
  CoverDuals duals_;
  CoverDuals best_duals_;
  CoverPricing pricing_;
  double empty_cover_cost_;
  std::vector<std::uint32_t> active_;    // the candidate of each program column after the empty cover
  std::vector<std::uint8_t> is_active_;  // by candidate
  std::vector<int> boundary_row_;        // by side: covered once
  std::vector<int> balance_row_;         // by inner edge: covered as often from the left as from the right
  std::vector<int> decision_row_;        // by inner edge: how often its forward side is covered
  std::vector<double> decision_dual_;    // by inner edge
  std::uint64_t programs_ = 0;
  bool solved_ = false;
};

}  // namespace mwt
