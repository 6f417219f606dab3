#include "algorithms/greedy/pockets/pockets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "algorithms/greedy/bounds/certified_edges.h"
#include "algorithms/greedy/ears/ear_insertion.h"
#include "algorithms/greedy/faces/face_boundary.h"
#include "algorithms/greedy/faces/fixed_stars.h"
#include "algorithms/greedy/greedy_builder.h"
#include "algorithms/greedy/greedy_marks.h"
#include "algorithms/greedy/testing/greedy_testing.h"
#include "geometry/checker.h"
#include "geometry/mesh/edge_order.h"

namespace mwt {

namespace {

struct Taken {
  std::vector<Edge> fixed;
  std::size_t ears = 0;
};

// Takes what pockets there are from all faces at once, between the hull's edges and the certified ones if requested.
Taken take(Points points, bool fixes_certified, std::size_t stretch, const std::string& what) {
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  std::vector<MeshEdge> face;
  for (MeshEdge e = 0; e < mesh.edge_count(); ++e) {
    const bool fixed = mesh.is_hull(e) || (fixes_certified && is_certainly_greedy(mesh, e));
    if (fixed) mesh.marks(e) |= kFixedMark;
    if (!fixed) face.push_back(e);
  }
  const Context context;
  const EdgeOrder order(mesh.points(), mesh.labels());
  FixedStars stars(mesh);
  EarInsertion insertion(mesh, stars);
  FaceBoundary boundary(mesh, face);
  const std::size_t ears = take_pockets({mesh, order, stars, insertion, context}, boundary, stretch);
  test::expect_constrained_delaunay(mesh, what);
  EXPECT_FALSE(find_violation(points, mesh.triangulation())) << what;
  return {test::fixed_edges(mesh), ears};
}

// Returns how many ears were taken.
std::size_t expect_pocket_ears_greedy(Points points, const std::string& what) {
  const std::vector<Edge> expected = test::greedy_edges(points);
  std::size_t ears = 0;
  for (const bool fixes_certified : {false, true}) {
    for (const std::size_t stretch : {7U, 64U, 65536U}) {
      const Taken taken = take(points, fixes_certified, stretch, what);
      EXPECT_TRUE(std::includes(expected.begin(), expected.end(), taken.fixed.begin(), taken.fixed.end())) << what;
      ears += taken.ears;
    }
  }
  return ears;
}

// Arcs of many sizes around random centres, here and there with steps of random length, some of them bent both ways.
std::vector<Point> make_curves(std::size_t n, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&random] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Point> points;
  while (points.size() < n) {
    const Point centre{8 * unit(), 8 * unit()};
    const double radius = .2 + 2 * unit(), wave = .1 * unit(), start = 2 * std::numbers::pi * unit();
    const double step = .02 + .05 * unit(), jitter = random() % 2 == 0 ? 0 : step * unit();
    const std::size_t length = 10 + random() % 80;
    for (std::size_t i = 0; i < length && points.size() < n; ++i) {
      const double angle = start + step * static_cast<double>(i) + jitter * unit();
      const double r = radius + wave * std::sin(5 * angle);
      points.push_back({centre.x + r * std::cos(angle), centre.y + r * std::sin(angle)});
    }
  }
  return make_point_set(points, "curves").points;
}

TEST(Pockets, EarsAreGreedy) { EXPECT_GT(test::sum_over_instances(6, 60, expect_pocket_ears_greedy), 100U); }

TEST(PocketsSlow, EarsAreGreedyOnManyInstances) {
  EXPECT_GT(test::sum_over_instances(80, 120, expect_pocket_ears_greedy), 10'000U);
}

TEST(Pockets, EarsOfCurvesAreGreedy) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_GT(expect_pocket_ears_greedy(make_curves(150, seed), "curves, seed " + std::to_string(seed)), 50U);
  }
}

TEST(PocketsSlow, EarsOfManyCurvesAreGreedy) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    EXPECT_GT(expect_pocket_ears_greedy(make_curves(300, seed), "curves, seed " + std::to_string(seed)), 50U);
  }
}

// Ears double along the spiral, from its inner end on: nearly all of them are found, whatever the stretches.
TEST(Pockets, HoldNearlyAllEarsOfASpiral) {
  const std::vector<Point> points = generate("spiral", 20'000, 1, {});
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  const std::size_t ears = build_greedy(mesh, Context{}).ears;
  for (const std::size_t stretch : {1000U, 65536U}) {
    EXPECT_GT(take(points, true, stretch, "spiral").ears, ears * 8 / 10) << stretch << " of " << ears;
  }
}

}  // namespace

}  // namespace mwt
