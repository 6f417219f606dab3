// The linear relaxation of the Boolean model, with bounds that hold whatever the simplex method's rounding.
#pragma once

#include <span>
#include <vector>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/boolean_model/model_search.h"
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

  /// A lower bound on the length, in units, of every model. Stops when it reaches `enough`.
  ///
  /// Any multipliers of the rows give one: their right sides, less what edges of negative reduced cost could save. The
  /// simplex method's are made better by solving for the reduced costs, enlarged, again.
  [[nodiscard]] double solve(double enough);

  /// What is certain, by the best multipliers so far, of the edges of models shorter than `limit`, in units: choosing
  /// an edge, or not choosing it, costs at least its reduced cost more than the bound.
  [[nodiscard]] std::vector<ModelEdge> fixed_edges(double limit) const;

  /// In the last solution.
  [[nodiscard]] double use(std::uint32_t edge) const { return use_[edge]; }
  [[nodiscard]] std::uint64_t programs() const { return programs_; }

 private:
  enum class Sense { equal, at_least, at_most };
  struct Row {
    std::vector<std::uint32_t> edges;
    double right_side;
    Sense sense;
  };
  struct Bound {
    double lower;
    double worst;  // the least reduced cost, at most 0
    double error;  // of any reduced cost, and of the bound
  };

  int add_row(const Row& row);
  bool optimise(LinearProgram::Method method, double scale);
  [[nodiscard]] Bound bound() const;
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
  std::vector<double> use_;
  Bound best_{0, 0, 0};
  std::vector<DoubleDouble> best_reduced_cost_;  // by edge; none before the first bound
  std::uint64_t programs_ = 0;
};

}  // namespace mwt
