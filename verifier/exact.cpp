#include "verifier/exact.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>

namespace mwt::verifier {

namespace {

using Integer = boost::multiprecision::cpp_int;

// In units u = 2^-53: a difference of coordinates errs by u of itself, so a product of two by less than 3.1 u, times s
// or t by less than 4.2 u; adding up to four such terms adds 3.1 u of their sum. Altogether less than 8 u of the sum of
// the terms' magnitudes; twice that is asked for. Outside kTrusted products may have underflowed or overflowed.
constexpr double kRounding = 0x1p-49;
constexpr double kTrustedFrom = 1e-280, kTrustedTo = 1e300;

bool is_trusted(double value, double magnitude) {
  return magnitude > kTrustedFrom && magnitude < kTrustedTo && std::abs(value) > kRounding * magnitude;
}

// The exponent e for which x is 2^e times an integer below 2^53; any large number for 0.
int unit_exponent(double x) {
  int exponent = 0;
  if (x == 0) return 5000;
  std::frexp(x, &exponent);
  return exponent - 53;
}

// x / 2^exponent; precondition: that is an integer.
Integer scaled(double x, int exponent) {
  const int own = unit_exponent(x);
  if (x == 0) return 0;
  int binary_exponent = 0;
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &binary_exponent), 53));
  return Integer(mantissa) << static_cast<unsigned>(own - exponent);
}

template <std::size_t N>
std::array<Integer, N> as_integers(const std::array<double, N>& values) {
  int exponent = 5000;
  for (const double value : values) exponent = std::min(exponent, unit_exponent(value));
  std::array<Integer, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = scaled(values[i], exponent);
  return result;
}

int exact_sign_of_form(const Point& o, const Point& a, const Point& b, double s, double t) {
  const auto [ox, oy, ax, ay, bx, by] = as_integers<6>({o.x, o.y, a.x, a.y, b.x, b.y});
  const auto [si, ti] = as_integers<2>({s, t});
  const Integer ux = ax - ox, uy = ay - oy, vx = bx - ox, vy = by - oy;
  const Integer form = si * (ux * vy - uy * vx) + ti * (ux * vx + uy * vy);
  return form.sign();
}

int exact_comparison(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto [ax, ay, bx, by, cx, cy, dx, dy] = as_integers<8>({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
  const Integer px = ax - bx, py = ay - by, qx = cx - dx, qy = cy - dy;
  const Integer difference = px * px + py * py - qx * qx - qy * qy;
  return difference.sign();
}

}  // namespace

int sign_of_form(const Point& o, const Point& a, const Point& b, double s, double t) {
  const double ux = a.x - o.x, uy = a.y - o.y, vx = b.x - o.x, vy = b.y - o.y;
  const double terms[] = {s * (ux * vy), -s * (uy * vx), t * (ux * vx), t * (uy * vy)};
  const double value = (terms[0] + terms[1]) + (terms[2] + terms[3]);
  const double magnitude = std::abs(terms[0]) + std::abs(terms[1]) + std::abs(terms[2]) + std::abs(terms[3]);
  if (is_trusted(value, magnitude)) return value > 0 ? 1 : -1;
  return exact_sign_of_form(o, a, b, s, t);
}

int compare_lengths(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double px = a.x - b.x, py = a.y - b.y, qx = c.x - d.x, qy = c.y - d.y;
  const double ab = px * px + py * py, cd = qx * qx + qy * qy;
  if (is_trusted(ab - cd, ab + cd)) return ab > cd ? 1 : -1;
  return exact_comparison(a, b, c, d);
}

bool is_inside_segment(const Point& p, const Point& a, const Point& b) {
  // dot(a - p, b - p) < 0: p lies inside the circle over ab.
  return turn(a, b, p) == 0 && sign_of_form(p, a, b, 0, 1) < 0;
}

bool do_cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (is_inside_segment(c, a, b) || is_inside_segment(d, a, b) || is_inside_segment(a, c, d) ||
      is_inside_segment(b, c, d)) {
    return true;
  }
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

}  // namespace mwt::verifier
