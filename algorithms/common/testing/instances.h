// Small instances for the tests beside the algorithms, and checks of solutions that every test shares.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/checker.h"
#include "geometry/convex_hull.h"
#include "geometry/testing/shapes.h"

namespace mwt::test {

struct Instance {
  std::string name;
  std::vector<Point> points;
};

/// The worked example of the source report, sections 5.1.3 and 5.2.3: A .. J.
inline std::vector<Point> report_example() {
  return {{0, 1}, {1, 1}, {-5, 0}, {-1, -1}, {-6, -3}, {-1, -5}, {2, -2}, {1, -3}, {3, -3}, {1, -6}};
}

/// n distinct points of a random order of the lattice with about 2n points: collinear triples and equal lengths.
inline std::vector<Point> lattice_points(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto side = static_cast<std::uint64_t>(std::ceil(std::sqrt(2.0 * static_cast<double>(n)))) + 1;
  std::set<std::pair<std::uint64_t, std::uint64_t>> taken;
  std::vector<Point> points;
  while (points.size() < n) {
    const std::uint64_t x = random() % side, y = random() % side;
    if (taken.emplace(x, y).second) points.push_back({static_cast<double>(x), static_cast<double>(y)});
  }
  return points;
}

/// A full lattice, row by row, of about n points.
inline std::vector<Point> grid_points(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i % side), static_cast<double>(i / side)});
  return points;
}

/// Two rows, as far as n allows.
inline std::vector<Point> row_points(std::size_t n) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({static_cast<double>(i / 2), i % 2 == 0 ? 0.0 : 3.0});
  return points;
}

/// All on one line but for the last.
inline std::vector<Point> fan_points(std::size_t n) {
  std::vector<Point> points;
  for (std::size_t i = 0; i + 1 < n; ++i) points.push_back({static_cast<double>(i), 0});
  points.push_back({static_cast<double>(n / 2), 1});
  return points;
}

/// On the parabola y = x^2, which integers carry exactly: convex position.
inline std::vector<Point> parabola_points(std::size_t n) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = static_cast<double>(i) - static_cast<double>(n / 2);
    points.push_back({x, x * x});
  }
  return points;
}

inline std::vector<Point> clustered_points(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) {
    const double spread = i % 3 == 0 ? 1.0 : 1e-4;
    const double centre = i % 2 == 0 ? 0.25 : 0.75;
    points.push_back({centre + spread * random_unit(random), centre + spread * random_unit(random)});
  }
  return points;
}

/// Instances of every shape with n points (n >= 3): random, degenerate, of extreme size.
inline std::vector<Instance> instances(std::size_t n) {
  std::vector<Instance> list = {
      {"uniform", uniform_points(n, n)},
      {"lattice", lattice_points(n, n)},
      {"grid", grid_points(n)},
      {"rows", row_points(n)},
      {"fan", fan_points(n)},
      {"parabola", parabola_points(n)},
      {"circle", circle_points(n)},
      {"clustered", clustered_points(n, n)},
      {"near_collinear", scaled(uniform_points(n, n + 1), 1, 1e-12)},
      {"huge", scaled(uniform_points(n, n + 2), 1e300, 1e300)},
      {"tiny", scaled(lattice_points(n, n + 3), 1e-300, 1e-300)},
  };
  std::erase_if(list, [](const Instance& instance) { return all_collinear(instance.points); });
  return list;
}

inline Context context_for(const AlgorithmInfo& info, const std::map<std::string, std::string>& given = {}) {
  Context context;
  context.parameters = Parameters(info.name, info.parameters, given);
  return context;
}

/// A solution that has passed the checker; a test failure otherwise.
inline Solution solve_checked(const AlgorithmInfo& info, Points points,
                              const std::map<std::string, std::string>& given = {}) {
  Context context = context_for(info, given);
  Solution solution = info.function(points, context);
  const auto violation = find_violation(points, solution.triangulation);
  EXPECT_FALSE(violation.has_value()) << info.name << ": " << violation->message;
  return solution;
}

/// Solves instances of every shape and size up to `max_n`.
inline void expect_valid_on_all_shapes(const AlgorithmInfo& info, std::size_t max_n,
                                       const std::map<std::string, std::string>& given = {}) {
  for (const std::size_t n : {3, 4, 5, 10, 100, 1000}) {
    if (n > max_n) return;
    for (const Instance& instance : instances(n)) {
      SCOPED_TRACE(instance.name + " " + std::to_string(n));
      solve_checked(info, instance.points, given);
    }
  }
}

/// Triangles with the smallest corner first, in the order of the list.
inline std::vector<Triangle> rotated_to_smallest(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) {
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  return triangles;
}

}  // namespace mwt::test
