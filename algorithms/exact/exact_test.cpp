#include "algorithms/exact/exact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "algorithms/common/testing/counted_time.h"
#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/instruction_sets.h"
#include "algorithms/exact/testing/stage_testing.h"

namespace mwt {
namespace {

using stage_testing::append;
using stage_testing::instances_of_all_families;
using stage_testing::NamedInstance;

std::vector<Triangle> canonical(const Solution& solution) { return canonical_triangles(solution.triangulation); }

Solution solve_with_threads(Points points, int threads) {
  Context context;
  context.threads = threads;
  return exact(points, context);
}

void expect_agreement(const std::vector<NamedInstance>& instances, const std::string& reference) {
  for (const auto& [name, points] : instances) {
    SCOPED_TRACE(name);
    const Solution solution = solve_to_optimality("exact", points);
    const Solution other = solve_to_optimality(reference, points);
    ASSERT_FALSE(testing::Test::HasFailure());
    ASSERT_TRUE(overlap(*solution.optimum, *other.optimum))
        << solution.optimum->middle() << ", " << reference << ": " << other.optimum->middle();
  }
}

// Collinear points and cocircular integer points, equal lengths: n is 3 to 13.
std::vector<NamedInstance> lattice_instances(std::uint64_t seeds) {
  std::vector<NamedInstance> instances;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const auto n = static_cast<Index>(3 + seed % 11);
    append(instances, "integer_uniform", n, seed, {{"range", "4"}});
    append(instances, "integer_uniform", n, seed, {{"range", "8"}});
    append(instances, "integer_uniform", n, seed, {{"range", "60"}});
    append(instances, "lattice", n, seed, {{"holes", "0.4"}});
    append(instances, "integer_circle", n, seed);
  }
  for (Index n = 3; n <= 13; ++n) {
    append(instances, "grid", n);
    for (const char* rows : {"2", "3", "4"}) append(instances, "collinear_rows", n, 1, {{"rows", rows}});
  }
  return instances;
}

TEST(Exact, AgreesWithBruteForceOnAllFamilies) {
  const auto instances = instances_of_all_families({3, 4, 5, 6, 7, 8, 9}, 8);
  EXPECT_GE(instances.size(), 600U);
  expect_agreement(instances, "brute_force");
}

TEST(Exact, AgreesWithSubsetDpOnAllFamilies) {
  const auto instances = instances_of_all_families({6, 7, 8, 9, 10, 11, 12, 13}, 10);
  EXPECT_GE(instances.size(), 900U);
  expect_agreement(instances, "subset_dp");
}

TEST(Exact, AgreesWithTheTriangleProgramOnAllFamilies) {
  const auto instances = instances_of_all_families({9, 11, 13, 20}, 2);
  EXPECT_GE(instances.size(), 100U);
  expect_agreement(instances, "triangle_lp");
}

TEST(Exact, AgreesWithSubsetDpOnLatticesAndCircles) {
  const auto instances = lattice_instances(130);
  EXPECT_GE(instances.size(), 600U);
  expect_agreement(instances, "subset_dp");
}

TEST(ExactSlow, AgreesOnManyMoreInstances) {
  expect_agreement(lattice_instances(800), "subset_dp");
  expect_agreement(instances_of_all_families({8, 11, 14}, 40), "subset_dp");
  expect_agreement(instances_of_all_families({30, 60}, 3), "triangle_lp");
}

// Coordinates of many magnitudes: floats cannot tell small triangles at the end of long edges from flat ones.
std::vector<Point> mixed_scales(std::size_t n, std::mt19937_64& random) {
  std::vector<Point> points(n);
  const auto coordinate = [&] {
    const double magnitude = std::ldexp(static_cast<double>(random() % 8), static_cast<int>(random() % 40));
    return random() % 2 == 0 ? magnitude : -magnitude;
  };
  for (Point& p : points) {
    p.x = coordinate();
    p.y = coordinate();
  }
  return points;
}

// Far points and near ones in three rows that are very close together.
std::vector<Point> narrow_rows(std::size_t n, std::mt19937_64& random) {
  std::vector<Point> points(n);
  for (Point& p : points) {
    const std::uint64_t x = random() % 2 == 0 ? random() % 1'000'000'000 : 500'000'000 + random() % 10;
    p = {static_cast<double>(x), static_cast<double>(random() % 3)};
  }
  return points;
}

void compare_on_mixed_scales(std::uint64_t seeds) {
  std::vector<NamedInstance> instances;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    std::mt19937_64 random(seed);
    const std::size_t n = 5 + seed % 9;
    for (const auto make : {mixed_scales, narrow_rows}) {
      const std::string name = "mixed scales n=" + std::to_string(n) + " seed=" + std::to_string(seed);
      try {
        instances.push_back({name, make_point_set(make(n, random), name).points});
      } catch (const InputError&) {  // all collinear
      }
    }
  }
  expect_agreement(instances, "subset_dp");
}

