#include "algorithms/patch/patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/common/beta_skeleton_edges.h"
#include "algorithms/common/start.h"
#include "algorithms/common/testing/instances.h"
#include "algorithms/flip/flip.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/patch/patch_polygon.h"
#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/convex_hull.h"
#include "geometry/testing/shapes.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using test::context_for;
using test::make_shape;
using test::ShapeFamily;
using test::shapes;
using test::solve_checked;

const ShapeFamily& shape_named(const std::string& name) {
  for (const ShapeFamily& shape : shapes()) {
    if (shape.name == name) return shape;
  }
  throw std::out_of_range(name);
}

TEST(Patch, IsValidAndNeverWorseThanItsStartOnAllShapes) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 5, 10, 100, 1000}) {
      const std::vector<Point> points = make_shape(shape, n, n);
      for (const std::string start : {"greedy", "delaunay", "random"}) {
        Context context = context_for(patch_entry(), {{"start", start}});
        const Interval before = weight(points, start_mesh(points, context).triangulation());
        const Solution solution = patch_entry().function(points, context);
        const auto violation = find_violation(points, solution.triangulation);
        ASSERT_FALSE(violation) << shape.name << " n=" << n << ' ' << start << ": " << violation->message;
        EXPECT_LE(weight(points, solution.triangulation).lower, before.upper) << shape.name << " n=" << n;
      }
    }
  }
}

// The optimum of a convex polygon, by the textbook's recurrence on its corners in order.
double optimum_of_convex(Points points) {
  const std::vector<Index> hull = convex_hull(points);
  const std::size_t n = hull.size();
  const auto distance = [&](std::size_t i, std::size_t j) {
    return std::hypot(points[hull[i]].x - points[hull[j]].x, points[hull[i]].y - points[hull[j]].y);
  };
  std::vector<std::vector<double>> cost(n, std::vector<double>(n, 0));
  for (std::size_t length = 2; length < n; ++length) {
    for (std::size_t i = 0; i + length < n; ++i) {
      double best = std::numeric_limits<double>::infinity();
      for (std::size_t m = i + 1; m < i + length; ++m) best = std::min(best, cost[i][m] + cost[m][i + length]);
      cost[i][i + length] = best + distance(i, i + length);
    }
  }
  double boundary = 0;
  for (std::size_t i = 0; i < n; ++i) boundary += distance(i, (i + 1) % n);
  return cost[0][n - 1] - distance(0, n - 1) + boundary;
}

TEST(Patch, IsOptimalWhenOnePatchCoversAConvexPolygon) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const std::vector<Point> points = make_shape(shape_named("random_on_circle"), 5 + seed % 20, seed);
    for (const std::string start : {"greedy", "random"}) {
      const Solution solution = solve_checked(patch_entry(), points, {{"k", "30"}, {"start", start}});
      EXPECT_NEAR(weight(points, solution.triangulation).middle(), optimum_of_convex(points), 1e-9) << seed;
    }
  }
}

TEST(Patch, IsFlipOptimalAtTheEnd) {
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 200, 5);
    const Solution solution = solve_checked(patch_entry(), points, {{"start", "random"}, {"beta_skeleton", "off"}});
    // Patches of two triangles are flips; only those that rounding cannot certify may be left.
    Context context;
    PlanarMesh mesh(points, solution.triangulation);
    const FlipResult left = flip_to_local_optimum(mesh, FlipOrder::stack, context, true);
    const double total = weight(points, solution.triangulation).middle();
    for (const Flip& flip : left.trace) EXPECT_LT(flip.gain, 1e-12 * total) << shape.name;
  }
}

TEST(Patch, ClaimsNoImprovementOnTies) {
  for (const std::string name : {"full_lattice", "lattice_of_thirds"}) {
    const std::vector<Point> points = make_shape(shape_named(name), 400, 1);
    EXPECT_EQ(solve_checked(patch_entry(), points, {{"start", "greedy"}}).counters.at("improved"), 0) << name;
  }
}

