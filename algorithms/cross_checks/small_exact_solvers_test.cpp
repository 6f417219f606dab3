// The small exact solvers check each other: three independent methods, one answer.
#include <algorithm>
#include <cmath>

#include "algorithms/common/testing/solver_testing.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/convex_hull.h"
#include "geometry/point_set.h"

namespace mwt {
namespace {

const std::vector<std::string> kSolvers = {"brute_force", "subset_dp", "triangle_lp"};
const std::vector<std::string> kCounters = {"brute_force", "subset_dp"};

struct SmallInstance {
  std::string name;
  std::vector<Point> points;
};

// Appends an instance of the family unless it has none of this size or it is no point set (all collinear).
void append(std::vector<SmallInstance>& instances, const std::string& family, Index n, std::uint64_t seed,
            const std::map<std::string, std::string>& parameters = {}) {
  const std::string name = family + " n=" + std::to_string(n) + " seed=" + std::to_string(seed);
  try {
    instances.push_back({name, make_point_set(generate(family, n, seed, parameters), name).points});
  } catch (const InputError&) {
  }
}

// Every family of the registry at every size from 3 to 11.
std::vector<SmallInstance> small_instances() {
  constexpr std::uint64_t kSeeds = 10;
  std::vector<SmallInstance> instances;
  for (const GeneratorInfo& family : generators()) {
    for (Index n = 3; n <= 11; ++n) {
      for (std::uint64_t seed = 1; seed <= (family.seeded ? kSeeds : 1); ++seed) {
        append(instances, family.name, n, seed);
      }
    }
  }
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {  // many collinear triples and cocircular quadruples
    append(instances, "integer_uniform", static_cast<Index>(4 + seed % 8), seed, {{"range", "4"}});
    append(instances, "lattice", static_cast<Index>(4 + seed % 8), seed, {{"holes", "0.4"}});
  }
  return instances;
}

TEST(SmallExactSolvers, AgreeOnAThousandInstancesOfAllFamilies) {
  const std::vector<SmallInstance> instances = small_instances();
  EXPECT_GE(instances.size(), 1000U);
  for (const auto& [name, points] : instances) {
    SCOPED_TRACE(name);
    const Solution enumerated = solve_to_optimality("brute_force", points);
    const Solution counted = solve_to_optimality("subset_dp", points);
    const Solution covered = solve_to_optimality("triangle_lp", points);
    ASSERT_FALSE(HasFailure());
    ASSERT_EQ(enumerated.count, counted.count);
    ASSERT_TRUE(overlap(*enumerated.optimum, *counted.optimum));
    ASSERT_TRUE(overlap(*enumerated.optimum, *covered.optimum));
    ASSERT_TRUE(overlap(*counted.optimum, *covered.optimum));
  }
}

TEST(SmallExactSolvers, FindTheReportsExample) {
  const std::vector<Point> points = generate("report_example", 10, 1);
  for (const std::string& solver : kSolvers) {
    const Solution solution = solve_to_optimality(solver, points);
    EXPECT_NEAR(solution.optimum->middle(), 70.9585925243, 5e-11) << solver;
    EXPECT_EQ(solution.count, solver == "triangle_lp" ? std::optional<std::string>() : "586") << solver;
  }
}

TEST(SmallExactSolvers, CountCatalanNumbersInConvexPosition) {
  std::uint64_t catalan = 1;  // of n - 2
  for (Index n = 3; n <= 12; ++n) {
    std::vector<Point> points;
    for (Index i = 0; i < n; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i * i)});
    for (const std::string& solver : kCounters) {
      EXPECT_EQ(solve_to_optimality(solver, points).count, std::to_string(catalan)) << solver << ' ' << n;
    }
    catalan = catalan * 2 * (2 * n - 3) / n;
  }
}

TEST(SmallExactSolvers, FindTheClosedFormOnGrids) {
  for (const Index g : {2, 3}) {
    const std::vector<Point> points = generate("grid", g * g, 1);
    const double side = static_cast<double>(g);
    const double optimum = 2 * side * (side - 1) + std::sqrt(2) * (side - 1) * (side - 1);
    for (const std::string& solver : kSolvers) {
      EXPECT_NEAR(solve_to_optimality(solver, points).optimum->middle(), optimum, 1e-12 * optimum) << solver;
    }
  }
}

TEST(SmallExactSolvers, FindTheUniqueTriangulationOfAFan) {
  for (Index n = 4; n <= 12; ++n) {
    const int middle = static_cast<int>(n / 2);
    std::vector<Point> points;
    double optimum = n - 2.0;
    for (int i = 0; i <= static_cast<int>(n) - 2; ++i) {
      points.push_back({static_cast<double>(i), 0});
      optimum += std::hypot(i - middle, 1);
    }
    points.push_back({static_cast<double>(middle), 1});
    for (const std::string& solver : kSolvers) {
      const Solution solution = solve_to_optimality(solver, points);
      EXPECT_NEAR(solution.optimum->middle(), optimum, 1e-12 * optimum) << solver;
      EXPECT_EQ(solution.count.value_or("1"), "1") << solver;
    }
  }
}

