#include "algorithms/exact/faces/length_sum_comparison.h"

#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "geometry/numbers/double_double.h"
#include "geometry/predicates.h"

namespace mwt {

namespace {

using Integer = boost::multiprecision::cpp_int;

// Removes what occurs in both, as often as it occurs in both. compare(e, f) is the sign of a weak order.
template <class Element, class Compare>
void cancel_equal(std::vector<Element>& a, std::vector<Element>& b, Compare compare) {
  const auto is_less = [&](const Element& e, const Element& f) { return compare(e, f) < 0; };
  std::sort(a.begin(), a.end(), is_less);
  std::sort(b.begin(), b.end(), is_less);
  auto in_a = a.begin(), in_b = b.begin(), kept_a = a.begin(), kept_b = b.begin();
  while (in_a != a.end() && in_b != b.end()) {
    const int sign = compare(*in_a, *in_b);
    if (sign < 0) *kept_a++ = *in_a;
    if (sign > 0) *kept_b++ = *in_b;
    if (sign <= 0) ++in_a;
    if (sign >= 0) ++in_b;
  }
  a.erase(kept_a, in_a);
  b.erase(kept_b, in_b);
}

// An edge's extent along the axes, exact, the larger one first: mirror images and edges turned by 90 degrees agree.
struct Extent {
  std::array<double, 4> parts;  // high and low of the larger, of the smaller
  Edge edge;
};

std::vector<Extent> extents_of(Points points, const std::vector<Edge>& edges) {
  std::vector<Extent> extents;
  for (const Edge& edge : edges) {
    const Point &p = points[edge.a], &q = points[edge.b];
    const DoubleDouble x = exact_sum(std::max(p.x, q.x), -std::min(p.x, q.x));
    const DoubleDouble y = exact_sum(std::max(p.y, q.y), -std::min(p.y, q.y));
    const bool is_wide = std::pair(x.high, x.low) > std::pair(y.high, y.low);
    const auto& [larger, smaller] = is_wide ? std::tie(x, y) : std::tie(y, x);
    extents.push_back({{larger.high, larger.low, smaller.high, smaller.low}, edge});
  }
  return extents;
}

void cancel_equal_extents(Points points, std::vector<Edge>& a, std::vector<Edge>& b) {
  std::vector<Extent> of_a = extents_of(points, a), of_b = extents_of(points, b);
  cancel_equal(of_a, of_b, [](const Extent& e, const Extent& f) {
    return static_cast<int>(e.parts > f.parts) - static_cast<int>(e.parts < f.parts);
  });
  a.clear();
  b.clear();
  for (const Extent& extent : of_a) a.push_back(extent.edge);
  for (const Extent& extent : of_b) b.push_back(extent.edge);
}

// Extents are compared at once, lengths exactly in microseconds where they are close: symmetric inputs have many of
// both.
void cancel_equal_lengths(Points points, std::vector<Edge>& a, std::vector<Edge>& b) {
  cancel_equal_extents(points, a, b);
  cancel_equal(a, b, [&](const Edge& e, const Edge& f) { return compare_edge_lengths(points, e, f); });
}

// The difference of two sums of roots of integers, common powers of two left out.
template <class Number>
struct SignedRoot {
  Number square;
  int sign;
};

// The exponent of the lowest bit set in x, which is not 0.
int lowest_bit(double x) {
  int exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::abs(std::frexp(x, &exponent)), 53));
  return exponent - 53 + std::countr_zero(static_cast<std::uint64_t>(mantissa));
}

// x / 2^exponent, an integer.
Integer scaled_integer(double x, int exponent) {
  if (x == 0) return 0;
  const int lowest = lowest_bit(x);
  return Integer(static_cast<std::int64_t>(std::scalbn(x, -lowest))) << static_cast<unsigned>(lowest - exponent);
}

