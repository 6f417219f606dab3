#include "algorithms/annealing/annealing.h"

#include <gtest/gtest.h>

#include "algorithms/common/start.h"
#include "algorithms/flip/flip.h"
#include "base/error.h"
#include "geometry/checker.h"
#include "geometry/testing/shapes.h"
#include "geometry/weight.h"

namespace mwt {

namespace {

using test::make_shape;
using test::ShapeFamily;
using test::shapes;

Solution solve(Points points, const std::map<std::string, std::string>& given, std::uint64_t seed = 1,
               Deadline deadline = {}) {
  Context context;
  context.parameters = Parameters("annealing", annealing_entry().parameters, given);
  context.seed = seed;
  context.deadline = deadline;
  return annealing_entry().function(points, context);
}

TEST(Annealing, EndsAtAValidLocalOptimumNoWorseThanItsStart) {
  for (const ShapeFamily& shape : shapes()) {
    for (const std::size_t n : {3, 4, 5, 10, 100, 1000}) {
      const std::vector<Point> points = make_shape(shape, n, n);
      const Solution solution = solve(points, {{"start", "greedy"}, {"proposals", "5000"}});
      const auto violation = find_violation(points, solution.triangulation);
      EXPECT_FALSE(violation) << shape.name << " n=" << n << ": " << violation->message;
      EXPECT_TRUE(is_flip_optimal(PlanarMesh(points, solution.triangulation))) << shape.name << " n=" << n;
    }
  }
}

TEST(Annealing, BeatsPlainFlips) {
  const std::vector<Point> points = make_shape(shapes().front(), 500, 1);
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  flip_to_local_optimum(mesh, FlipOrder::stack, Context{});
  EXPECT_LT(weight(points, solve(points, {{"proposals", "2000000"}}).triangulation).upper,
            weight(points, mesh.triangulation()).lower);
}

TEST(Annealing, IsDeterministicForASeed) {
  const std::vector<Point> points = make_shape(shapes().front(), 300, 2);
  const auto edges = [&](std::uint64_t seed) {
    return edges_of(solve(points, {{"proposals", "30000"}}, seed).triangulation);
  };
  EXPECT_EQ(edges(1), edges(1));
  EXPECT_NE(edges(1), edges(2));
}

TEST(Annealing, AcceptsWorseStatesWhileItIsHot) {
  const std::vector<Point> points = make_shape(shapes().front(), 200, 3);
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  const double before = weight(points, mesh.triangulation()).upper;
  anneal(mesh, {50000, 1, 1, 1}, Context{});
  EXPECT_FALSE(find_violation(points, mesh.triangulation()));
  EXPECT_GT(weight(points, mesh.triangulation()).lower, before);
}

TEST(Annealing, StopsAtTheDeadline) {
  const std::vector<Point> points = make_shape(shapes().front(), 1000, 4);
  const Solution solution = solve(points, {{"proposals", "1000000000"}}, 1, Context::Clock::now());
  EXPECT_EQ(solution.stop_reason, StopReason::deadline);
  EXPECT_FALSE(find_violation(points, solution.triangulation));
}

TEST(Annealing, NamesBadParameters) {
  const std::vector<Point> points = make_shape(shapes().front(), 10, 5);
  EXPECT_THROW((void)solve(points, {{"proposals", "-1"}}), InputError);
  EXPECT_THROW((void)solve(points, {{"final_temperature", "0"}}), InputError);
  EXPECT_THROW((void)solve(points, {{"final_temperature", "1"}}), InputError);
}

}  // namespace

}  // namespace mwt