TEST(Patch, LargerPatchesAreBetter) {
  const std::vector<Point> points = make_shape(shapes().front(), 3000, 1);
  double before = weight(points, greedy_triangulation(points)).lower;
  for (const std::string k : {"3", "6"}) {
    const double now = weight(points, solve_checked(patch_entry(), points, {{"k", k}}).triangulation).upper;
    EXPECT_LT(now, before) << k;
    before = now;
  }
}

TEST(Patch, WallsAreInTheBestTriangulationsFound) {
  for (const std::string name : {"uniform", "clustered", "log_radial"}) {
    const std::vector<Point> points = make_shape(shape_named(name), 300, 2);
    PlanarMesh delaunay = PlanarMesh::delaunay(points);
    mark_beta_skeleton(delaunay);
    const Solution solution = solve_checked(patch_entry(), points, {{"k", "12"}, {"beta_skeleton", "off"}});
    const std::vector<Edge> best = edges_of(solution.triangulation);
    std::size_t marked = 0;
    for (MeshEdge e = 0; e < delaunay.edge_count(); ++e) {
      if ((delaunay.marks(e) & kBetaSkeletonMark) == 0) continue;
      ++marked;
      EXPECT_TRUE(std::binary_search(best.begin(), best.end(), delaunay.labelled_edge(e))) << name;
    }
    EXPECT_GT(marked, 100U) << name;
  }
}

TEST(Patch, CopiesWallsToAGivenTriangulation) {
  const std::vector<Point> points = make_shape(shapes().front(), 300, 3);
  Context context = context_for(patch_entry(), {{"start", "mine.tri"}});
  EXPECT_THROW((void)patch_entry().function(points, context), InputError);
  context.start = greedy_triangulation(points);
  const Solution from_file = patch_entry().function(points, context);
  EXPECT_FALSE(find_violation(points, from_file.triangulation));
  EXPECT_NEAR(weight(points, from_file.triangulation).middle(),
              weight(points, solve_checked(patch_entry(), points, {}).triangulation).middle(), 1e-3);
}

TEST(Patch, IsDeterministic) {
  const std::vector<Point> points = make_shape(shapes().front(), 2000, 4);
  EXPECT_EQ(solve_checked(patch_entry(), points, {}).triangulation.triangles,
            solve_checked(patch_entry(), points, {}).triangulation.triangles);
}

TEST(Patch, StopsAtTheDeadlineAndAfterItsPasses) {
  const std::vector<Point> points = make_shape(shapes().front(), 20000, 5);
  Context context = context_for(patch_entry(), {{"start", "delaunay"}});
  context.deadline = Context::Clock::now();
  const Solution solution = patch_entry().function(points, context);
  EXPECT_EQ(solution.stop_reason, StopReason::deadline);
  EXPECT_FALSE(find_violation(points, solution.triangulation));
  EXPECT_LT(solve_checked(patch_entry(), points, {{"passes", "1"}}).counters.at("patches"),
            solve_checked(patch_entry(), points, {}).counters.at("patches"));
}

// Between clusters, a few long edges weigh as much as thousands of short ones.
TEST(Patch, LargerPatchesAtLongEdgesOnlyHelp) {
  std::size_t helped = 0;
  for (const ShapeFamily& shape : shapes()) {
    const std::vector<Point> points = make_shape(shape, 1500, 8);
    const auto weight_with = [&](const std::string& long_k) {
      return weight(points, solve_checked(patch_entry(), points, {{"long_k", long_k}}).triangulation);
    };
    const Interval without = weight_with("1"), with = weight_with("0");
    EXPECT_LE(with.lower, without.upper) << shape.name;
    helped += with.upper < without.lower ? 1 : 0;
  }
  EXPECT_GT(helped, 0U);
}

TEST(Patch, NamesBadParameters) {
  const std::vector<Point> points = make_shape(shapes().front(), 10, 6);
  EXPECT_THROW((void)solve_checked(patch_entry(), points, {{"k", "1"}}), InputError);
  EXPECT_THROW((void)solve_checked(patch_entry(), points, {{"k", "1000"}}), InputError);
  EXPECT_THROW((void)solve_checked(patch_entry(), points, {{"passes", "-1"}}), InputError);
  EXPECT_THROW((void)solve_checked(patch_entry(), points, {{"long_k", "1000"}}), InputError);
}

}  // namespace

}  // namespace mwt
