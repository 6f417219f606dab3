#include "geometry/checker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <set>

#include "geometry/convex_hull.h"
#include "geometry/delaunay.h"
#include "geometry/predicates.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

using Rule = TriangulationRule;

// The rule that is broken, or nothing; for readable failures.
std::string broken_rule(const std::vector<Point>& points, const Triangulation& triangulation) {
  const auto violation = find_violation(points, triangulation);
  return violation ? std::string(name_of(violation->rule)) : "valid";
}

testing::AssertionResult is_rejected(const std::vector<Point>& points, const Triangulation& triangulation,
                                     const std::set<Rule>& expected) {
  const auto violation = find_violation(points, triangulation);
  if (!violation) return testing::AssertionFailure() << "accepted";
  if (!expected.contains(violation->rule)) return testing::AssertionFailure() << "rejected as " << violation->message;
  if (!violation->message.starts_with(std::string(name_of(violation->rule)) + ": ")) {
    return testing::AssertionFailure() << "message without its rule: " << violation->message;
  }
  return testing::AssertionSuccess();
}

std::vector<test::Shape> shapes_to_break() {
  std::vector<test::Shape> shapes;
  for (test::Shape& shape : test::all_shapes()) {
    if (shape.points.size() >= 5) shapes.push_back(std::move(shape));
  }
  return shapes;
}

// Some positions spread over 0 .. size - 1.
std::vector<std::size_t> samples(std::size_t size) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < size; i += 1 + size / 12) positions.push_back(i);
  return positions;
}

// Calls `test(points, triangulation, t)` for some triangles of a correct triangulation of every shape.
template <class Test>
void for_triangles_of_every_shape(const Test& test) {
  for (const test::Shape& shape : shapes_to_break()) {
    SCOPED_TRACE(shape.name);
    const Triangulation triangulation = delaunay_triangulation(shape.points);
    ASSERT_EQ(broken_rule(shape.points, triangulation), "valid");
    for (const std::size_t t : samples(triangulation.triangles.size())) {
      SCOPED_TRACE("triangle " + std::to_string(t));
      test(shape.points, triangulation, t);
    }
  }
}

bool is_on_hull(const std::vector<std::array<Index, 3>>& adjacent, std::size_t t) {
  return std::ranges::count(adjacent[t], kNoIndex) > 0;
}

TEST(Checker, AcceptsDelaunayTriangulationsOfEveryShape) {
  for (const test::Shape& shape : test::all_shapes()) {
    EXPECT_EQ(broken_rule(shape.points, delaunay_triangulation(shape.points)), "valid") << shape.name;
  }
}

TEST(Checker, AcceptsAnyOrderAndRotation) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    std::swap(triangulation.triangles[t], triangulation.triangles.front());
    std::ranges::rotate(triangulation.triangles[t], triangulation.triangles[t].begin() + 1);
    EXPECT_EQ(broken_rule(points, triangulation), "valid");
  });
}

// Replaces the diagonal between triangle t and a neighbour; empty if no neighbour forms a strictly convex
// quadrilateral.
std::optional<Triangulation> flipped(const std::vector<Point>& points, Triangulation triangulation, std::size_t t) {
  const auto adjacent = adjacency_of(triangulation);
  for (std::size_t i = 0; i < 3; ++i) {
    const Index other = adjacent[t][i];
    if (other == kNoIndex) continue;
    const Index apex = triangulation.triangles[t][i];
    const Edge shared = directed_edge(triangulation.triangles[t], static_cast<int>(i));
    for (const Index far : triangulation.triangles[other]) {
      if (far == shared.a || far == shared.b) continue;
      if (!is_strictly_convex(points[apex], points[shared.a], points[far], points[shared.b])) continue;
      triangulation.triangles[t] = {apex, shared.a, far};
      triangulation.triangles[other] = {far, shared.b, apex};
      return triangulation;
    }
  }
  return std::nullopt;
}

TEST(Checker, AcceptsFlippedDiagonals) {
  int flips = 0;
  for_triangles_of_every_shape([&](const auto& points, const Triangulation& triangulation, std::size_t t) {
    if (const auto other = flipped(points, triangulation, t)) {
      EXPECT_EQ(broken_rule(points, *other), "valid");
      ++flips;
    }
  });
  EXPECT_GT(flips, 50);
}

TEST(Checker, RejectsAMissingTriangle) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    const bool has_neighbour = triangulation.triangles.size() > 1;
    triangulation.triangles.erase(triangulation.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    EXPECT_TRUE(is_rejected(points, triangulation, {has_neighbour ? Rule::boundary_is_hull : Rule::hull_is_boundary}));
  });
}

TEST(Checker, RejectsADoubledTriangle) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    triangulation.triangles.push_back(triangulation.triangles[t]);
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::directed_edge_once}));
    std::ranges::rotate(triangulation.triangles.back(), triangulation.triangles.back().begin() + 1);
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::directed_edge_once}));
  });
}

