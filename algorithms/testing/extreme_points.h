// For tests only: small point sets at the limits of floating point. Flat ones, tiny and huge ones, ones that span many
// magnitudes, and ones whose coordinates are single steps of doubles apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "geometry/convex_hull.h"
#include "geometry/point.h"

namespace mwt::test {

/// Draws point sets that test filters and their margins; the same on every platform.
class ExtremePoints {
 public:
  explicit ExtremePoints(std::uint64_t seed) : random_(seed) {}

  static constexpr int kKinds = 14;

  /// n points of the kind, or fewer where some coincide; empty if they are fewer than 3 or all on one line.
  std::vector<Point> draw(int kind, std::size_t n) {
    std::vector<Point> points = placed(kind, n);
    for (Point& p : points) p = {p.x + 0.0, p.y + 0.0};  // one zero only
    std::vector<Point> distinct;
    for (const Point& p : points) {
      if (std::find(distinct.begin(), distinct.end(), p) == distinct.end()) distinct.push_back(p);
    }
    if (distinct.size() < 3 || all_collinear(distinct)) distinct.clear();
    return distinct;
  }

 private:
  std::vector<Point> placed(int kind, std::size_t n) {
    switch (kind) {
      case 0: return flat_lattice(n, octaves(1000));
      case 1: return turned(flat_lattice(n, octaves(1060)));
      case 2: return scaled(of_each(n, [&] { return Point{unit(), unit()}; }), 1, power(-octaves(1074)));
      case 3: return log_radial(n, octaves(1060));
      case 4: return turned(scaled(log_radial(n, octaves(500)), 1, power(-octaves(400))));
      case 5: return two_scales(n, octaves(1074));
      case 6: return nested_clusters(n, exponent(10, 200));
      case 7: return denormal_rows(n);
      case 8: return scaled_anyhow(small_lattice(n));
      case 9: return far_away(n);
      case 10: return along_a_line(n);
      case 11: return corridor(n, octaves(1000));
      case 12: return of_each(n, [&] { return Point{any_magnitude(-1074, 995), any_magnitude(-1074, 995)}; });
      default: return flat_parabola(n, octaves(1060));
    }
  }

  template <class Draw>
  static std::vector<Point> of_each(std::size_t n, Draw draw_one) {
    std::vector<Point> points(n);
    for (Point& p : points) p = draw_one();
    return points;
  }

  std::uint64_t below(std::uint64_t bound) { return random_() % bound; }
  int exponent(int least, int most) {
    return least + static_cast<int>(below(static_cast<std::uint64_t>(most - least + 1)));
  }
  // Half of them where differences of coordinates leave the range of floats, once the extent is scaled to theirs.
  int octaves(int most) { return below(2) == 0 ? exponent(100, 230) : exponent(0, most); }
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double integer(std::uint64_t bound) { return static_cast<double>(below(bound)); }
  double sign() { return below(2) == 0 ? 1 : -1; }
  static double power(int e) { return std::ldexp(1.0, e); }
  double any_magnitude(int least, int most) {
    if (below(8) == 0) return 0;
    const double mantissa = below(2) == 0 ? 1 : 1 + unit();
    return sign() * std::ldexp(mantissa, exponent(least, most));
  }

  static std::vector<Point> scaled(std::vector<Point> points, double x_factor, double y_factor) {
    for (Point& p : points) p = {x_factor * p.x, y_factor * p.y};
    return points;
  }

  static std::vector<Point> turned(std::vector<Point> points) {
    for (Point& p : points) p = {p.y, -p.x};
    return points;
  }

  // Integers; some sets with many collinear triples and equal lengths.
  std::vector<Point> small_lattice(std::size_t n) {
    const std::uint64_t side = 3 + below(below(2) == 0 ? 6 : 60);
    return of_each(n, [&] { return Point{integer(side), integer(side)}; });
  }

  std::vector<Point> flat_lattice(std::size_t n, int octaves) { return scaled(small_lattice(n), 1, power(-octaves)); }

  std::vector<Point> log_radial(std::size_t n, int octaves) {
    return of_each(n, [&] {
      const double distance = std::ldexp(1 + unit(), -exponent(0, octaves));
      const double angle = 6.283185307179586 * unit();
      return Point{distance * std::cos(angle), distance * std::sin(angle)};
    });
  }

