#include "algorithms/exact/holes/annulus_face.h"

#include <gtest/gtest.h>

#include <limits>

#include <algorithm>

#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/holes/region_solver.h"
#include "algorithms/exact/holes/strip.h"
#include "algorithms/exact/testing/hole_instances.h"
#include "algorithms/exact/testing/naive_candidates.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using hole_instances::append_ring;
using hole_instances::Random;

// A ring with one inner point, or with a triangle or a segment inside it, whose edges are the hole's boundary.
struct Annulus {
  std::vector<Point> points;
  FaceRegion region;
};

bool crosses_hole(const Annulus& annulus, std::size_t outer, const Edge& edge) {
  const std::vector<Point>& points = annulus.points;
  return std::any_of(annulus.region.boundary.begin(), annulus.region.boundary.end(), [&](const Edge& side) {
    return side.a >= outer && segments_cross(points[edge.a], points[edge.b], points[side.a], points[side.b]);
  });
}

Annulus make_annulus(std::size_t outer, std::size_t inner, double inner_radius, Random& random) {
  Annulus annulus;
  append_ring(annulus.points, {0, 0}, 1, outer, .1, random);
  append_ring(annulus.points, {.3 * hole_instances::uniform(random), 0}, inner_radius, inner, .1 * inner_radius,
              random);
  annulus.region = naive::region_of_hull(annulus.points);
  const auto at = [&](std::size_t i) { return static_cast<Index>(outer + i % inner); };
  for (std::size_t i = 0; inner > 1 && i < inner; ++i) {
    // Clockwise, the face on the left.
    annulus.region.boundary.push_back({at(i + 1), at(i)});
    std::erase(annulus.region.candidates, make_edge(at(i), at(i + 1)));
  }
  std::erase_if(annulus.region.candidates, [&](const Edge& edge) {
    const bool is_in_the_hole = edge.a >= outer && inner > 2;
    return is_in_the_hole || crosses_hole(annulus, outer, edge);
  });
  annulus.region.components = outer == naive::hull_edges(annulus.points).size() ? 2 : 0;
  return annulus;
}

void expect_same_as_program(const Annulus& annulus) {
  const auto solution = solve_annulus(annulus.points, annulus.region, kInfinity, {});
  ASSERT_TRUE(solution);
  EXPECT_FALSE(solution->is_late);
  EXPECT_EQ(solution->triangles.size(), annulus.region.triangle_count());
  RegionSearch programs;
  programs.methods = {.annuli = false, .reductions = false, .programs = true};
  const RegionSolution expected = solve_region(annulus.points, annulus.region, programs);
  ASSERT_TRUE(expected.solved);
  const double optimum = expected.diagonals.enclosure().upper;
  EXPECT_NEAR(solution->diagonals.enclosure().upper, optimum, 1e-12 * optimum);
  EXPECT_LE(solution->lower_bound, optimum);
  EXPECT_GE(solution->lower_bound, optimum * (1 - 1e-12));
}