TEST(Checker, RejectsAClockwiseTriangle) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    std::swap(triangulation.triangles[t][0], triangulation.triangles[t][1]);
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::strictly_counter_clockwise}));
  });
}

TEST(Checker, RejectsACornerTwice) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    triangulation.triangles[t][0] = triangulation.triangles[t][1];
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::strictly_counter_clockwise}));
  });
}

TEST(Checker, RejectsIndicesOutOfRange) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    triangulation.triangles[t][2] = static_cast<Index>(points.size());
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::indices_in_range}));
    triangulation.triangles[t][2] = kNoIndex;
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::indices_in_range}));
  });
}

TEST(Checker, RejectsAnyOtherCorner) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    const Triangle old = triangulation.triangles[t];
    for (const std::size_t i : samples(points.size())) {
      const auto corner = static_cast<Index>(i);
      if (std::ranges::count(old, corner) > 0) continue;
      triangulation.triangles[t] = {old[0], old[1], corner};
      EXPECT_NE(broken_rule(points, triangulation), "valid") << corner;
    }
  });
}

// Another triangle, correctly oriented, laid over the others.
TEST(Checker, RejectsAnOverlappingTriangle) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    const Triangle& base = triangulation.triangles[t];
    for (const std::size_t i : samples(points.size())) {
      Triangle extra{base[0], base[1], static_cast<Index>(i)};
      const int turn = orientation(points[extra[0]], points[extra[1]], points[extra[2]]);
      if (turn == 0) continue;
      if (turn < 0) std::swap(extra[0], extra[1]);
      Triangulation broken = triangulation;
      broken.triangles.push_back(extra);
      EXPECT_NE(broken_rule(points, broken), "valid") << i;
    }
  });
}

// The two triangles of a diagonal replaced by the two of the other one, but only one of the two.
TEST(Checker, RejectsHalfAFlip) {
  int tried = 0;
  for_triangles_of_every_shape([&](const auto& points, const Triangulation& triangulation, std::size_t t) {
    const auto other = flipped(points, triangulation, t);
    if (!other) return;
    Triangulation half = triangulation;
    half.triangles[t] = other->triangles[t];
    EXPECT_TRUE(is_rejected(points, half, {Rule::directed_edge_once, Rule::boundary_is_hull}));
    ++tried;
  });
  EXPECT_GT(tried, 50);
}

TEST(Checker, RejectsAHullNotch) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    if (triangulation.triangles.size() < 2 || !is_on_hull(adjacency_of(triangulation), t)) return;
    triangulation.triangles.erase(triangulation.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    EXPECT_TRUE(is_rejected(points, triangulation, {Rule::boundary_is_hull}));
  });
}

// All triangles around an inner point replaced by those of its surroundings: covered, but the point is left out.
TEST(Checker, RejectsAnUnusedInnerPoint) {
  const std::vector<Point> points{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}};
  EXPECT_EQ(broken_rule(points, {5, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}}), "valid");
  EXPECT_TRUE(is_rejected(points, {5, {{0, 1, 2}, {0, 2, 3}}}, {Rule::every_point_used}));
}

// A point on the hull's boundary left out: the edge passes through it.
TEST(Checker, RejectsAnEdgeThroughAPointOnTheHull) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {0, 2}, {1, 0}};
  EXPECT_EQ(broken_rule(points, {4, {{0, 3, 2}, {3, 1, 2}}}), "valid");
  EXPECT_TRUE(is_rejected(points, {4, {{0, 1, 2}}}, {Rule::boundary_is_hull}));
}

// An inner edge passes through a point, which is a corner on the one side only.
TEST(Checker, RejectsAnEdgeThroughAnInnerPoint) {
  const std::vector<Point> points{{0, 0}, {2, 0}, {1, 2}, {1, -2}, {1, 0}};
  EXPECT_EQ(broken_rule(points, {5, {{0, 4, 2}, {4, 1, 2}, {0, 3, 4}, {3, 1, 4}}}), "valid");
  EXPECT_TRUE(is_rejected(points, {5, {{0, 4, 2}, {4, 1, 2}, {0, 3, 1}}}, {Rule::boundary_is_hull}));
}

TEST(Checker, RejectsAHole) {
  const std::vector<Point> points = test::full_lattice(6, 6);
  Triangulation triangulation = delaunay_triangulation(points);
  std::erase_if(triangulation.triangles, [](const Triangle& t) { return std::ranges::count(t, Index{14}) > 0; });
  EXPECT_TRUE(is_rejected(points, triangulation, {Rule::boundary_is_hull}));
}

TEST(Checker, RejectsTwoPointsExchanged) {
  for (const test::Shape& shape : shapes_to_break()) {
    SCOPED_TRACE(shape.name);
    const Triangulation correct = delaunay_triangulation(shape.points);
    Triangulation broken = correct;
    const Index a = 0, b = static_cast<Index>(shape.points.size() - 1);
    for (Triangle& triangle : broken.triangles) {
      for (Index& corner : triangle) corner = corner == a ? b : corner == b ? a : corner;
    }
    if (canonical_triangles(broken) == canonical_triangles(correct)) continue;
    EXPECT_NE(broken_rule(shape.points, broken), "valid");
  }
}

