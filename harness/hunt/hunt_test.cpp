#include "harness/hunt/hunt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/sweep/sweep.h"
#include "base/error.h"
#include "geometry/delaunay.h"
#include "geometry/weight.h"
#include "harness/hunt/moves.h"
#include "harness/hunt/state_file.h"
#include "harness/io/testing/folder_testing.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

HuntPlan plan_for(const std::string& algorithm, Index n, int climbers = 1) {
  const Catalogue catalogue = Catalogue::built_in();
  HuntPlan plan;
  plan.request.algorithm = &catalogue.algorithm(algorithm);
  plan.request.parameters = Parameters(algorithm, plan.request.algorithm->parameters, {});
  plan.solver = &solver_for_hunt(catalogue, n);
  plan.n = n;
  plan.climbers = climbers;
  return plan;
}

HuntResult run(const HuntPlan& plan, std::uint64_t evaluations, const std::string& state_file) {
  return hunt(plan, {.budget_s = 600, .evaluations = evaluations}, state_file, [](const HuntResult&) {});
}

TEST(AlphaOracle, rates_what_it_can_and_nothing_else) {
  const HuntPlan plan = plan_for("delaunay", 5);
  const AlphaOracle oracle(plan.request, *plan.solver);
  // A flat quadrilateral: Delaunay takes the long diagonal when the short one is the other.
  const std::optional<Interval> alpha = oracle.alpha({{0, 0}, {10, 1}, {20, 0}, {10, -5}, {10, 12}});
  ASSERT_TRUE(alpha);
  EXPECT_GE(alpha->lower, 1);
  EXPECT_LT(alpha->relative_width(), 1e-12);
  EXPECT_FALSE(oracle.alpha({{0, 0}, {1, 0}, {2, 0}})) << "collinear";
  EXPECT_FALSE(oracle.alpha({{0, 0}, {1, 0}, {0, 0}, {0, 1}})) << "duplicates";
  const HuntPlan convex = plan_for("polygon_dp", 5);
  EXPECT_FALSE(AlphaOracle(convex.request, *convex.solver).alpha({{0, 0}, {4, 0}, {0, 4}, {1, 1}})) << "not applicable";
}

TEST(AlphaOracle, an_invalid_triangulation_is_no_find_but_a_failure) {
  AlgorithmInfo broken;
  broken.name = "broken";
  broken.function = [](Points points, Context&) {
    Solution solution;
    solution.triangulation = delaunay_triangulation(points);
    solution.triangulation.triangles.pop_back();
    return solution;
  };
  HuntPlan plan = plan_for("delaunay", 5);
  plan.request.algorithm = &broken;
  EXPECT_THROW((void)AlphaOracle(plan.request, *plan.solver).alpha({{0, 0}, {4, 0}, {0, 4}, {1, 1}}), std::logic_error);
  TestFolder folder;
  EXPECT_THROW((void)run(plan, 100, folder.path("state")), std::logic_error);
}

// The algorithm was blamed for being lighter than the optimum.
TEST(AlphaOracle, a_lighter_triangulation_disproves_the_solver) {
  AlgorithmInfo wrong;
  wrong.name = "wrong";
  wrong.function = [](Points points, Context&) {
    Solution solution;
    solution.triangulation = sweep_triangulation(points);
    solution.optimum = weight(points, solution.triangulation);
    return solution;
  };
  const HuntPlan plan = plan_for("delaunay", 5);
  const std::vector<Point> points = {{0, 0}, {10, 1}, {20, 0}, {10, -5}, {10, 12}, {3, 4}, {15, 3}};
  try {
    static_cast<void>(AlphaOracle(plan.request, wrong).alpha(points));
    ADD_FAILURE();
  } catch (const DisprovedOptimum& failure) {
    EXPECT_TRUE(std::string(failure.what()).starts_with("CONTRADICTION: wrong certified that no triangulation weighs"));
    EXPECT_NE(std::string(failure.what()).find("but a checked one of delaunay weighs"), std::string::npos);
    EXPECT_EQ(failure.points(), points);
  }
}

TEST(AlphaOracle, a_solver_that_its_own_triangulation_disproves_is_a_failure) {
  AlgorithmInfo wrong;
  wrong.name = "wrong";
  wrong.function = [](Points points, Context&) {
    Solution solution;
    solution.triangulation = sweep_triangulation(points);
    solution.optimum = Interval{1e9, 1e9};
    return solution;
  };
  const HuntPlan plan = plan_for("delaunay", 5);
  EXPECT_THROW((void)AlphaOracle(plan.request, wrong).alpha({{0, 0}, {4, 0}, {0, 4}, {1, 1}}), DisprovedOptimum);
}

TEST(Hunt, moves_change_points_and_keep_their_number) {
  RandomEngine engine = make_engine("test", 1);
  const std::vector<Point> start = random_start(10, engine);
  int unchanged = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::vector<Point> points = mutated(start, engine);
    EXPECT_EQ(points.size(), start.size());
    unchanged += points == start;
  }
  EXPECT_LT(unchanged, 20);
}

