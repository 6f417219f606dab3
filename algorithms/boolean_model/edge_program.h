// The linear relaxation of the Boolean model, with bounds that hold whatever the simplex method's rounding.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/triangle_lp/linear_program.h"
#include "geometry/numbers/double_double.h"

namespace mwt {

/// Minimise the length of the chosen edges x, 0 <= x <= 1, subject to
///   - sum of x = the model's size;
///   - for every edge, it or one that crosses it is chosen (x_e + sum over f crossing e of x_f >= 1): implied, for a
///     set that can be extended is not the largest;
///   - for sets of edges that all cross each other, at most one is chosen: from the model's clauses, those that the
///     solution at hand violates, joined to cliques.
class EdgeProgram {
 public:
  /// `unit` is a power of two by which lengths are divided. All must stay alive.
  EdgeProgram(Points points, const CrossingModel& model, double unit, const Deadline& deadline);

  /// Forces an edge in (true) or out, or takes that back.
  void decide(std::uint32_t edge, std::optional<bool> decision);

  /// A lower bound on the length, in units, of every model that obeys the decisions. Stops when it reaches `enough`.
  ///
  /// Any multipliers of the rows give one: their right sides, less what edges of negative reduced cost could save. The
  /// simplex method's are made better by solving for the reduced costs, enlarged, again.
  [[nodiscard]] double solve(double enough);

  /// The edge that the last solution leaves most undecided; nothing if it is whole or there is none.
  [[nodiscard]] std::optional<std::uint32_t> fractional_edge() const;

  [[nodiscard]] double use(std::uint32_t edge) const { return use_[edge]; }
  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  enum class Sense { equal, at_least, at_most };
  struct Row {
    std::vector<std::uint32_t> edges;
    double right_side;
    Sense sense;
    bool is_active;  // decisions come and go
  };

  int add_row(const Row& row);
  bool optimise(LinearProgram::Method method, double scale);
  [[nodiscard]] double bound(double& worst) const;
  [[nodiscard]] DoubleDouble reduced_cost(std::uint32_t edge) const;
  bool add_violated_cliques();

  const CrossingModel& model_;
  Deadline deadline_;
  LinearProgram program_;
  std::vector<DoubleDouble> cost_;  // by edge
  std::vector<Row> rows_;
  std::vector<int> slack_column_;                    // by row; -1 for equations
  std::vector<double> multiplier_;                   // by row
  std::vector<std::vector<std::uint32_t>> rows_of_;  // by edge
  std::vector<int> decision_row_;                    // by edge; -1 if there is none yet
  std::vector<double> use_;
  std::vector<std::optional<bool>> decisions_;
  std::uint64_t programs_ = 0;
};

}  // namespace mwt
