#include "harness/study/known_optima.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

RunRecord run_of_weight(double lower, double upper) {
  RunRecord record;
  record.instance_id = "instance";
  record.status = RunStatus::ok;
  record.weight_lower = lower;
  record.weight_upper = upper;
  return record;
}

TEST(KnownOptima, WithoutABoundThereIsNoAlpha) {
  KnownOptima known;
  RunRecord record = run_of_weight(10, 10);
  EXPECT_TRUE(known.rate(record));
  EXPECT_FALSE(record.alpha_upper);
  EXPECT_FALSE(record.optimum_lower);
  EXPECT_EQ(record.optimality, "none");
  EXPECT_EQ(record.optimal, "undecided");
}

TEST(KnownOptima, RatesAgainstWhatIsKnown) {
  KnownOptima known;
  EXPECT_TRUE(known.add("instance", {8, 8}));
  RunRecord record = run_of_weight(10, 10);
  EXPECT_TRUE(known.rate(record));
  EXPECT_EQ(record.alpha_lower, 1.25);
  EXPECT_EQ(record.alpha_upper, 1.25);
  EXPECT_EQ(record.optimality, "proved");
  EXPECT_EQ(record.optimal, "no");
}

TEST(KnownOptima, ALighterTriangulationImprovesAnUpperBound) {
  KnownOptima known;
  EXPECT_TRUE(known.add("instance", {5, 12}));
  RunRecord record = run_of_weight(10, 10);
  EXPECT_TRUE(known.rate(record));
  EXPECT_EQ(record.optimum_upper, 10);
  EXPECT_EQ(known.of("instance")->upper, 10);
  RunRecord heavier = run_of_weight(11, 11);
  EXPECT_TRUE(known.rate(heavier));
  EXPECT_EQ(heavier.optimum_upper, 10);
}

TEST(KnownOptima, WhatARunCertifiesServesLaterRuns) {
  KnownOptima known;
  RunRecord exact = run_of_weight(10, 10);
  exact.optimum_lower = 10;
  exact.optimum_upper = 10;
  EXPECT_TRUE(known.rate(exact));
  EXPECT_EQ(exact.optimal, "yes");
  RunRecord record = run_of_weight(20, 20);
  EXPECT_TRUE(known.rate(record));
  EXPECT_EQ(record.alpha_upper, 2);
}

TEST(KnownOptima, ATriangulationLighterThanTheOptimumIsAContradiction) {
  KnownOptima known;
  EXPECT_TRUE(known.add("instance", {10, 10}));
  RunRecord record = run_of_weight(9, 9);
  EXPECT_FALSE(known.rate(record));
  EXPECT_EQ(record.status, RunStatus::error);
  EXPECT_TRUE(record.message.starts_with("CONTRADICTION"));
  EXPECT_FALSE(record.alpha_upper);
  EXPECT_EQ(*known.of("instance"), (Interval{10, 10}));
}

TEST(KnownOptima, TwoOptimaThatExcludeEachOtherAreAContradiction) {
  KnownOptima known;
  EXPECT_TRUE(known.add("instance", {10, 10}));
  RunRecord record = run_of_weight(11, 11);
  record.optimum_lower = 11;
  record.optimum_upper = 11;
  EXPECT_FALSE(known.rate(record));
  EXPECT_EQ(record.status, RunStatus::error);
  EXPECT_FALSE(known.add("instance", {11, 12}));
}

TEST(KnownOptima, FailedRunsStayAsTheyAre) {
  KnownOptima known;
  EXPECT_TRUE(known.add("instance", {10, 10}));
  RunRecord record;
  record.instance_id = "instance";
  record.status = RunStatus::timeout;
  EXPECT_TRUE(known.rate(record));
  EXPECT_EQ(record.optimality, "");
  EXPECT_FALSE(record.optimum_lower);
}

}  // namespace
}  // namespace mwt
