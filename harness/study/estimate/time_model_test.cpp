#include "harness/study/estimate/time_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace mwt {
namespace {

constexpr double kLimit = 60;

TimeModel quadratic_model() {
  TimeModel model;
  for (const Index n : {10U, 100U, 1000U}) model.add({"flip", "uniform", n}, {1e-6 * n * n, false, true});
  return model;
}

TEST(TimeModel, ABusyMachineDoesNotCount) {
  RatedRun run;
  EXPECT_FALSE(undisturbed_time_s(run, 1));
  run.wall_time_s = 8;
  run.cpu_time_s = 2;
  EXPECT_EQ(undisturbed_time_s(run, 1), 2);
  EXPECT_EQ(undisturbed_time_s(run, 4), 8) << "the CPU time of several threads";
  run.wall_time_s = 0.001;
  run.cpu_time_s = 0;
  EXPECT_EQ(undisturbed_time_s(run, 1), 0.001) << "CPU clocks may tick too slowly";
  run.wall_time_s = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(undisturbed_time_s(run, 1));
}

TEST(TimeModel, NothingKnownMeansTheLimit) {
  const TimePrediction prediction = TimeModel().predict({"flip", "uniform", 10}, kLimit);
  EXPECT_EQ(prediction.basis, TimeBasis::nothing);
  EXPECT_EQ(prediction.seconds, kLimit);
  EXPECT_EQ(prediction.low, 0);
}

TEST(TimeModel, ACellIsPredictedByItsMedian) {
  TimeModel model;
  for (const double seconds : {1.0, 2.0, 30.0}) model.add({"flip", "uniform", 10}, {seconds, false, true});
  const TimePrediction prediction = model.predict({"flip", "uniform", 10}, kLimit);
  EXPECT_EQ(prediction.basis, TimeBasis::recorded);
  EXPECT_EQ(prediction.seconds, 2);
  EXPECT_LT(prediction.low, 2);
  EXPECT_GT(prediction.high, 2);
}

TEST(TimeModel, TimesGrowLikeAPowerOfN) {
  const TimeModel model = quadratic_model();
  const TimePrediction between = model.predict({"flip", "uniform", 300}, kLimit);
  EXPECT_EQ(between.basis, TimeBasis::other_sizes);
  EXPECT_NEAR(between.seconds, 0.09, 1e-9);
  const TimePrediction beyond = model.predict({"flip", "uniform", 4000}, kLimit);
  EXPECT_NEAR(beyond.seconds, 16, 1e-9);
  EXPECT_LT(between.high / between.low, beyond.high / beyond.low) << "further away is less sure";
  EXPECT_EQ(model.predict({"flip", "uniform", 1000000}, kLimit).seconds, kLimit);
}

TEST(TimeModel, AnotherFamilyIsLikeTheMedianOfThoseThatAreKnown) {
  TimeModel model = quadratic_model();
  model.add({"flip", "grid", 100}, {0.02, false, true});
  model.add({"flip", "circle", 100}, {3, false, true});
  const TimePrediction prediction = model.predict({"flip", "spiral", 100}, kLimit);
  EXPECT_EQ(prediction.basis, TimeBasis::other_families);
  EXPECT_NEAR(prediction.seconds, 0.02, 1e-9);
  EXPECT_GT(prediction.high, 1) << "the families differ";
}

TEST(TimeModel, AnotherVariantIsBetterThanNothing) {
  const TimeModel model = quadratic_model();
  const TimePrediction prediction = model.predict({"flip order=best", "uniform", 1000}, kLimit);
  EXPECT_EQ(prediction.basis, TimeBasis::other_variants);
  EXPECT_NEAR(prediction.seconds, 1, 1e-9);
  EXPECT_EQ(model.predict({"flip_naive", "uniform", 1000}, kLimit).basis, TimeBasis::nothing);
}

TEST(TimeModel, WhatMetItsLimitMayTakeLonger) {
  TimeModel model;
  model.add({"exact", "wheel", 100}, {5, true, true});
  for (const Index n : {100U, 1000U}) {
    const TimePrediction prediction = model.predict({"exact", "wheel", n}, kLimit);
    EXPECT_EQ(prediction.low, 5);
    EXPECT_EQ(prediction.high, kLimit);
  }
  EXPECT_LT(model.predict({"exact", "wheel", 10}, kLimit).seconds, 5);
  EXPECT_EQ(model.predict({"exact", "wheel", 100}, 2).seconds, 2);
}

}  // namespace
}  // namespace mwt
