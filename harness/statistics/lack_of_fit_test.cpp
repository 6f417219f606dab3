#include "harness/statistics/lack_of_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "generators/random.h"

namespace mwt {
namespace {

using Curve = std::function<double(double n)>;

LackOfFit lack_of_fit(const std::vector<Measurement>& measurements) {
  return test_lack_of_fit(measurements, fit_power_law(measurements).value());
}

/// `copies` measurements at each size, with this relative noise.
std::vector<Measurement> measured(const Curve& curve, int copies, double noise, std::uint64_t seed = 1) {
  RandomEngine engine = make_engine("lack_of_fit_test", seed);
  std::vector<Measurement> measurements;
  for (const double n : {10, 20, 50, 100, 200, 500}) {
    for (int copy = 0; copy < copies; ++copy)
      measurements.push_back({n, curve(n) * std::exp(noise * standard_normal(engine))});
  }
  return measurements;
}

double power(double n) { return 3 * std::pow(n, 1.5); }
double bent(double n) { return std::pow(n, 1.5) * std::exp(n / 100); }

/// How often of a hundred the test rejects at 5%.
int rejections(const Curve& curve, int copies, double noise) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed)
    count += lack_of_fit(measured(curve, copies, noise, seed)).p_value.value() < 0.05;
  return count;
}

TEST(LackOfFit, APowerLawIsRejectedAsOftenAsItMayBe) {
  EXPECT_LE(rejections(power, 5, 0.2), 10);
  EXPECT_LE(rejections(power, 2, 0.2), 10);
  EXPECT_LE(rejections(power, 1, 0.2), 10) << "by curvature";
}

TEST(LackOfFit, AnExponentialIsRejected) {
  EXPECT_GE(rejections(bent, 5, 0.2), 99);
  EXPECT_GE(rejections(bent, 2, 0.2), 99);
  EXPECT_GE(rejections(bent, 1, 0.02), 95) << "by curvature";
}

TEST(LackOfFit, TheLargestMisfitIsThatOfAMedian) {
  std::vector<Measurement> measurements = measured(power, 3, 0);
  EXPECT_NEAR(lack_of_fit(measurements).max_misfit, 1, 1e-9);
  for (Measurement& measurement : measurements) {
    if (measurement.n == 500) measurement.y *= 4;
  }
  const LackOfFit off = lack_of_fit(measurements);
  EXPECT_GT(off.max_misfit, 1.3);
  EXPECT_LT(off.max_misfit, 4);
  EXPECT_LT(off.p_value.value(), 1e-6) << "without noise any misfit is one too many";
}

TEST(LackOfFit, AWildValueIsNoLackOfFit) {
  std::vector<Measurement> measurements = measured(power, 7, 0.05);
  measurements[9].y *= 20;
  EXPECT_GT(lack_of_fit(measurements).p_value.value(), 0.05);
  EXPECT_LT(lack_of_fit(measurements).max_misfit, 2);
}

TEST(LackOfFit, WhatCannotBeTestedHasNoPValue) {
  const std::vector<Measurement> measurements = {{10, 1}, {20, 2}, {40, 5}};
  EXPECT_FALSE(lack_of_fit(measurements).p_value);
  EXPECT_GT(lack_of_fit(measurements).max_misfit, 1);
}

TEST(LackOfFit, AConstantFits) {
  EXPECT_EQ(lack_of_fit(measured([](double) { return 1.0; }, 3, 0)).p_value, 1);
  EXPECT_EQ(lack_of_fit(measured([](double) { return 1.0; }, 1, 0)).p_value, 1);
}

}  // namespace
}  // namespace mwt
