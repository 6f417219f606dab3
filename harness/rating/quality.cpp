#include "harness/rating/quality.h"

#include <algorithm>
#include <cmath>

namespace mwt {

std::string_view name_of(Optimality optimality) {
  switch (optimality) {
    case Optimality::none: return "none";
    case Optimality::bounded: return "bounded";
    case Optimality::proved: return "proved";
  }
  return "none";
}

std::string_view name_of(Decision decision) {
  switch (decision) {
    case Decision::no: return "no";
    case Decision::yes: return "yes";
    case Decision::undecided: return "undecided";
  }
  return "undecided";
}

Optimality optimality_of(const std::optional<Interval>& optimum) {
  if (!optimum || !(optimum->lower > 0)) return Optimality::none;
  const double width = next_up(optimum->upper - optimum->lower);
  return width <= kProvedRelativeWidth * optimum->lower ? Optimality::proved : Optimality::bounded;
}

WitnessedOptimum witnessed_optimum(const std::optional<Interval>& claimed, const Interval& weight) {
  if (!claimed || !(claimed->lower > 0) || !std::isfinite(claimed->lower)) return {};
  if (claimed->lower > weight.upper) return {std::nullopt, true};
  return {Interval{claimed->lower, weight.upper}, false};
}

std::optional<Interval> intersection(const Interval& a, const Interval& b) {
  if (!overlap(a, b)) return std::nullopt;
  return Interval{std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}

namespace {

// The exact sign of numerator - quotient * denominator decides; below this the remainder itself could underflow.
constexpr double kSafeNumerator = 0x1p-900;

}  // namespace

double divide_down(double numerator, double denominator) {
  const double quotient = numerator / denominator;
  const bool is_lower_bound = numerator > kSafeNumerator && std::fma(-quotient, denominator, numerator) >= 0;
  return is_lower_bound ? quotient : next_down(quotient);
}

double divide_up(double numerator, double denominator) {
  const double quotient = numerator / denominator;
  const bool is_upper_bound = numerator > kSafeNumerator && std::fma(-quotient, denominator, numerator) <= 0;
  return is_upper_bound ? quotient : next_up(quotient);
}

Interval alpha_of(const Interval& weight, const Interval& optimum) {
  return {std::max(1.0, divide_down(weight.lower, optimum.upper)), divide_up(weight.upper, optimum.lower)};
}

Decision is_optimal(const Interval& weight, const std::optional<Interval>& optimum) {
  if (optimality_of(optimum) == Optimality::none) return Decision::undecided;
  if (weight.lower > optimum->upper) return Decision::no;
  const bool proved = optimality_of(optimum) == Optimality::proved;
  return proved && weight.upper <= optimum->upper ? Decision::yes : Decision::undecided;
}

}  // namespace mwt
