#include "algorithms/triangle_lp/triangle_lp.h"

#include <algorithm>
#include <cmath>

#include "algorithms/solver_testing.h"
#include "generators/registry.h"
#include "geometry/cpu_clock.h"

namespace mwt {
namespace {

double optimum_of(Points points) { return solve_to_optimality("triangle_lp", points).optimum->middle(); }

TEST(TriangleLp, FindsTheClosedFormOnGrids) {
  for (const Index g : {4U, 6U, 8U}) {
    const double side = static_cast<double>(g);
    const double optimum = 2 * side * (side - 1) + std::sqrt(2) * (side - 1) * (side - 1);
    EXPECT_NEAR(optimum_of(generate("grid", g * g, 1)), optimum, 1e-12 * optimum);
  }
}

TEST(TriangleLp, FindsTheClosedFormOnTwoCollinearRows) {
  constexpr int kPerRow = 25;
  std::vector<Point> points;
  for (int i = 0; i < kPerRow; ++i) points.insert(points.end(), {{i + 0.0, 0.0}, {i + 0.0, 3.0}});
  const double optimum = 2.0 * (kPerRow - 1) + kPerRow * 3.0 + (kPerRow - 1) * std::sqrt(10.0);
  EXPECT_NEAR(optimum_of(points), optimum, 1e-12 * optimum);
}

TEST(TriangleLp, ScalesByPowersOfTwoExactly) {
  const std::vector<Point> points = generate("clustered", 30, 4);
  const Interval optimum = *solve_to_optimality("triangle_lp", points).optimum;
  for (const int exponent : {-900, -3, 500, 900}) {
    std::vector<Point> scaled = points;
    for (Point& p : scaled) p = {std::ldexp(p.x, exponent), std::ldexp(p.y, exponent)};
    const Interval found = *solve_to_optimality("triangle_lp", scaled).optimum;
    EXPECT_EQ(found.upper, std::ldexp(optimum.upper, exponent)) << exponent;
  }
}

TEST(TriangleLp, TakesDozensOfPointsOfEveryFamily) {
  for (const GeneratorInfo& family : generators()) {
    if (family.fixed_n != 0 || family.name == "with_duplicates") continue;
    const Index wanted = family.name == "grid" ? 36 : 40;
    const Index n = family.largest_n == 0 ? wanted : std::min(wanted, family.largest_n);
    SCOPED_TRACE(family.name);
    (void)solve_to_optimality("triangle_lp", generate(family.name, n, 1));
  }
}

TEST(TriangleLp, ObeysTheDeadline) {
  const std::vector<Point> points = generate("circle", 150, 1);
  const auto start = Context::Clock::now();
  const auto deadline = start + std::chrono::milliseconds(50);
  const Solution solution = solve_and_check("triangle_lp", points, {}, deadline);
  EXPECT_EQ(solution.stop_reason, StopReason::deadline);
  ASSERT_TRUE(solution.optimum);
  EXPECT_GT(solution.optimum->lower, 0);
}

TEST(TriangleLpSlow, BoundsAHundredPointsOfEveryFamily) {
  for (const GeneratorInfo& family : generators()) {
    const bool has_a_hundred = family.fixed_n == 0 && (family.largest_n == 0 || family.largest_n >= 100);
    if (!has_a_hundred || family.name == "with_duplicates") continue;
    const auto deadline = Context::Clock::now() + std::chrono::seconds(5);
    const Solution solution = solve_and_check("triangle_lp", generate(family.name, 100, 1), {}, deadline);
    ASSERT_TRUE(solution.optimum) << family.name;
    EXPECT_GT(solution.optimum->lower, 0) << family.name;
    EXPECT_LE(solution.optimum->relative_width(), solution.stopped_early() ? 0.99 : 1e-12) << family.name;
  }
}

// GLPK gives up its dual simplex method on one of these programs and goes on with the primal one, for which its time
// limit used to begin anew. CPU time, for on a busy machine the clock goes on without this process.
TEST(TriangleLpSlow, EndsAtTheDeadlineWhenGlpkChangesItsMethod) {
  const std::vector<Point> points = generate("delaunay_arc", 100, 1);
  for (const int seconds : {4, 8, 16}) {
    const double start = process_cpu_time_s();
    (void)solve_and_check("triangle_lp", points, {}, Context::Clock::now() + std::chrono::seconds(seconds));
    EXPECT_LE(process_cpu_time_s() - start, seconds + 0.3);
  }
}

TEST(TriangleLpSlow, TakesTwoHundredUniformPoints) {
  (void)solve_to_optimality("triangle_lp", generate("uniform", 200, 1));
}

}  // namespace
}  // namespace mwt
