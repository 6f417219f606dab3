#include "geometry/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <optional>

#include "geometry/numbers/double_double.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 to_cgal(const Point& p) { return {p.x, p.y}; }

// p is known to be on the line ab: compare along the coordinate order of that line.
bool strictly_between(const Point& p, const Point& a, const Point& b) {
  return (lexicographically_less(a, p) && lexicographically_less(p, b)) ||
         (lexicographically_less(b, p) && lexicographically_less(p, a));
}

bool overlap_on_a_line(const Point& a, const Point& b, const Point& c, const Point& d) {
  const bool same = (a == c && b == d) || (a == d && b == c);
  return same || strictly_between(a, c, d) || strictly_between(b, c, d) || strictly_between(c, a, b) ||
         strictly_between(d, a, b);
}

// A difference, product or sum that came out without any rounding, or nothing. Coordinates of few digits (lattices,
// files of integers) stay within exact doubles, so that their many ties need no multiprecision.
std::optional<double> if_exact(const DoubleDouble& value) {
  if (value.low != 0 || !std::isfinite(value.high)) return {};
  return value.high;
}

std::optional<double> exact_double_product(double a, double b) {
  if (a == 0 || b == 0) return 0;
  const DoubleDouble product = exact_product(a, b);
  return is_trusted_product(std::abs(product.high)) ? if_exact(product) : std::nullopt;
}

int sign_of(double x) { return (x > 0) - (x < 0); }

std::optional<int> orientation_in_doubles(const Point& a, const Point& b, const Point& c) {
  const auto ax = if_exact(exact_sum(a.x, -c.x)), ay = if_exact(exact_sum(a.y, -c.y));
  const auto bx = if_exact(exact_sum(b.x, -c.x)), by = if_exact(exact_sum(b.y, -c.y));
  if (!ax || !ay || !bx || !by) return {};
  const auto left = exact_double_product(*ax, *by), right = exact_double_product(*ay, *bx);
  if (!left || !right) return {};
  return sign_of(*left - *right);  // the sign of a rounded difference is exact
}

std::optional<double> squared_length_in_doubles(const Point& a, const Point& b) {
  const auto x = if_exact(exact_sum(a.x, -b.x)), y = if_exact(exact_sum(a.y, -b.y));
  if (!x || !y) return {};
  const auto xx = exact_double_product(*x, *x), yy = exact_double_product(*y, *y);
  if (!xx || !yy) return {};
  return if_exact(exact_sum(*xx, *yy));
}

}  // namespace

namespace detail {

int orientation_exact(const Point& a, const Point& b, const Point& c) {
  if (const auto sign = orientation_in_doubles(a, b, c)) return *sign;
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c)));
}

int compare_length_exact(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto ab = squared_length_in_doubles(a, b), cd = squared_length_in_doubles(c, d);
  if (ab && cd) return sign_of(*ab - *cd);
  return static_cast<int>(Kernel().compare_distance_2_object()(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

int dot_sign_exact(const Point& a, const Point& apex, const Point& b) {
  return static_cast<int>(CGAL::angle(to_cgal(a), to_cgal(apex), to_cgal(b)));
}

}  // namespace detail

int in_circle(const Point& a, const Point& b, const Point& c, const Point& d) {
  return static_cast<int>(CGAL::side_of_oriented_circle(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

bool in_segment_interior(const Point& p, const Point& a, const Point& b) {
  return strictly_between(p, a, b) && orientation(a, b, p) == 0;
}

bool segments_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int abc = orientation(a, b, c);
  const int abd = orientation(a, b, d);
  if (abc == 0 && abd == 0) return overlap_on_a_line(a, b, c, d);
  const int cda = orientation(c, d, a);
  const int cdb = orientation(c, d, b);
  if (abc * abd < 0 && cda * cdb < 0) return true;
  // At most one end touches the other segment now; a shared end is no crossing.
  return (abc == 0 && strictly_between(c, a, b)) || (abd == 0 && strictly_between(d, a, b)) ||
         (cda == 0 && strictly_between(a, c, d)) || (cdb == 0 && strictly_between(b, c, d));
}

}  // namespace mwt