  // A tiny cluster at the origin among points of ordinary distance.
  std::vector<Point> two_scales(std::size_t n, int octaves) {
    const double tiny = power(-octaves);
    const bool is_lattice = below(2) == 0;
    return of_each(n, [&] {
      const double size = below(2) == 0 ? 1 : tiny;
      return is_lattice ? Point{size * integer(5), size * integer(5)} : Point{size * unit(), size * unit()};
    });
  }

  // Each around a point of the one before, smaller by so many octaves, as far as doubles tell.
  std::vector<Point> nested_clusters(std::size_t n, int octaves) {
    std::vector<Point> points(1);
    double size = 1;
    while (points.size() < n) {
      const Point center = below(2) == 0 ? Point{} : points[below(points.size())];
      for (std::uint64_t i = 1 + below(4); i > 0; --i) {
        points.push_back({center.x + size * sign() * unit(), center.y + size * sign() * unit()});
      }
      size *= power(-octaves);
    }
    points.resize(n);
    return points;
  }

  std::vector<Point> denormal_rows(std::size_t n) {
    constexpr double kStep = std::numeric_limits<double>::denorm_min();
    const std::uint64_t width = 3 + below(40), rows = 2 + below(40);
    const double column = below(2) == 0 ? kStep : 1;
    return of_each(n, [&] { return Point{column * integer(width), kStep * integer(rows)}; });
  }

  // By a power of two or not, the same along both axes or not, up to 1e300.
  std::vector<Point> scaled_anyhow(std::vector<Point> points) {
    const double x_factor = std::ldexp(1 + (below(2) == 0 ? 0 : unit()), exponent(-1074, 988));
    const double y_factor = below(2) == 0 ? x_factor : std::ldexp(1.0, exponent(-1074, 988));
    return scaled(std::move(points), x_factor, y_factor);
  }

  // Where only few doubles are left between the points.
  std::vector<Point> far_away(std::size_t n) {
    const double offset = sign() * power(exponent(20, 54)), other_offset = below(2) == 0 ? 0 : offset;
    const double width = 3 + integer(6), height = power(-exponent(-3, 400));
    return scaled(of_each(n,
                          [&] {
                            return Point{width * unit() + offset, height * unit() + other_offset};
                          }),
                  power(exponent(-900, 900)), 1);
  }

  // Of a line through lattice points, moved by single steps of doubles.
  std::vector<Point> along_a_line(std::size_t n) {
    const double dx = 1 + integer(4), dy = integer(4) + (below(2) == 0 ? 0 : 0.1), start = integer(3);
    const double scale = power(exponent(-1000, 900));
    const auto stepped = [&](double x) {
      for (std::uint64_t steps = below(3); steps > 0; --steps) x = std::nextafter(x, below(2) == 0 ? 10.0 : -10.0);
      return x;
    };
    return scaled(of_each(n,
                          [&] {
                            const double t = below(2) == 0 ? integer(12) : unit();
                            return Point{stepped(start + t * dx), stepped(1 + t * dy)};
                          }),
                  scale, scale);
  }

  // Two reflex chains that face each other, flat by so many octaves, and perhaps a point between them.
  std::vector<Point> corridor(std::size_t n, int octaves) {
    const double height = power(-octaves), bend = 1 + integer(5);
    std::vector<Point> points{{-17, 40 * bend}, {17, 40 * bend}, {-17, -40 * bend}, {17, -40 * bend}};
    while (points.size() < n) {
      const double x = integer(31) - 15, y = 1 + bend * x * x / 64;
      points.push_back({x, below(2) == 0 ? y : -y});
    }
    if (below(2) == 0) points.back() = {0, 0};
    return scaled(std::move(points), 1, height);
  }

  std::vector<Point> flat_parabola(std::size_t n, int octaves) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i) {
      const double x = integer(40) - 20;
      points.push_back({x, x * x});
    }
    const double scale = below(2) == 0 ? 1 : power(exponent(-60, 60));
    return scaled(std::move(points), scale, power(-octaves));
  }

  std::mt19937_64 random_;
};

}  // namespace mwt::test