void compare_with_program(std::size_t instances, std::size_t largest, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < instances; ++i) {
    const std::size_t inner = std::vector<std::size_t>{1, 2, 3, 4, 7}[i % 5];
    const Annulus annulus =
        make_annulus(4 + i % (largest - 3), inner, .05 + .4 * hole_instances::uniform(random), random);
    if (annulus.region.components != 2) continue;  // the jitter has moved a point inside
    SCOPED_TRACE(testing::Message() << "instance " << i << " of seed " << seed);
    expect_same_as_program(annulus);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(AnnulusFace, EqualsTheLinearProgram) { compare_with_program(60, 14, 1); }

TEST(AnnulusFaceSlow, EqualsTheLinearProgramOnManyInstances) { compare_with_program(1500, 24, 2); }

// Wheels of odd numbers of spokes: two rounds about the hub, half of each triangle, may be lighter than one.
TEST(AnnulusFace, SolvesWheels) {
  Random random(5);
  for (std::size_t spokes = 11; spokes <= 25; ++spokes) {
    SCOPED_TRACE(spokes);
    Annulus annulus;
    append_ring(annulus.points, {0, 0}, 1, spokes, spokes % 2 == 0 ? 0 : 1e-3, random);
    annulus.points.push_back({0, 0});
    annulus.region = naive::region_of_hull(annulus.points);
    if (annulus.region.components == 2) expect_same_as_program(annulus);
  }
}

TEST(AnnulusFace, TakesTinyCoordinates) {
  Random random(6);
  Annulus annulus = make_annulus(8, 3, .2, random);
  while (annulus.region.components != 2) annulus = make_annulus(8, 3, .2, random);
  const auto expected = solve_annulus(annulus.points, annulus.region, kInfinity, {});
  for (Point& p : annulus.points) p = {p.x * 0x1p-1000, p.y * 0x1p-1000};
  const auto tiny = solve_annulus(annulus.points, annulus.region, kInfinity, {});
  ASSERT_TRUE(expected && tiny);
  EXPECT_EQ(tiny->triangles, expected->triangles);
  EXPECT_LE(tiny->lower_bound, tiny->diagonals.enclosure().upper);
  EXPECT_GE(tiny->lower_bound, tiny->diagonals.enclosure().upper * (1 - 1e-12));
}

TEST(AnnulusFace, RefusesWhatHasNoTriangulation) {
  const std::vector<Point> points{{0, 0}, {8, 0}, {8, 8}, {0, 8}, {4, 3}};
  FaceRegion region = naive::region_of_hull(points);
  region.candidates = {{0, 4}, {1, 4}, {2, 4}};
  EXPECT_FALSE(solve_annulus(points, region, kInfinity, {}));
  region.candidates.push_back({3, 4});
  const auto solution = solve_annulus(points, region, kInfinity, {});
  ASSERT_TRUE(solution);
  EXPECT_EQ(solution->triangles.size(), 4);
}

TEST(AnnulusFace, StopsAtTheDeadline) {
  Random random(7);
  Annulus annulus = make_annulus(9, 1, .2, random);
  EXPECT_FALSE(solve_annulus(annulus.points, annulus.region, kInfinity, std::chrono::steady_clock::time_point::min()));
}

TEST(Strip, EveryTriangulationContainsAnUnavoidableEdge) {
  Random random(8);
  for (std::size_t i = 0; i < 20; ++i) {
    const Annulus annulus = make_annulus(7, 1, .3, random);
    if (annulus.region.components != 2) continue;
    const auto strip = make_strip(annulus.points, annulus.region);
    ASSERT_TRUE(strip);
    const std::vector<CrossEdge> unavoidable = unavoidable_edges(annulus.points, *strip);
    for (const char* algorithm : {"delaunay", "sweep", "greedy"}) {
      const auto edges = edges_of(solve_and_check(algorithm, annulus.points).triangulation);
      EXPECT_TRUE(std::any_of(unavoidable.begin(), unavoidable.end(), [&](const CrossEdge& edge) {
        const Edge here = make_edge(strip->outer.vertex_at(edge.outer), strip->inner.vertex_at(edge.inner));
        return std::binary_search(edges.begin(), edges.end(), here);
      }));
    }
  }
}

// Each candidate has one course per period: those across, and those along either chain.
TEST(Strip, HoldsEachCandidateOnce) {
  Random random(9);
  for (const std::size_t inner : {1U, 2U, 5U}) {
    Annulus annulus = make_annulus(10, inner, .3, random);
    while (annulus.region.components != 2) annulus = make_annulus(10, inner, .3, random);
    const auto strip = make_strip(annulus.points, annulus.region);
    ASSERT_TRUE(strip);
    std::size_t edges = 0;
    for (const auto* rows : {&strip->outer.chord, &strip->inner.chord, &strip->across}) {
      for (const auto& row : *rows) edges += row.size();
    }
    EXPECT_EQ(edges, annulus.region.candidates.size() + annulus.region.boundary.size());
  }
}

}  // namespace
}  // namespace mwt
