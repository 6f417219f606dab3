// How good a triangulation is, by certified bounds: optimum, alpha, optimality.
#pragma once

#include <optional>
#include <string_view>

#include "geometry/numbers/interval.h"

namespace mwt {

/// What is known about the weight of a minimum weight triangulation.
enum class Optimality {
  none,     ///< no certified lower bound
  bounded,  ///< certified bounds, further apart than `proved` allows
  proved,   ///< relative width at most kProvedRelativeWidth, upper end witnessed by a checked triangulation
};

[[nodiscard]] std::string_view name_of(Optimality optimality);
[[nodiscard]] Optimality optimality_of(const std::optional<Interval>& optimum);

/// The certified optimum that follows from a solver's bounds and the checked triangulation it returned: its weight is
/// the upper end, whatever bound the solver certified. Nothing without a positive finite lower bound.
/// `contradiction` is set when the lower bound exceeds the triangulation's weight.
struct WitnessedOptimum {
  std::optional<Interval> interval;
  bool contradiction = false;
};
[[nodiscard]] WitnessedOptimum witnessed_optimum(const std::optional<Interval>& claimed, const Interval& weight);

/// The interval that follows from two certified intervals of one number; nothing if they contradict each other.
[[nodiscard]] std::optional<Interval> intersection(const Interval& a, const Interval& b);

/// Quotients of positive numbers rounded down and up: the tightest doubles that are certainly bounds.
[[nodiscard]] double divide_down(double numerator, double denominator);
[[nodiscard]] double divide_up(double numerator, double denominator);

/// [max(1, weight.lower / optimum.upper), weight.upper / optimum.lower], rounded outwards.
/// Precondition: positive finite optimum, weight of a triangulation of the same points.
[[nodiscard]] Interval alpha_of(const Interval& weight, const Interval& optimum);

enum class Decision { no, yes, undecided };
[[nodiscard]] std::string_view name_of(Decision decision);

/// Whether a triangulation of this weight is optimal. yes: the optimum is proved and the weight's upper end is not
/// above the optimum's; no: even its lower end is above; undecided otherwise, or without a certified optimum.
[[nodiscard]] Decision is_optimal(const Interval& weight, const std::optional<Interval>& optimum);

}  // namespace mwt