TEST(SmallExactSolvers, FindTheClosedFormOnTwoCollinearRows) {
  for (const double gap : {0.5, 1.0, 2.0, 10.0}) {
    constexpr int kPerRow = 6;
    std::vector<Point> points;
    for (int i = 0; i < kPerRow; ++i) points.insert(points.end(), {{i + 0.0, 0.0}, {i + 0.0, gap}});
    const double optimum = 2.0 * (kPerRow - 1) + kPerRow * gap + (kPerRow - 1) * std::hypot(1, gap);
    for (const std::string& solver : kSolvers) {
      const Solution solution = solve_to_optimality(solver, points);
      EXPECT_NEAR(solution.optimum->middle(), optimum, 1e-12 * optimum) << solver;
      EXPECT_EQ(solution.count.value_or("252"), "252") << solver;  // the order of 5 + 5 triangles: 10 over 5
    }
  }
}

// An interior point can make the optimum lighter than the hull's: the spokes win.
TEST(SmallExactSolvers, GoBelowTheHullBoundWhereTheReportSaysNobodyCan) {
  const std::vector<Point> points = generate("hull_bound_counterexample", 13, 1);
  const Index centre = static_cast<Index>(std::find(points.begin(), points.end(), Point{0, 0}) - points.begin());
  ASSERT_LT(centre, points.size());
  std::vector<Point> polygon = points;
  polygon.erase(polygon.begin() + centre);
  const double hull = cycle_length(points, convex_hull(points)).middle();
  for (const std::string& solver : kSolvers) {
    const double hull_optimum = solve_to_optimality(solver, polygon).optimum->middle();
    const Solution solution = solve_to_optimality(solver, points);
    EXPECT_NEAR(hull_optimum - hull, 493.7304, 5e-5) << solver;
    EXPECT_NEAR(hull_optimum, 848.848, 5e-4) << solver;
    EXPECT_NEAR(solution.optimum->middle() - hull, 491.7044, 5e-5) << solver;
    EXPECT_LT(solution.optimum->upper, 846.8225) << solver;
    const std::vector<Edge> edges = edges_of(solution.triangulation);
    const auto is_spoke = [&](const Edge& edge) { return edge.a == centre || edge.b == centre; };
    EXPECT_EQ(std::count_if(edges.begin(), edges.end(), is_spoke), 12) << solver;
  }
}

TEST(SmallExactSolvers, AgreeFarFromOrdinaryCoordinates) {
  for (const double scale : {1e300, 1e150, 1e-150, 1e-290}) {
    std::vector<Point> points = generate("uniform", 9, 5);
    for (Point& p : points) p = {p.x * scale, p.y * scale};
    const Interval optimum = *solve_to_optimality("brute_force", points).optimum;
    EXPECT_TRUE(overlap(optimum, *solve_to_optimality("subset_dp", points).optimum)) << scale;
    EXPECT_TRUE(overlap(optimum, *solve_to_optimality("triangle_lp", points).optimum)) << scale;
  }
}

TEST(SmallExactSolvers, ReturnATriangulationWhenTheDeadlineHasPassed) {
  const std::vector<Point> points = generate("uniform", 11, 1);
  const Interval optimum = *solve_to_optimality("brute_force", points).optimum;
  for (const std::string& solver : kSolvers) {
    const Solution solution = solve_and_check(solver, points, {}, Context::Clock::now());
    EXPECT_EQ(solution.stop_reason, StopReason::deadline) << solver;
    EXPECT_FALSE(solution.count) << solver;
    EXPECT_TRUE(overlap(solution.optimum.value_or(optimum), optimum)) << solver;
  }
}

TEST(SmallExactSolvers, SayWhatTheyWouldTake) {
  for (const std::string& solver : kSolvers) {
    const std::vector<Point> points = generate("uniform", 6, 1);
    EXPECT_NO_THROW((void)solve_and_check(solver, points, {{"max_points", "6"}})) << solver;
    EXPECT_THROW((void)solve_and_check(solver, points, {{"max_points", "5"}}), NotApplicable) << solver;
  }
  const std::vector<Point> points = generate("uniform", 3, 1);
  EXPECT_THROW((void)solve_and_check("brute_force", points, {{"max_points", "17"}}), InputError);
  EXPECT_THROW((void)solve_and_check("subset_dp", points, {{"max_points", "27"}}), InputError);
}

TEST(SmallExactSolvers, AgreeBeyondEnumeration) {
  for (const char* family : {"uniform", "clustered", "integer_uniform", "wheel", "near_collinear"}) {
    const std::vector<Point> points = generate(family, 16, 3);
    const Solution counted = solve_to_optimality("subset_dp", points);
    EXPECT_TRUE(overlap(*counted.optimum, *solve_to_optimality("triangle_lp", points).optimum)) << family;
  }
}

}  // namespace
}  // namespace mwt
