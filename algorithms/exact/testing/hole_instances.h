// For tests only: point sets whose faces have holes.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "geometry/point_set.h"

namespace mwt::hole_instances {

using Random = std::mt19937_64;

inline double uniform(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

/// Points on a circle, moved by up to `jitter`.
inline void append_ring(std::vector<Point>& points, const Point& centre, double radius, std::size_t n, double jitter,
                        Random& random) {
  const double turn = uniform(random);
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(i) + turn) / static_cast<double>(n);
    points.push_back({centre.x + radius * std::cos(angle) + jitter * (uniform(random) - .5),
                      centre.y + radius * std::sin(angle) + jitter * (uniform(random) - .5)});
  }
}

/// A wheel whose hub is a small wheel.
inline std::vector<Point> nested_wheels(std::size_t n, Random& random) {
  std::vector<Point> points{{0, 0}};
  const std::size_t inner = 3 + random() % 3;
  append_ring(points, {0, 0}, 0.05 + 0.2 * uniform(random), inner, 1e-3, random);
  append_ring(points, {0, 0}, 1, n > inner + 4 ? n - inner - 1 : 3, 1e-3, random);
  return points;
}

/// Concentric rings of about equally many points.
inline std::vector<Point> rings_in_rings(std::size_t n, Random& random) {
  std::vector<Point> points;
  const std::size_t rings = 2 + random() % 2;
  for (std::size_t ring = 0; ring < rings; ++ring) {
    const double radius = 1 - 0.8 * static_cast<double>(ring) / static_cast<double>(rings);
    append_ring(points, {0, 0}, radius, std::max<std::size_t>(3, n / rings), 1e-3 + .02 * uniform(random), random);
  }
  return points;
}

/// A large ring around single points and tiny polygons.
inline std::vector<Point> islands(std::size_t n, Random& random) {
  std::vector<Point> points;
  append_ring(points, {0, 0}, 1, std::max<std::size_t>(4, n / 2), 1e-2, random);
  while (points.size() < n) {
    const Point centre{1.2 * (uniform(random) - .5), 1.2 * (uniform(random) - .5)};
    if (random() % 2 == 0 || points.size() + 3 > n) {
      points.push_back(centre);
    } else {
      append_ring(points, centre, .02, 3, 1e-3, random);
    }
  }
  return points;
}

/// Two combs whose teeth reach between each other.
inline std::vector<Point> combs(std::size_t n, Random& random) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i / 2) + .3 * uniform(random);
    const bool is_tip = (i / 2) % 2 == (i % 2);
    points.push_back(
        {x, i % 2 == 0 ? (is_tip ? .9 : 0) + .01 * uniform(random) : (is_tip ? .1 : 1) + .01 * uniform(random)});
  }
  return points;
}

/// Level lines of a smooth hill with two summits, denser along the lines than across them.
inline std::vector<Point> contours(std::size_t n, Random& random) {
  std::vector<Point> points;
  const double apart = .3 + .4 * uniform(random);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t level = i % 3;
    const double angle = 2 * std::numbers::pi * uniform(random);
    const double radius = .25 + .35 * static_cast<double>(level);
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    const bool is_split = level == 0;
    points.push_back({is_split ? (random() % 2 == 0 ? apart : -apart) + .3 * x : 1.5 * x, is_split ? .3 * y : y});
  }
  return points;
}

struct Family {
  std::string name;
  std::function<std::vector<Point>(std::size_t, Random&)> make;
};

inline const std::vector<Family>& families() {
  static const std::vector<Family> all = {{"nested wheels", nested_wheels},
                                          {"rings in rings", rings_in_rings},
                                          {"islands", islands},
                                          {"combs", combs},
                                          {"contours", contours}};
  return all;
}

struct Instance {
  std::string name;
  std::vector<Point> points;  // distinct, not all collinear
};

/// `count` of every family, of smallest .. largest points.
inline std::vector<Instance> instances(std::size_t count, std::size_t smallest, std::size_t largest,
                                       std::uint64_t seed) {
  Random random(seed);
  std::vector<Instance> result;
  for (const Family& family : families()) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t n = smallest + i % (largest - smallest + 1);
      const std::string name = family.name + " " + std::to_string(i) + " of seed " + std::to_string(seed);
      result.push_back({name, make_point_set(family.make(n, random), name).points});
    }
  }
  return result;
}

}  // namespace mwt::hole_instances
