// Dual values of a cover model as integers, which sums and comparisons do not round.
#pragma once

#include <cstdint>
#include <vector>

#include "algorithms/common/rows.h"
#include "algorithms/triangle_lp/cover_model.h"

namespace mwt {

/// Integer dual values for one set of decisions after the other. In contrast to the model's, sides of the boundary cost
/// nothing: their dual values are less by what they cost there.
class IntegerDuals {
 public:
  /// A model's unit of length is 2^shift units here. Both must stay alive; the points are those of the model's edges.
  IntegerDuals(const CoverModel& model, Points points, int shift);

  /// Rounds dual values, mends what that spoils where one side can give to the other, and lets boundary sides take what
  /// is left to them.
  void round(const CoverDuals& duals);

  /// Below 2^59 in magnitude.
  [[nodiscard]] std::int64_t of(Side side) const { return dual_[side]; }

  /// What they prove, in units: the dual values of the boundary and of edges that must be in, and for every triangle
  /// the worst reduced cost. At least 0.
  [[nodiscard]] std::int64_t bound() const;

 private:
  using Column = std::uint32_t;

  [[nodiscard]] std::int64_t reduced_cost(Column column) const;
  [[nodiscard]] std::int64_t least(Side side) const;
  [[nodiscard]] bool is_covered_once(Side side) const;
  void find_usable_columns();
  void balance(std::uint32_t edge);
  void take_what_is_left(Side side);

  const CoverModel& model_;
  Points points_;
  int shift_;
  std::vector<std::int64_t> half_;  // by edge; 0 on the boundary
  std::vector<std::int64_t> dual_;
  std::vector<EdgeDecision> decisions_;
  std::vector<std::uint8_t> is_usable_;  // by column: no decision excludes it
  Rows<Column> columns_;                 // by side
};

}  // namespace mwt
