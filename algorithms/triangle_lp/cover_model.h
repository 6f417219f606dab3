// The Dantzig-Hoffman-Hu model of a region, and certified pricing: what dual values on sides prove about every cover.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "algorithms/triangle_lp/triangle_cover.h"
#include "geometry/numbers/double_double.h"

namespace mwt {

/// A directed edge: 2 e is edge e of CoverModel::edges from a to b, 2 e + 1 from b to a.
using Side = std::uint32_t;

[[nodiscard]] inline std::uint32_t edge_of(Side side) { return side / 2; }
[[nodiscard]] inline Side forward_side(std::uint32_t edge) { return 2 * edge; }
[[nodiscard]] inline Side backward_side(std::uint32_t edge) { return 2 * edge + 1; }
[[nodiscard]] inline Side reversed(Side side) { return side ^ 1U; }

/// The candidate triangles and their sides with costs. The unit of length is a power of two near the longest edge, so
/// that neither tiny nor huge coordinates come near the limits of doubles.
struct CoverModel {
  struct Column {
    Triangle triangle;
    std::array<Side, 3> sides;
  };

  explicit CoverModel(const TriangleCoverProblem& problem);

  std::vector<Edge> edges;      ///< sides of columns and of the boundary, in order of appearance
  std::vector<Column> columns;  ///< the candidates, less those right of a one-way boundary edge: no cover has them
  std::vector<DoubleDouble> side_cost;    ///< by side: half the edge's length, all of it on a one-way boundary edge
  std::vector<std::uint8_t> on_boundary;  ///< by side
  std::size_t triangle_count = 0;         ///< of every cover
  double max_cover_cost = 0;              ///< no cover costs more
  int exponent = 0;                       ///< the unit of length is 2^exponent

  [[nodiscard]] bool is_inner(std::uint32_t edge) const {
    return !on_boundary[forward_side(edge)] && !on_boundary[backward_side(edge)];
  }
  [[nodiscard]] double cost(const Column& column) const;  ///< rounded
};

/// Whether an inner edge may be in the cover, must be or must not be.
enum class EdgeDecision : std::uint8_t { open, in, out };

/// A dual solution: a value per side, subtracted from the cost of each triangle that has the side. Open inner edges
/// have opposite dual values on their sides, so that the dual values of a cover's sides add up to those of the boundary
/// and of both sides of the edges that must be in.
struct CoverDuals {
  std::vector<double> of_side;
  std::vector<EdgeDecision> decisions;  ///< by edge
};

/// A triangle's cost less the dual values of its sides, rounded from double-double.
[[nodiscard]] double reduced_cost(const CoverModel& model, const CoverDuals& duals, const CoverModel::Column& column);

/// The same rounded down, certified.
[[nodiscard]] double min_reduced_cost(const CoverModel& model, const CoverDuals& duals,
                                      const CoverModel::Column& column);

struct PricedColumn {
  std::uint32_t column;
  double reduced_cost;  ///< negative
};

struct CoverPricing {
  double lower = 0;  ///< certified: no cover that obeys the decisions costs less
  double dual = 0;   ///< rounded: what `lower` would be if no reduced cost were negative
  double worst = 0;  ///< certified: at most 0 and at most any reduced cost
  std::vector<PricedColumn> violated;
};

/// Prices every column. A cover has triangle_count triangles, each costing at least its dual values plus the worst
/// reduced cost, so
///   cost >= dual values of the boundary and of edges that must be in + triangle_count * worst,
/// whatever the dual values are and wherever they come from. Evaluated in doubles with an error bound, near zero in
/// double-double. O(columns).
[[nodiscard]] CoverPricing price(const CoverModel& model, const CoverDuals& duals);

}  // namespace mwt
