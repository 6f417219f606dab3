#include "verifier/diamond.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "verifier/exact.h"
#include "verifier/testing/naive_prover.h"

namespace mwt::verifier {
namespace {

using testing::random_points;

// By the definition.
bool is_candidate(Points points, Index a, Index b) {
  bool left = false, right = false;
  for (Index i = 0; i < points.size(); ++i) {
    if (i == a || i == b) continue;
    if (is_inside_segment(points[i], points[a], points[b])) return false;
    const int side = turn(points[a], points[b], points[i]);
    const bool is_inside = side != 0 && sign_of_form(points[a], points[b], points[i], -side, kDiamondTangent) > 0 &&
                           sign_of_form(points[b], points[a], points[i], side, kDiamondTangent) > 0;
    if (is_inside) (side > 0 ? left : right) = true;
  }
  return !(left && right);
}

void expect_the_definition(const std::string& name, const std::vector<Point>& points) {
  const PointTree tree(points);
  const EdgeSet edges = diamond_candidates(points, tree);
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) {
      ASSERT_EQ(edges.contains(a, b), is_candidate(points, a, b)) << name << ": " << a << " " << b;
    }
  }
}

TEST(Diamond, FindsWhatTheDefinitionSays) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    expect_the_definition("uniform", random_points(20 * seed, seed));
    expect_the_definition("lattice", random_points(10 * seed, seed, 12));
  }
}

TEST(Diamond, FindsWhatTheDefinitionSaysWhereScalesMix) {
  for (unsigned seed = 1; seed <= 2; ++seed) {
    std::vector<Point> points = random_points(30, seed);
    for (const double scale : {1e-3, 1e-8, 1e-14}) {
      for (const Point& p : random_points(15, seed + 10)) points.push_back({0.3 + scale * p.x, 0.6 + scale * p.y});
    }
    expect_the_definition("clusters", points);
    for (Point& p : points) p = {std::ldexp(p.x, -900), std::ldexp(p.y, -900)};
    expect_the_definition("tiny", points);
    for (Point& p : points) p = {std::ldexp(p.x, 1890), std::ldexp(p.y, 1890)};
    expect_the_definition("huge", points);
  }
}

TEST(Diamond, FindsWhatTheDefinitionSaysOnCurves) {
  std::vector<Point> circle, parabola, comb;
  for (int i = 0; i < 120; ++i) {
    const double angle = 2 * std::numbers::pi * i / 120;
    circle.push_back({std::cos(angle), std::sin(angle)});
    parabola.push_back({1.0 * i, 1.0 * i * i});
    comb.push_back({1.0 * (i / 2), i % 2 * 50.0});
  }
  expect_the_definition("circle", circle);
  expect_the_definition("parabola", parabola);
  expect_the_definition("comb", comb);
}

TEST(PointTree, FindsTrianglesWithoutPoints) {
  for (const int range : {0, 7}) {
    const std::vector<Point> points = random_points(40, 3, range);
    const PointTree tree(points);
    for (Index a = 0; a < points.size(); ++a) {
      for (Index b = 0; b < points.size(); ++b) {
        for (Index c = 0; c < points.size(); ++c) {
          if (a == b || b == c || c == a || turn(points[a], points[b], points[c]) <= 0) continue;
          bool is_empty = true;
          for (Index p = 0; p < points.size(); ++p) {
            const bool is_corner = p == a || p == b || p == c;
            const bool is_inside = turn(points[a], points[b], points[p]) >= 0 &&
                                   turn(points[b], points[c], points[p]) >= 0 &&
                                   turn(points[c], points[a], points[p]) >= 0;
            is_empty = is_empty && (is_corner || !is_inside);
          }
          ASSERT_EQ(tree.is_empty(a, b, c), is_empty);
        }
      }
    }
  }
}

}  // namespace
}  // namespace mwt::verifier