TEST(Hunt, moves_do_not_let_coordinates_drift) {
  RandomEngine engine = make_engine("test", 2);
  std::vector<Point> points = random_start(6, engine);
  for (int i = 0; i < 10'000; ++i) points = mutated(points, engine);
  for (const Point& p : points) EXPECT_LT(std::abs(p.x - points[0].x) + std::abs(p.y - points[0].y), 8);
}

TEST(Hunt, finds_bad_inputs_and_repeats_itself) {
  TestFolder folder;
  const HuntResult result = run(plan_for("greedy", 8), 2000, folder.path("a"));
  EXPECT_GT(result.worst.alpha, 1.05);
  EXPECT_EQ(result.evaluations, 2000U);
  EXPECT_EQ(result.worst.points.size(), 8U);
  const HuntResult again = run(plan_for("greedy", 8), 2000, folder.path("b"));
  EXPECT_EQ(again.worst.points, result.worst.points);
  HuntPlan other = plan_for("greedy", 8);
  other.seed = 2;
  EXPECT_NE(run(other, 2000, folder.path("c")).worst.points, result.worst.points);
}

TEST(Hunt, resumed_it_ends_where_it_would_have_ended) {
  TestFolder folder;
  const HuntPlan plan = plan_for("flip", 7, 2);
  (void)run(plan, 300, folder.path("parts"));
  const HuntResult resumed = run(plan, 700, folder.path("parts"));
  const HuntResult whole = run(plan, 700, folder.path("whole"));
  EXPECT_EQ(resumed.evaluations, 1400U);
  EXPECT_EQ(resumed.worst.points, whole.worst.points);
  EXPECT_EQ(read_text(folder.path("parts")), read_text(folder.path("whole")));
}

TEST(Hunt, states_of_other_hunts_and_damaged_ones_are_refused) {
  TestFolder folder;
  const std::string path = folder.path("state");
  (void)run(plan_for("greedy", 6), 20, path);
  EXPECT_THROW((void)run(plan_for("greedy", 7), 20, path), InputError);
  EXPECT_THROW((void)run(plan_for("flip", 6), 20, path), InputError);
  EXPECT_THROW((void)run(plan_for("greedy", 6, 2), 20, path), InputError);
  const std::string text = read_text(path);
  write_text(path, text.substr(0, text.size() / 2));
  EXPECT_THROW((void)run(plan_for("greedy", 6), 20, path), InputError);
  write_text(path, "");
  EXPECT_THROW((void)run(plan_for("greedy", 6), 20, path), InputError);
  for (const char* count : {"nan", "inf", "-1", "1e300", "0.5", "9007199254740992"}) {
    write_text(path, plan_for("greedy", 6).identity() + "\nclimbers " + count + "\n");
    EXPECT_THROW((void)run(plan_for("greedy", 6), 20, path), InputError) << count;
  }
  const std::string two_points = "climber 1 1\ncurrent 1 2\n0 0\n1 1\nbest 1 2\n0 0\n1 1\nend\n";
  write_text(path, plan_for("greedy", 6).identity() + "\nclimbers 1\n" + two_points);
  EXPECT_THROW((void)run(plan_for("greedy", 6), 20, path), InputError);
}

TEST(Hunt, states_survive_the_file_exactly) {
  TestFolder folder;
  ClimberState state;
  state.evaluations = 12345;
  state.last_progress = 12000;
  state.current = {{{.1, 1e-300}, {-1e300, 1. / 3}, {0, 5}}, 1.1};
  state.best = {{{.7, .2}}, 1.0 / 3};
  write_hunt_state(folder.path("state"), "# who", {state, ClimberState{}});
  const std::vector<ClimberState> read = read_hunt_state(folder.path("state"), "# who");
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].evaluations, state.evaluations);
  EXPECT_EQ(read[0].last_progress, state.last_progress);
  EXPECT_EQ(read[0].current.points, state.current.points);
  EXPECT_EQ(read[0].best.points, state.best.points);
  EXPECT_EQ(read[0].best.alpha, state.best.alpha);
  EXPECT_TRUE(read[1].current.points.empty());
}

// What a hunt is for.
TEST(HuntSlow, beats_the_worst_of_10000_random_instances) {
  const HuntPlan plan = plan_for("greedy", 10);
  const AlphaOracle oracle(plan.request, *plan.solver);
  RandomEngine engine = make_engine("test", 1);
  double worst = 1;
  for (int i = 0; i < 10'000; ++i) {
    const std::optional<Interval> alpha = oracle.alpha(random_start(10, engine));
    if (alpha) worst = std::max(worst, alpha->upper);
  }
  TestFolder folder;
  const HuntResult result = run(plan, 10'000, folder.path("state"));
  RecordProperty("worst_of_random", std::to_string(worst));
  RecordProperty("hunted", std::to_string(result.worst.alpha));
  EXPECT_GT(result.worst.alpha, worst);
  EXPECT_GT(worst, 1);
}

}  // namespace
}  // namespace mwt
