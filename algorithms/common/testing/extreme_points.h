// For tests only: small point sets at the limits of floating point. Flat ones, tiny and huge ones, ones that span many
// magnitudes, and ones whose coordinates are single steps of doubles apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "geometry/convex_hull.h"
#include "geometry/point.h"

namespace mwt::test {

/// Draws point sets that try filters and their margins; the same ones for a seed on every platform.
class ExtremePoints {
 public:
  explicit ExtremePoints(std::uint64_t seed) : random_(seed) {}

  enum Kind {
    flat_lattice,
    turned_flat_lattice,
    flat_strip,
    log_radial,
    flat_log_radial,
    tiny_cluster,
    nested_clusters,
    denormal_rows,
    scaled_lattice,
    far_away,
    along_a_line,
    corridor,
    any_magnitudes,
    flat_parabola,
    two_kinds,
    around_corners,
    kKinds
  };

  /// n points of the kind, or fewer where some coincide; empty if they are fewer than 3 or all on one line.
  std::vector<Point> draw(Kind kind, std::size_t n) {
    std::vector<Point> points = placed(kind, n);
    if (below(3) == 0) points = resized(std::move(points));
    for (Point& p : points) p = {p.x + 0.0, p.y + 0.0};  // one zero only
    std::vector<Point> distinct;
    for (const Point& p : points) {
      if (std::find(distinct.begin(), distinct.end(), p) == distinct.end()) distinct.push_back(p);
    }
    if (distinct.size() < 3 || all_collinear(distinct)) distinct.clear();
    return distinct;
  }

 private:
  std::vector<Point> placed(Kind kind, std::size_t n) {
    switch (kind) {
      case flat_lattice: return flattened(small_lattice(n), 1000);
      case turned_flat_lattice: return turned(flattened(small_lattice(n), 1060));
      case flat_strip: return flattened(uniform(n), 1074);
      case log_radial: return radial(n, 1060);
      case flat_log_radial: return turned(flattened(radial(n, 500), 400));
      case tiny_cluster: return with_tiny_cluster(n);
      case nested_clusters: return nested(n);
      case denormal_rows: return rows_of_denormals(n);
      case scaled_lattice: return scaled_anyhow(small_lattice(n));
      case far_away: return with_few_doubles_left(n);
      case along_a_line: return near_a_line(n);
      case corridor: return flattened(facing_chains(n), 1000);
      case any_magnitudes: return of_each(n, [&] { return Point{any_magnitude(), any_magnitude()}; });
      case flat_parabola: return flattened(parabola(n), 1060);
      case two_kinds: return of_two_kinds(n);
      default: return moved_to_corners(placed(any_simple_kind(), n));
    }
  }

  template <class Draw>
  static std::vector<Point> of_each(std::size_t n, Draw draw_one) {
    std::vector<Point> points(n);
    for (Point& p : points) p = draw_one();
    return points;
  }

  // No expression below draws twice in an order that the language leaves open.
  std::uint64_t below(std::uint64_t bound) { return random_() % bound; }
  bool coin() { return below(2) == 0; }
  int exponent(int least, int most) {
    return least + static_cast<int>(below(static_cast<std::uint64_t>(most - least + 1)));
  }
  // Half of them where differences of coordinates leave the range of floats, once the extent is scaled to theirs.
  int octaves(int most) { return coin() ? exponent(100, 230) : exponent(0, most); }
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double integer(std::uint64_t bound) { return static_cast<double>(below(bound)); }
  double signed_of(double x) { return coin() ? x : -x; }
  static double power(int e) { return std::ldexp(1.0, e); }
  double any_magnitude() {
    if (below(8) == 0) return 0;
    const double mantissa = coin() ? 1 : 1 + unit();
    return signed_of(std::ldexp(mantissa, exponent(-1074, 995)));
  }
  Kind any_simple_kind() { return static_cast<Kind>(below(two_kinds)); }

  static std::vector<Point> scaled(std::vector<Point> points, double x_factor, double y_factor) {
    for (Point& p : points) p = {x_factor * p.x, y_factor * p.y};
    return points;
  }

  static std::vector<Point> turned(std::vector<Point> points) {
    for (Point& p : points) p = {p.y, -p.x};
    return points;
  }

  std::vector<Point> flattened(std::vector<Point> points, int max_octaves) {
    return scaled(std::move(points), 1, power(-octaves(max_octaves)));
  }

  // By a power of two, as far as no coordinate exceeds 1e300.
  std::vector<Point> resized(std::vector<Point> points) {
    double largest = 0;
    for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    const int most = largest > 0 ? 995 - std::ilogb(largest) : 0, span = coin() ? 40 : 700;
    const double factor = power(std::min(exponent(-span, span), most));
    return scaled(std::move(points), factor, factor);
  }

  // Each near a corner of a unit triangle, if it was near the origin.
  std::vector<Point> moved_to_corners(std::vector<Point> points) {
    const double shrink = power(-exponent(0, 60));
    const Point corners[] = {{0, 0}, {1, 0}, {0, 1}};
    for (Point& p : points) {
      if (std::abs(p.x) > 1 || std::abs(p.y) > 1) p = {p.x / (1 + std::abs(p.x)), p.y / (1 + std::abs(p.y))};
      const Point& corner = corners[below(3)];
      p = {corner.x + shrink * p.x, corner.y + shrink * p.y};
    }
    return points;
  }