std::vector<SignedRoot<Integer>> signed_roots(Points points, const std::vector<Edge>& a, const std::vector<Edge>& b) {
  std::vector<DoubleDouble> differences;  // exact; two for each edge
  for (const auto* edges : {&a, &b}) {
    for (const Edge& edge : *edges) {
      differences.push_back(exact_sum(points[edge.a].x, -points[edge.b].x));
      differences.push_back(exact_sum(points[edge.a].y, -points[edge.b].y));
    }
  }
  int exponent = 2000;
  for (const DoubleDouble& difference : differences) {
    for (const double part : {difference.high, difference.low}) {
      if (part != 0) exponent = std::min(exponent, lowest_bit(part));
    }
  }
  const auto scaled = [&](const DoubleDouble& d) -> Integer {
    return scaled_integer(d.high, exponent) + scaled_integer(d.low, exponent);
  };
  std::vector<SignedRoot<Integer>> roots;
  for (std::size_t i = 0; i < a.size() + b.size(); ++i) {
    const Integer dx = scaled(differences[2 * i]);
    const Integer dy = scaled(differences[2 * i + 1]);
    roots.push_back({dx * dx + dy * dy, i < a.size() ? 1 : -1});
  }
  return roots;
}

std::optional<Integer> perfect_root(const Integer& square) {
  Integer rest;
  Integer root = boost::multiprecision::sqrt(square, rest);
  if (rest != 0) return {};
  return root;
}

// For squares below 2^62, whose roots the double's root misses by less than one.
std::optional<std::int64_t> perfect_root(std::int64_t square) {
  const std::int64_t root = std::llround(std::sqrt(static_cast<double>(square)));
  if (root * root != square) return {};
  return root;
}

// Whether the roots cancel exactly. Two roots are rational multiples of each other if and only if the product of their
// squares is a perfect square: sqrt(b) = sqrt(ab) / a * sqrt(a). Within such a class the rational factors must cancel.
template <class Number>
bool cancel_exactly(const std::vector<SignedRoot<Number>>& roots) {
  struct RootClass {
    Number representative;
    Number factors;
  };
  std::vector<RootClass> classes;
  for (const auto& [square, sign] : roots) {
    bool found = false;
    for (RootClass& one : classes) {
      const std::optional<Number> factor = perfect_root(Number(one.representative * square));
      if (!factor) continue;
      one.factors += sign * *factor;
      found = true;
      break;
    }
    if (!found) classes.push_back({square, sign * square});
  }
  return std::all_of(classes.begin(), classes.end(), [](const RootClass& one) { return one.factors == 0; });
}

// The same test in machine integers, where the numbers are small enough (lattices): quick.
std::optional<bool> cancel_exactly_if_small(const std::vector<SignedRoot<Integer>>& roots) {
  std::vector<SignedRoot<std::int64_t>> small;
  for (const auto& [square, sign] : roots) {
    if (square >= std::int64_t{1} << 31) return {};
    small.push_back({static_cast<std::int64_t>(square), sign});
  }
  if (roots.size() > (std::size_t{1} << 30)) return {};
  return cancel_exactly(small);
}

// The sign of the sum of signed roots with `bits` bits behind the point, 0 if that is not enough.
int sign_with_precision(const std::vector<SignedRoot<Integer>>& roots, unsigned bits) {
  Integer sum = 0;
  Integer positive = 0, negative = 0;  // every root is rounded down by less than one unit
  for (const auto& [square, sign] : roots) {
    const Integer root = boost::multiprecision::sqrt(Integer(square << (2 * bits)));
    sum += sign * root;
    ++(sign > 0 ? positive : negative);
  }
  if (sum >= negative) return 1;
  if (sum <= -positive) return -1;
  return 0;
}

}  // namespace

int compare_edge_lengths(Points points, const Edge& e, const Edge& f) {
  return e == f ? 0 : compare_length(points[e.a], points[e.b], points[f.a], points[f.b]);
}

std::optional<int> compare_length_sums(Points points, std::vector<Edge>& a, std::vector<Edge>& b) {
  cancel_equal_lengths(points, a, b);
  if (a.empty() || b.empty()) return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
  const std::vector<SignedRoot<Integer>> roots = signed_roots(points, a, b);
  const std::optional<bool> cancel_small = cancel_exactly_if_small(roots);
  if (cancel_small && *cancel_small) return 0;
  if (const int sign = sign_with_precision(roots, 256); sign != 0) return sign;
  if (!cancel_small && cancel_exactly(roots)) return 0;
  for (const unsigned bits : {1024U, 4096U, 16384U}) {
    if (const int sign = sign_with_precision(roots, bits); sign != 0) return sign;
  }
  return {};
}

}  // namespace mwt