TEST(Checker, RejectsOneCornerExchanged) {
  for_triangles_of_every_shape([](const auto& points, Triangulation triangulation, std::size_t t) {
    const std::size_t other = (t + 1) % triangulation.triangles.size();
    if (other == t || triangulation.triangles[t][0] == triangulation.triangles[other][0]) return;
    std::swap(triangulation.triangles[t][0], triangulation.triangles[other][0]);
    EXPECT_NE(broken_rule(points, triangulation), "valid");
  });
}

TEST(Checker, RejectsTheWrongNumberOfPoints) {
  const std::vector<Point> points = test::uniform_points(20, 1);
  Triangulation triangulation = delaunay_triangulation(points);
  triangulation.point_count = 19;
  EXPECT_TRUE(is_rejected(points, triangulation, {Rule::point_count_matches}));
  triangulation.point_count = 21;
  EXPECT_TRUE(is_rejected(points, triangulation, {Rule::point_count_matches}));
}

TEST(Checker, RejectsNothing) {
  const std::vector<Point> points = test::uniform_points(20, 1);
  EXPECT_TRUE(is_rejected(points, {20, {}}, {Rule::hull_is_boundary}));
}

// A star of left-turning triangles that winds around its centre twice: all inner sides are paired.
TEST(Checker, RejectsADoubleCover) {
  std::vector<Point> points{{0, 0}};
  for (const double radius : {4., 8.}) {
    for (const Point& p : {Point{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) points.push_back({radius * p.x, radius * p.y});
  }
  Triangulation star{9, {}};
  for (Index i = 0; i < 8; ++i) star.triangles.push_back({0, 1 + i, 1 + (i + 1) % 8});
  EXPECT_TRUE(is_rejected(points, star, {Rule::boundary_is_hull}));
}

TEST(Checker, MessagesNameThePlace) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ(find_violation(points, {4, {{0, 1, 2}, {0, 2, 9}}})->message,
            "indices_in_range: triangle 1 (0, 2, 9) has corner 9, but points go from 0 to 3");
  EXPECT_EQ(find_violation(points, {4, {{0, 1, 2}, {0, 3, 2}}})->message,
            "strictly_counter_clockwise: triangle 1 (0, 3, 2) turns clockwise");
  EXPECT_EQ(find_violation(points, {4, {{0, 1, 2}}})->message,
            "boundary_is_hull: nothing lies right of edge 2 -> 0 of triangle 0, which is not on the hull");
}

// A triangulation by definition: 2n - 2 - h empty triangles of which no two sides cross.
bool is_triangulation_by_definition(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  if (triangles.size() != 2 * points.size() - 2 - convex_hull(points).size()) return false;
  std::vector<Edge> sides;
  for (const Triangle& t : triangles) {
    for (Index p = 0; p < points.size(); ++p) {
      const bool is_corner = std::ranges::count(t, p) > 0;
      if (!is_corner && in_closed_triangle(points[p], points[t[0]], points[t[1]], points[t[2]])) return false;
    }
    for (int i = 0; i < 3; ++i) {
      const Edge side = directed_edge(t, i);
      if (std::ranges::count(sides, side) > 0) return false;
      sides.push_back(side);
    }
  }
  return std::ranges::all_of(sides, [&](const Edge& e) {
    return std::ranges::none_of(sides, [&](const Edge& f) {
      return make_edge(e.a, e.b) != make_edge(f.a, f.b) &&
             segments_cross(points[e.a], points[e.b], points[f.a], points[f.b]);
    });
  });
}

// All sets of up to five triangles over two rows of three points; C(4, 2) = 6 of them are triangulations.
TEST(Checker, AgreesWithTheDefinitionOnAllSetsOfTriangles) {
  const std::vector<Point> points = test::full_lattice(3, 2);
  std::vector<Triangle> all;
  for (Index a = 0; a < 6; ++a) {
    for (Index b = a + 1; b < 6; ++b) {
      for (Index c = b + 1; c < 6; ++c) {
        const int turn = orientation(points[a], points[b], points[c]);
        if (turn > 0) all.push_back({a, b, c});
        if (turn < 0) all.push_back({a, c, b});
      }
    }
  }
  int accepted = 0;
  for (unsigned chosen = 0; chosen < 1U << all.size(); ++chosen) {
    if (std::popcount(chosen) > 5) continue;
    Triangulation triangulation{6, {}};
    for (std::size_t i = 0; i < all.size(); ++i) {
      if ((chosen >> i & 1U) != 0) triangulation.triangles.push_back(all[i]);
    }
    const bool valid = !find_violation(points, triangulation);
    ASSERT_EQ(valid, is_triangulation_by_definition(points, triangulation.triangles)) << chosen;
    accepted += valid ? 1 : 0;
  }
  EXPECT_EQ(accepted, 6);
}

}  // namespace
}  // namespace mwt
