#include "algorithms/triangle_lp/triangle_lp.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "algorithms/common/testing/solver_testing.h"
#include "base/cpu_clock.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/point_set.h"

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
    const Index n = family.max_n == 0 ? wanted : std::min(wanted, family.max_n);
    SCOPED_TRACE(family.name);
    (void)solve_to_optimality("triangle_lp", generate(family.name, n, 1));
  }
}

// The flow through slivers made dual values of 1e14 and 1e118 to begin with, in which all costs were lost: the first
// set stayed at [6.157, 6.414], the second went round in circles between two linear programs.
TEST(TriangleLp, ProvesSetsWithSlivers) {
  const std::vector<Point> one_ulp_apart = {{2.0000000000000004, 1},
                                            {1.9999999999999996, 2},
                                            {1, 0.9999999999999999},
                                            {1.0000000000000002, 1.0000000000000002},
                                            {2.000000000000001, 1}};
  EXPECT_NEAR(solve_to_optimality("triangle_lp", one_ulp_apart).optimum->upper, 4 + 1 + std::sqrt(2), 1e-12);
  const std::vector<Point> of_all_magnitudes = {
      {3.5162316196218699e-171, -1.3562012445429335e+18},  {1.5171139842569944e-151, -6.2888267970869081e-101},
      {-1.5261986338178129e-264, 3.1263724040021123e+194}, {-4.2665140037529131e-196, -8.5754265695675796e-125},
      {8.6565821759343319e+118, -2.7534070439217889e-71},  {9.3541687121747286e+283, 5.9554197338584134e+168},
      {-4.5618959110025366e+35, -9.7395488713233629e-112}, {-1.4756951322703655e+234, 4.6241893475994146e-56}};
  EXPECT_EQ(solve_to_optimality("triangle_lp", of_all_magnitudes).optimum->upper,
            solve_to_optimality("subset_dp", of_all_magnitudes).optimum->upper);
}

// Coordinates of all magnitudes, or all within a few units in the last place of a small lattice.
std::vector<Point> random_slivers(std::mt19937_64& random) {
  const bool is_lattice = random() % 2 == 0;
  std::vector<Point> points(4 + random() % 7);
  const auto coordinate = [&] {
    if (is_lattice) return 1 + static_cast<double>(random() % 3) + 0x1p-52 * static_cast<double>(random() % 5);
    return std::ldexp(static_cast<double>(random() % 2001) - 1000, static_cast<int>(random() % 1900) - 1000);
  };
  for (Point& p : points) p = {coordinate(), coordinate()};
  return points;
}

TEST(TriangleLp, AgreesOnRandomSlivers) {
  std::mt19937_64 random(1);
  int sets = 0;
  while (sets < 2000) {
    std::vector<Point> points;
    try {
      points = make_point_set(random_slivers(random), "random").points;
    } catch (const InputError&) {
      continue;
    }
    ++sets;
    const Interval optimum = *solve_to_optimality("triangle_lp", points).optimum;
    EXPECT_TRUE(overlap(optimum, *solve_to_optimality("subset_dp", points).optimum)) << sets;
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
    const bool has_a_hundred = family.fixed_n == 0 && (family.max_n == 0 || family.max_n >= 100);
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