  std::vector<Point> of_two_kinds(std::size_t n) {
    std::vector<Point> points = resized(placed(any_simple_kind(), n / 2));
    const std::vector<Point> others = resized(placed(any_simple_kind(), n - n / 2));
    points.insert(points.end(), others.begin(), others.end());
    return points;
  }

  std::vector<Point> uniform(std::size_t n) {
    return of_each(n, [&] { return Point{unit(), unit()}; });
  }

  // Integers; some sets with many collinear triples and equal lengths.
  std::vector<Point> small_lattice(std::size_t n) {
    const std::uint64_t side = 3 + below(coin() ? 6 : 60);
    return of_each(n, [&] { return Point{integer(side), integer(side)}; });
  }

  // Around the origin, at distances of all magnitudes.
  std::vector<Point> radial(std::size_t n, int max_octaves) {
    const int span = octaves(max_octaves);
    return of_each(n, [&] {
      const double mantissa = 1 + unit(), angle = 6.283185307179586 * unit();
      const double distance = std::ldexp(mantissa, -exponent(0, span));
      return Point{distance * std::cos(angle), distance * std::sin(angle)};
    });
  }

  // At the origin, among points of ordinary distance.
  std::vector<Point> with_tiny_cluster(std::size_t n) {
    const double tiny = power(-octaves(1074));
    const bool is_lattice = coin();
    return of_each(n, [&] {
      const double size = coin() ? 1 : tiny;
      return is_lattice ? Point{size * integer(5), size * integer(5)} : Point{size * unit(), size * unit()};
    });
  }

  // Each around a point of the one before, far smaller, in doubles.
  std::vector<Point> nested(std::size_t n) {
    const double shrink = power(-exponent(10, 200));
    std::vector<Point> points(1);
    for (double size = 1; points.size() < n; size *= shrink) {
      const Point center = coin() ? Point{} : points[below(points.size())];
      for (std::uint64_t i = 1 + below(4); i > 0; --i) {
        points.push_back({center.x + signed_of(size * unit()), center.y + signed_of(size * unit())});
      }
    }
    points.resize(n);
    return points;
  }

  std::vector<Point> rows_of_denormals(std::size_t n) {
    constexpr double kStep = std::numeric_limits<double>::denorm_min();
    const std::uint64_t width = 3 + below(40), rows = 2 + below(40);
    const double column = coin() ? kStep : 1;
    return of_each(n, [&] { return Point{column * integer(width), kStep * integer(rows)}; });
  }

  // By a power of two or not, the same along both axes or not, up to 1e300.
  std::vector<Point> scaled_anyhow(std::vector<Point> points) {
    const double mantissa = coin() ? 1 : 1 + unit();
    const double x_factor = std::ldexp(mantissa, exponent(-1074, 988));
    const double y_factor = coin() ? x_factor : power(exponent(-1074, 988));
    return scaled(std::move(points), x_factor, y_factor);
  }

  std::vector<Point> with_few_doubles_left(std::size_t n) {
    const double offset = signed_of(power(exponent(20, 54))), other_offset = coin() ? 0 : offset;
    const double width = 3 + integer(6), height = power(-exponent(-3, 400)), stretch = power(exponent(-900, 900));
    return of_each(n, [&] { return Point{stretch * (width * unit() + offset), height * unit() + other_offset}; });
  }

  // Through lattice points, and moved off the line by single steps of doubles.
  std::vector<Point> near_a_line(std::size_t n) {
    const double dx = 1 + integer(4), slant = coin() ? 0 : 0.1, dy = integer(4) + slant, start = integer(3);
    const double scale = power(exponent(-1000, 900));
    const auto stepped = [&](double x) {
      for (std::uint64_t steps = below(3); steps > 0; --steps) x = std::nextafter(x, coin() ? 10.0 : -10.0);
      return scale * x;
    };
    return of_each(n, [&] {
      const double t = coin() ? integer(12) : unit();
      return Point{stepped(start + t * dx), stepped(1 + t * dy)};
    });
  }

  // Two reflex chains that face each other, and perhaps a point between them.
  std::vector<Point> facing_chains(std::size_t n) {
    const double bend = 1 + integer(5);
    std::vector<Point> points{{-17, 40 * bend}, {17, 40 * bend}, {-17, -40 * bend}, {17, -40 * bend}};
    while (points.size() < n) {
      const double x = integer(31) - 15;
      points.push_back({x, signed_of(1 + bend * x * x / 64)});
    }
    if (coin()) points.back() = {0, 0};
    return points;
  }

  std::vector<Point> parabola(std::size_t n) {
    const double width = coin() ? 1 : power(exponent(-60, 60));
    return of_each(n, [&] {
      const double x = integer(40) - 20;
      return Point{width * x, x * x};
    });
  }

  std::mt19937_64 random_;
};

}  // namespace mwt::test
