#include "harness/rating/rated_run.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "harness/rating/quality.h"
#include "harness/run/testing/algorithms_testing.h"

namespace mwt {
namespace {

// A triangle with sides 3, 4 and 5.
const std::vector<Point> kTriangle = {{0, 0}, {4, 0}, {0, 3}};

Execution execution_of(std::vector<Triangle> triangles, std::optional<Interval> optimum = {}) {
  Execution execution;
  execution.solution.triangulation = {3, std::move(triangles)};
  execution.solution.optimum = optimum;
  execution.solution.counters = {{"flips", 2}, {"share", 0.1}};
  return execution;
}

RatedRun judged_run(const Execution& execution) {
  return judged(testing::entry("exact", testing::solve_well), kTriangle, execution);
}

TEST(RatedRun, IsJudgedByCheckerAndCertifiedSums) {
  const RatedRun run = judged_run(execution_of({{0, 1, 2}}));
  EXPECT_EQ(run.status, RunStatus::ok);
  EXPECT_EQ(run.checker, "ok");
  EXPECT_LE(*run.weight_lower, 12);
  EXPECT_GE(*run.weight_upper, 12);
  EXPECT_EQ(run.perimeter_sum, 12);
  EXPECT_EQ(run.triangles, 1u);
  EXPECT_EQ(run.edges, 3u);
  EXPECT_FALSE(run.certified_lower);
  EXPECT_FALSE(run.alpha_upper);
}

TEST(RatedRun, WhatIsNoTriangulationHasCostsButNoWeight) {
  const RatedRun run = judged_run(execution_of({{0, 2, 1}}));
  EXPECT_EQ(run.status, RunStatus::invalid_output);
  EXPECT_EQ(run.message, run.checker);
  EXPECT_FALSE(run.weight_upper);
  EXPECT_FALSE(run.edges);
  EXPECT_EQ(run.triangles, 1u);
  EXPECT_TRUE(run.wall_time_s);
}

TEST(RatedRun, ABoundAboveTheOwnTriangulationIsAnError) {
  const RatedRun run = judged_run(execution_of({{0, 1, 2}}, Interval{13, 13}));
  EXPECT_EQ(run.status, RunStatus::error);
  EXPECT_TRUE(is_disproved(run));
  EXPECT_FALSE(run.certified_lower);
}

TEST(RatedRun, IsRatedByTheOptimum) {
  RatedRun run = judged_run(execution_of({{0, 1, 2}}, Interval{11, 12}));
  EXPECT_EQ(run.certified_lower, 11);
  rate(run, Interval{6, 8});
  EXPECT_EQ(run.alpha_lower, divide_down(*run.weight_lower, 8));
  EXPECT_EQ(run.alpha_upper, divide_up(*run.weight_upper, 6));
  EXPECT_EQ(run.optimality, "bounded");
  EXPECT_EQ(run.optimal, "no");
  rate(run, std::nullopt);
  EXPECT_FALSE(run.alpha_upper) << "no bound, no alpha";
  EXPECT_EQ(run.optimality, "none");
}

TEST(RatedRun, OnlyRunsThatAreOkAreRated) {
  RatedRun run;
  fail(run, RunStatus::timeout, "too long");
  rate(run, Interval{6, 8});
  EXPECT_FALSE(run.alpha_upper);
  EXPECT_EQ(run.optimality, "");
}

TEST(RatedRun, GoesThroughItsColumnsUnchanged) {
  RatedRun run = judged_run(execution_of({{0, 1, 2}}, Interval{11, 12}));
  run.phases = {{"first phase", 0.25}, {"second", 0.5}};
  const auto columns = rated_run_columns<RatedRun>();
  const RatedRun back = read_row(columns, to_row(columns, run));
  EXPECT_EQ(to_row(columns, back), to_row(columns, run));
  EXPECT_EQ(named_number(back.phases, "first_phase"), 0.25);
  EXPECT_EQ(named_number(back.counters, "share"), 0.1);
  EXPECT_EQ(back.weight_upper, run.weight_upper);
}

TEST(NamedNumbers, AreTextAndBack) {
  EXPECT_EQ(to_text(NamedNumbers{{"flips", 2}, {"share", 0.1}}), "flips=2 share=0.1");
  NamedNumbers numbers;
  for (const char* text : {"flips", "flips=", "flips=x", "a=1  b=2"}) {
    EXPECT_THROW(read_text(text, numbers), std::invalid_argument) << text;
  }
  read_text("", numbers);
  EXPECT_TRUE(numbers.empty());
}

}  // namespace
}  // namespace mwt