TEST(Exact, AgreesWithSubsetDpWhereScalesMix) { compare_on_mixed_scales(500); }

TEST(ExactSlow, AgreesWithSubsetDpWhereScalesMix) { compare_on_mixed_scales(10'000); }

// The LMT stage leaves an edge that crosses a certain one.
TEST(Exact, StandsCandidatesThatCrossCertainEdges) {
  const std::vector<Point> points{{16777216, -24}, {-98304, -3072},      {896, 458752},        {-655360, 5120},
                                  {-8, -7340032},  {-268435456, 327680}, {15032385536, -32768}};
  expect_agreement({{"seven points", points}}, "brute_force");
}

TEST(Exact, AgreesWithPolygonDpInConvexPosition) {
  for (const Index n : {3, 4, 5, 8, 20, 50, 111, 200}) {
    std::vector<NamedInstance> instances;
    append(instances, "circle", n);
    append(instances, "integer_circle", n, n);
    expect_agreement(instances, "polygon_dp");
  }
  // Collinear runs along the hull.
  std::vector<Point> square;
  for (int i = 0; i < 20; ++i) {
    square.insert(square.end(), {{i + 0.0, 0.0}, {20.0, i + 0.0}, {20.0 - i, 20.0}, {0.0, 20.0 - i}});
  }
  expect_agreement({{"square", square}}, "polygon_dp");
}

TEST(Exact, SolvesCocircularPoints) { (void)solve_to_optimality("exact", generate("circle", 300, 1)); }

TEST(ExactSlow, SolvesAThousandCocircularPoints) {
  (void)solve_to_optimality("exact", generate("circle", 1000, 1));
  (void)solve_to_optimality("exact", generate("integer_circle", 1000, 1));
}

TEST(Exact, SolvesWheelsEvenAndOdd) {
  for (Index spokes = 13; spokes <= 30; ++spokes) {
    SCOPED_TRACE(spokes);
    const Solution exact_wheel = solve_to_optimality("exact", generate("wheel", spokes + 1, 1));
    EXPECT_GE(exact_wheel.counters.at("faces_with_holes"), 1);
    (void)solve_to_optimality("exact", generate("wheel", spokes + 1, spokes, {{"jitter", "0.001"}}));
  }
}

TEST(Exact, SolvesNearlyCollinearPoints) { (void)solve_to_optimality("exact", generate("near_collinear", 1000, 1)); }

TEST(ExactSlow, SolvesLargeWheels) {
  for (const Index n : {100, 101, 300}) (void)solve_to_optimality("exact", generate("wheel", n, 1));
}

TEST(Exact, SolvesSeveralJitteredWheelsInOneSet) {
  std::vector<Point> points;
  for (std::uint64_t i = 0; i < 9; ++i) {
    for (const Point& p : generate("wheel", static_cast<Index>(14 + i), i + 1, {{"jitter", "0.001"}})) {
      points.push_back({p.x + 3 * static_cast<double>(i % 3), p.y + 3 * static_cast<double>(i / 3)});
    }
  }
  (void)solve_to_optimality("exact", points);
}

TEST(Exact, SolvesFarFromTheOrigin) {
  for (const char* offset : {"1e6", "1e9"}) {
    (void)solve_to_optimality("exact", generate("far_from_origin", 1000, 1, {{"offset", offset}}));
  }
}

TEST(Exact, GivesTheSameTriangulationAtAllScales) {
  for (const char* family : {"uniform", "clustered", "wheel"}) {
    const std::vector<Point> points = generate(family, family == std::string("wheel") ? 15 : 500, 1);
    const Solution reference = solve_to_optimality("exact", points);
    for (const double scale : {0x1p-960, 0x1p-300, 0x1p300, 0x1p963}) {  // 1e-289 .. 8e289
      SCOPED_TRACE(testing::Message() << family << ' ' << scale);
      std::vector<Point> scaled = points;
      for (Point& p : scaled) p = {p.x * scale, p.y * scale};
      EXPECT_EQ(canonical(solve_to_optimality("exact", scaled)), canonical(reference));
    }
  }
}

TEST(Exact, SolvesTinyAndHugeInstances) {
  for (const double scale : {1e-300, 1e290}) {
    std::vector<Point> points = generate("uniform", 12, 3);
    for (Point& p : points) p = {p.x * scale, p.y * scale};
    expect_agreement({{std::to_string(scale), points}}, "subset_dp");
  }
}

std::vector<NamedInstance> middle_sized_instances() {
  std::vector<NamedInstance> instances;
  for (const char* family : {"uniform", "normal", "clustered", "lattice"}) {
    append(instances, family, 3000, 1);
  }
  append(instances, "near_collinear", 100, 1);
  append(instances, "near_collinear", 100, 1, {{"height", "3e-63"}});
  append(instances, "log_radial", 60, 1, {{"octaves", "300"}});
  append(instances, "wheel", 25, 1);
  return instances;
}

// It used to return greedy's triangulation there and to report a time limit that nobody had set.
TEST(Exact, ReturnsTheBestOfTheHeuristicsWhereMemoryStopsIt) {
  std::vector<Point> points;
  for (int i = 0; i <= 6000; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  const AlgorithmInfo& info = find_algorithm("exact");
  Context context;
  context.parameters = Parameters(info.name, info.parameters, {});
  context.memory_bytes = 1 << 20;
  const Solution solution = info.function(points, context);
  EXPECT_FALSE(find_violation(points, solution.triangulation));
  EXPECT_EQ(solution.stop_reason, StopReason::memory);
  ASSERT_TRUE(solution.optimum);
  EXPECT_GT(solution.optimum->lower, 0);
  EXPECT_LT(solution.optimum->lower, solution.optimum->upper);
  for (const char* heuristic : {"greedy", "patch", "flip"}) {
    EXPECT_LE(solution.optimum->upper, weight(points, solve_and_check(heuristic, points).triangulation).upper);
  }
}

TEST(Exact, DoesNotDependOnThreads) {
  for (const auto& [name, points] : middle_sized_instances()) {
    SCOPED_TRACE(name);
    const Solution one = solve_with_threads(points, 1);
    for (const int threads : {2, 3}) {
      const Solution other = solve_with_threads(points, threads);
      EXPECT_EQ(one.triangulation.triangles, other.triangulation.triangles);
      EXPECT_EQ(one.optimum, other.optimum);
    }
  }
}

TEST(Exact, DoesNotDependOnVectorInstructions) {
  for (const auto& [name, points] : middle_sized_instances()) {
    SCOPED_TRACE(name);
    const Solution best = solve_with_threads(points, 1);
    stage_testing::for_each_instruction_set([&] {
      const Solution other = solve_with_threads(points, 1);
      EXPECT_EQ(canonical(best), canonical(other));
      EXPECT_EQ(best.optimum, other.optimum);
    });
  }
}

TEST(Exact, SolvesSparseClusters) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    (void)solve_to_optimality("exact", generate("clustered", 2000, seed, {{"clusters", "50"}, {"sigma", "0.01"}}));
  }
}

TEST(Exact, ProvesAllFamiliesAtModerateSize) {
  for (const auto& [name, points] : instances_of_all_families({40, 300})) {
    const bool is_large_wheel = points.size() == 300 && name.starts_with("wheel");  // see ExactSlow
    if (is_large_wheel) continue;
    SCOPED_TRACE(name);
    (void)solve_to_optimality("exact", points);
  }
}

TEST(ExactSlow, ProvesAllFamiliesAtLargerSizes) {
  for (const char* family : {"uniform", "normal", "clustered", "lattice", "integer_uniform", "jittered_grid"}) {
    SCOPED_TRACE(family);
    (void)solve_to_optimality("exact", generate(family, 100'000, 1));
  }
}

TEST(Exact, ReturnsATriangulationAndBoundsAtTheDeadline) {
  for (const auto& [name, points] : middle_sized_instances()) {
    SCOPED_TRACE(name);
    const Solution proved = solve_to_optimality("exact", points);
    const Solution late = solve_and_check("exact", points, {}, Context::Clock::now() - std::chrono::seconds(1));
    EXPECT_EQ(late.stop_reason, StopReason::deadline);
    ASSERT_TRUE(late.optimum);
    EXPECT_GT(late.optimum->lower, 0);
    EXPECT_LE(late.optimum->lower, proved.optimum->lower);
    EXPECT_GE(late.optimum->upper, proved.optimum->upper);
  }
}

// Faces with true holes between curves, which were left open before they were cut open (holes/).
TEST(Exact, ProvesFacesWithHolesBetweenCurves) {
  for (const auto& points : {generate("annulus", 1500, 1), generate("contours", 1500, 1), generate("wheel", 400, 1),
                             generate("cad_plate", 500, 1, {{"holes", "5"}}), generate("roads", 1000, 1)})
    (void)solve_to_optimality("exact", points);
}

TEST(Exact, HandsFacingChainsToTwoChains) {
  const Solution solution = solve_to_optimality("exact", generate("greedy_corridor", 1200, 1));
  EXPECT_GT(solution.counters.at("first_chain"), 0);
}

// Every call of theirs may take 0.2 s past the deadline.
TEST(Exact, LooksForAHeuristicTriangulationOfStoppedChainsOnce) {
  const std::vector<Point> points = generate("greedy_corridor", 1200, 1);
  Context context;
  context.memory_bytes = 1000;  // less than the corridor needs
  const Solution solution = exact(points, context);
  EXPECT_EQ(solution.stop_reason, StopReason::memory);
  EXPECT_GT(solution.counters.at("first_chain"), 0);
  EXPECT_EQ(std::count_if(context.phases.begin(), context.phases.end(),
                          [](const auto& phase) { return phase.first == "heuristics"; }),
            1);
}

// Wherever the deadline stops it, the interval holds the optimum.
void interrupt_at_random_moments(int count) {
  std::mt19937_64 random(5);
  const std::vector<std::vector<Point>> instances = {
      generate("annulus", 700, 1),  generate("roads", 500, 1),         generate("wheel", 150, 1),
      generate("uniform", 2000, 1), generate("spiral", 500, 1),        generate("cad_plate", 300, 1, {{"holes", "4"}}),
      generate("contours", 800, 1), generate("insertion_trap", 120, 1)};
  for (const std::vector<Point>& points : instances) {
    const auto start = Context::Clock::now();
    const Solution proved = solve_to_optimality("exact", points);
    const auto whole = Context::Clock::now() - start;
    for (int i = 0; i < count; ++i) {
      const auto share =
          std::chrono::duration_cast<Context::Clock::duration>(whole * (static_cast<double>(random() % 1000) / 800));
      const Solution stopped = solve_and_check("exact", points, {}, Context::Clock::now() + share);
      ASSERT_TRUE(stopped.optimum);
      EXPECT_LE(stopped.optimum->lower, proved.optimum->upper);
      EXPECT_GE(stopped.optimum->upper, proved.optimum->lower);
    }
  }
}

TEST(Exact, HoldsTheOptimumWhereverItIsStopped) { interrupt_at_random_moments(8); }

TEST(ExactSlow, HoldsTheOptimumWhereverItIsStopped) { interrupt_at_random_moments(130); }

Solution solve_within(Points points, std::int64_t readings) {
  const test::CountedTime time;
  Context context;
  context.deadline = test::CountedTime::after(readings);
  return exact(points, context);
}

std::int64_t readings_of_whole(Points points) {
  const test::CountedTime time;
  Context context;
  context.deadline = test::CountedTime::after(std::int64_t{1} << 40);
  EXPECT_FALSE(exact(points, context).stop_reason);
  return test::CountedTime::readings();
}

// Each limit is a number of times that the solver looks at the clock, so that it stops at the same places every time.
void give_more_and_more_time(int steps) {
  const std::vector<NamedInstance> instances = {
      {"annulus", generate("annulus", 700, 1)},   {"roads", generate("roads", 500, 1)},
      {"wheel", generate("wheel", 150, 1)},       {"uniform", generate("uniform", 2000, 1)},
      {"spiral", generate("spiral", 500, 1)},     {"cad_plate", generate("cad_plate", 300, 1, {{"holes", "4"}})},
      {"contours", generate("contours", 800, 1)}, {"insertion_trap", generate("insertion_trap", 120, 1)},
      {"circle", generate("circle", 400, 1)}};
  for (const auto& [name, points] : instances) {
    const std::int64_t whole = readings_of_whole(points);
    Interval last{0, std::numeric_limits<double>::infinity()};
    for (int step = 0; step <= 2 * steps; ++step) {
      SCOPED_TRACE(testing::Message() << name << ", step " << step);
      const Solution stopped = solve_within(points, whole * step / steps);
      ASSERT_TRUE(stopped.optimum);
      EXPECT_GE(stopped.optimum->lower, last.lower);
      EXPECT_LE(stopped.optimum->upper, last.upper);
      last = *stopped.optimum;
    }
  }
}

// Whichever of its readings of the clock comes too late.
void stop_at_every_reading(const std::vector<NamedInstance>& instances, const std::string& reference) {
  for (const auto& [name, points] : instances) {
    const Interval optimum = *solve_to_optimality(reference, points).optimum;
    const std::int64_t whole = readings_of_whole(points);
    for (std::int64_t readings = 0; readings <= whole; readings += 1 + readings / 16) {
      SCOPED_TRACE(testing::Message() << name << ", after " << readings << " of " << whole << " readings");
      const Solution stopped = solve_within(points, readings);
      ASSERT_FALSE(find_violation(points, stopped.triangulation));
      ASSERT_LE(stopped.optimum->lower, optimum.upper);
      ASSERT_GE(stopped.optimum->upper, optimum.lower);
    }
  }
}

TEST(Exact, HoldsTheOptimumWhicheverReadingOfTheClockStopsIt) {
  stop_at_every_reading(instances_of_all_families({9, 13}, 2), "subset_dp");
}

TEST(ExactSlow, HoldsTheOptimumWhicheverReadingOfTheClockStopsIt) {
  stop_at_every_reading(instances_of_all_families({7, 8, 10, 11, 12, 13}, 10), "subset_dp");
  stop_at_every_reading(instances_of_all_families({40}, 1), "triangle_lp");
}

TEST(Exact, AnswersNoWorseGivenMoreTime) { give_more_and_more_time(6); }

TEST(ExactSlow, AnswersNoWorseGivenMoreTime) { give_more_and_more_time(24); }

TEST(Exact, ReportsStagesAndCounters) {
  const std::vector<Point> points = generate("uniform", 2000, 1);
  Context context;
  std::vector<std::string> stages;
  double done = 0;
  context.progress = [&](const std::string& stage, double share) {
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
    done = share;
  };
  const Solution solution = exact(points, context);
  EXPECT_EQ(stages, (std::vector<std::string>{"k-d order", "diamond test", "diamond test and LMT-skeleton",
                                              "certain edges", "faces"}));
  EXPECT_EQ(done, 1);
  std::vector<std::string> phases;
  for (const auto& [name, seconds] : context.phases) {
    phases.push_back(name);
    EXPECT_GE(seconds, 0) << name;
  }
  EXPECT_EQ(phases, (std::vector<std::string>{"kd_order", "diamond_distances", "diamond_test_and_lmt", "certain_edges",
                                              "faces"}));
  const auto& counters = solution.counters;
  EXPECT_GT(counters.at("edges_after_diamond_test"), counters.at("edges_after_lmt"));
  EXPECT_GT(counters.at("edges_after_lmt"), counters.at("certain_edges"));
  EXPECT_GT(counters.at("faces"), 0);
  EXPECT_GT(counters.at("dp_cells"), 0);
  EXPECT_EQ(counters.at("unsolved_faces"), 0);
}

}  // namespace
}  // namespace mwt
