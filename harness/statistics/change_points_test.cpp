#include "harness/statistics/change_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <vector>

#include "generators/random.h"

namespace mwt {
namespace {

constexpr std::size_t kNightlyRuns = 60;

using Noise = std::function<double(RandomEngine&)>;

double student(RandomEngine& engine, int degrees) {
  double squares = 0;
  for (int i = 0; i < degrees; ++i) squares += std::pow(standard_normal(engine), 2);
  return standard_normal(engine) / std::sqrt(squares / degrees);
}

double exponential(RandomEngine& engine) { return -std::log1p(-uniform_unit(engine)); }

std::vector<double> noise_series(RandomEngine& engine, std::size_t nightly_runs, const Noise& noise) {
  std::vector<double> series(nightly_runs);
  for (double& value : series) value = noise(engine);
  return series;
}

// Normal with variance 1 and this correlation between neighbours.
std::vector<double> remembering_series(RandomEngine& engine, std::size_t nightly_runs, double correlation) {
  std::vector<double> series = noise_series(engine, nightly_runs, standard_normal);
  const double fresh = std::sqrt(1 - correlation * correlation);
  for (std::size_t i = 1; i < nightly_runs; ++i) series[i] = correlation * series[i - 1] + fresh * series[i];
  return series;
}

int alarms(int series_count, const std::function<std::vector<double>(RandomEngine&)>& make) {
  RandomEngine engine = make_engine("change_points_test", 1);
  int count = 0;
  for (int i = 0; i < series_count; ++i) count += !find_steps(make(engine)).empty();
  return count;
}

int alarms_of_noise(int series_count, const Noise& noise) {
  return alarms(series_count, [&](RandomEngine& engine) { return noise_series(engine, kNightlyRuns, noise); });
}

struct Detections {
  int found = 0;  ///< exactly one step, within two nightly runs of the true one
  int exact = 0;  ///< on the very nightly run
};

// Of so many series with a step of this height at `first`.
Detections detections(double height, std::size_t nightly_runs, std::size_t first, int series_count = 200,
                      double correlation = 0) {
  RandomEngine engine = make_engine("change_points_test", 2);
  Detections result;
  for (int i = 0; i < series_count; ++i) {
    std::vector<double> series = remembering_series(engine, nightly_runs, correlation);
    for (std::size_t nightly_run = first; nightly_run < nightly_runs; ++nightly_run) series[nightly_run] += height;
    const std::vector<Step> steps = find_steps(series);
    if (steps.size() != 1) continue;
    result.found += steps[0].first + 2 >= first && steps[0].first <= first + 2;
    result.exact += steps[0].first == first;
  }
  return result;
}

TEST(ChangePoints, FindsAStepAndItsLevels) {
  std::vector<double> series;
  for (int i = 0; i < 40; ++i) series.push_back((i < 24 ? 10.0 : 11.0) + 0.02 * ((i * 7) % 5 - 2));
  const std::vector<Step> steps = find_steps(series);
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].first, 24u);
  EXPECT_NEAR(steps[0].before, 10, 0.021);
  EXPECT_NEAR(steps[0].after, 11, 0.021);
}

TEST(ChangePoints, FindsSeveralSteps) {
  std::vector<double> series;
  for (int i = 0; i < 60; ++i) {
    const double level = i < 15 ? 5 : i < 30 ? 6 : i < 45 ? 4 : 7;
    series.push_back(level + 0.05 * ((i * 7) % 5 - 2));
  }
  const std::vector<Step> steps = find_steps(series);
  ASSERT_EQ(steps.size(), 3u);
  EXPECT_EQ(steps[0].first, 15u);
  EXPECT_EQ(steps[1].first, 30u);
  EXPECT_EQ(steps[2].first, 45u);
  EXPECT_GT(steps[2].after, steps[2].before);
}

TEST(ChangePoints, SpikesAreNoSteps) {
  RandomEngine engine = make_engine("change_points_test", 3);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> series = noise_series(engine, kNightlyRuns, standard_normal);
    const std::size_t place = uniform_below(engine, kNightlyRuns - 1);
    series[place] += 1000;
    series[place + 1] += i % 2 == 0 ? 0 : 1000;  // two in a row, the last nightly run included
    EXPECT_TRUE(find_steps(series).empty()) << i;
  }
}

TEST(ChangePoints, ADriftBecomesAStaircaseInItsDirection) {
  RandomEngine engine = make_engine("change_points_test", 4);
  int with_steps = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<double> series = noise_series(engine, kNightlyRuns, standard_normal);
    for (std::size_t nightly_run = 0; nightly_run < kNightlyRuns; ++nightly_run)
      series[nightly_run] += 0.15 * static_cast<double>(nightly_run);
    const std::vector<Step> steps = find_steps(series);
    with_steps += !steps.empty();
    for (const Step& step : steps) EXPECT_GT(step.after, step.before);
  }
  EXPECT_GE(with_steps, 35) << "a drift is autocorrelated noise, too";
}

TEST(ChangePoints, EqualAndShortSeriesHaveNone) {
  EXPECT_TRUE(find_steps({}).empty());
  EXPECT_TRUE(find_steps(std::vector<double>{1, 9, 1, 9, 9}).empty());
  EXPECT_TRUE(find_steps(std::vector<double>(30, 3.5)).empty());
}

TEST(ChangePoints, SeriesThatAreMostlyEqual) {
  std::vector<double> series(20, 5.0);
  std::fill(series.begin() + 12, series.end(), 6.0);
  const std::vector<Step> steps = find_steps(series, {24, 3, 0.01});
  ASSERT_EQ(steps.size(), 1u);
  EXPECT_EQ(steps[0].first, 12u);
  EXPECT_TRUE(find_steps(series, {24, 3, 5.0}).empty()) << "less than the noise allowed for";
}

TEST(ChangePoints, ExactSeriesStepAtEveryChangeThatStays) {
  EXPECT_TRUE(find_exact_steps(std::vector<double>{2, 2, 2}).empty());
  EXPECT_TRUE(find_exact_steps(std::vector<double>{2, 2, 3, 2, 2}).empty());
  const std::vector<Step> steps = find_exact_steps(std::vector<double>{2, 2, 3, 3, 3, 2.5});
  ASSERT_EQ(steps.size(), 2u);
  EXPECT_EQ(steps[0].first, 2u);
  EXPECT_EQ(steps[1].first, 5u);
  EXPECT_EQ(steps[1].before, 3);
  EXPECT_EQ(steps[1].after, 2.5);
}

TEST(ChangePoints, SeriesWithHardlyAnyNoiseStepBeyondTheTolerance) {
  EXPECT_TRUE(find_steps_beyond({}, 0.01).empty());
  EXPECT_TRUE(find_steps_beyond(std::vector<double>{1, 1.004, 0.998, 1.009, 1.001}, 0.01).empty());
  EXPECT_TRUE(find_steps_beyond(std::vector<double>{1, 1, 1.5, 1, 1}, 0.01).empty()) << "a spike";
  const std::vector<Step> last = find_steps_beyond(std::vector<double>{1, 1, 1, 1.011}, 0.01);
  ASSERT_EQ(last.size(), 1u) << "the last value counts at once";
  EXPECT_EQ(last[0].first, 3u);
  const std::vector<Step> two = find_steps_beyond(std::vector<double>{1, 1, 1.5, 1.02, 1.021, 1.021, 0.9, 0.9}, 0.01);
  ASSERT_EQ(two.size(), 3u);
  EXPECT_EQ(two[1].first, 3u);
  EXPECT_EQ(two[2].first, 6u);
  EXPECT_THROW((void)find_steps_beyond(std::vector<double>{1}, 0), std::invalid_argument);
}

TEST(ChangePoints, RefusesWhatIsNoSeries) {
  EXPECT_THROW((void)find_steps(std::vector<double>(9, std::nan(""))), std::invalid_argument);
  EXPECT_THROW((void)find_steps(std::vector<double>(9, 1.0), {0, 3, 0}), std::invalid_argument);
}

// A step of three times the noise is a slowdown of 10% where times scatter by 3%.
TEST(ChangePoints, DetectionRates) {
  EXPECT_GE(detections(10.0 / 3, 40, 24).found, 145);
  EXPECT_GE(detections(10.0 / 3, 40, 24).exact, 130);
  EXPECT_GE(detections(5, 40, 34).found, 140) << "six nightly runs after a step of five times the noise";
  EXPECT_GE(detections(10, 40, 36).found, 190) << "four nightly runs after a step of ten times the noise";
}

TEST(ChangePoints, TheErrorOfAStepIsThatOfIndependentOrCorrelatedNoise) {
  RandomEngine engine = make_engine("change_points_test", 5);
  for (const double correlation : {0.0, 0.6}) {
    std::vector<double> errors;
    for (int i = 0; i < 50; ++i) {
      std::vector<double> series = remembering_series(engine, kNightlyRuns, correlation);
      for (std::size_t nightly_run = 30; nightly_run < kNightlyRuns; ++nightly_run) series[nightly_run] += 8;
      const std::vector<Step> steps = find_steps(series);
      if (steps.size() == 1) errors.push_back(steps[0].error);
    }
    ASSERT_GE(errors.size(), 40u);
    std::sort(errors.begin(), errors.end());
    const double true_error = std::sqrt(2.0 / 30) * std::sqrt((1 + correlation) / (1 - correlation));
    EXPECT_GE(errors[errors.size() / 2], 0.7 * true_error) << correlation;
    EXPECT_LE(errors[errors.size() / 2], 2 * true_error) << correlation;
  }
}

TEST(ChangePointsSlow, FalseAlarmsOfIndependentNoiseAreAtMostOneInAThousand) {
  const int count = 5000;
  const auto spiky = [](RandomEngine& engine) {
    return standard_normal(engine) + (uniform_unit(engine) < 0.05 ? 10 * exponential(engine) : 0.0);
  };
  EXPECT_LE(alarms_of_noise(count, standard_normal), count / 1000);
  EXPECT_LE(alarms_of_noise(count, [](RandomEngine& engine) { return student(engine, 3); }), count / 1000);
  EXPECT_LE(alarms_of_noise(count, [](RandomEngine& engine) { return student(engine, 2); }), count / 1000);
  EXPECT_LE(alarms_of_noise(count, [](RandomEngine& e) { return exponential(e) - exponential(e); }), count / 1000);
  EXPECT_LE(alarms_of_noise(count, [](RandomEngine& e) { return exponential(e) + 0.3 * standard_normal(e); }),
            count / 1000);
  EXPECT_LE(alarms_of_noise(count, [](RandomEngine& e) { return std::round(standard_normal(e)); }), count / 1000);
  EXPECT_LE(alarms_of_noise(count, spiky), count / 1000);
}

// The table in README.md of harness/tracking/ is what this test prints; it holds the rates to what is promised there.
TEST(ChangePointsSlow, RatesByAutocorrelation) {
  const int stable = 10000, stepping = 500;
  std::printf("| autocorrelation | false alarms in %d, 40 / 60 nightly runs |", stable);
  std::printf(" 3.3 noises: found after 6 / 16 | 5 noises, 6 / 16 | 7 noises, 4 / 16 |\n");
  for (const double correlation : {0.0, 0.3, 0.6}) {
    const auto false_alarms = [=](std::size_t nightly_runs) {
      return alarms(stable,
                    [=](RandomEngine& engine) { return remembering_series(engine, nightly_runs, correlation); });
    };
    const auto rate = [=](double height, std::size_t nights_later) {
      return 100.0 * detections(height, 24 + nights_later, 24, stepping, correlation).found / stepping;
    };
    const int of_forty = false_alarms(40), of_sixty = false_alarms(kNightlyRuns);
    std::printf("| %.1f | %d / %d | %.0f%% / %.0f%% | %.0f%% / %.0f%% | %.0f%% / %.0f%% |\n", correlation, of_forty,
                of_sixty, rate(10.0 / 3, 6), rate(10.0 / 3, 16), rate(5, 6), rate(5, 16), rate(7, 4), rate(7, 16));
    EXPECT_LE(of_forty, 2 * stable / 1000) << correlation;
    EXPECT_LE(of_sixty, stable / 1000) << correlation;
    EXPECT_GE(rate(7, 16), correlation < 0.5 ? 90 : 65) << correlation;
  }
}

// Other noise that wanders: a slow part under independent noise, and one that is the mean of the last four values.
TEST(ChangePointsSlow, FalseAlarmsOfOtherNoiseThatRemembers) {
  const int count = 5000;
  const auto mixed = [](RandomEngine& engine) {
    std::vector<double> series = remembering_series(engine, kNightlyRuns, 0.8);
    for (double& value : series) value += standard_normal(engine);
    return series;
  };
  const auto moving_mean = [](RandomEngine& engine) {
    const std::vector<double> fresh = noise_series(engine, kNightlyRuns + 3, standard_normal);
    std::vector<double> series(kNightlyRuns);
    for (std::size_t i = 0; i < series.size(); ++i) series[i] = fresh[i] + fresh[i + 1] + fresh[i + 2] + fresh[i + 3];
    return series;
  };
  const int of_mixed = alarms(count, mixed), of_mean = alarms(count, moving_mean);
  std::printf("false alarms in %d: %d with a slow part, %d of a moving mean\n", count, of_mixed, of_mean);
  EXPECT_LE(of_mixed, 8 * count / 1000) << "its slow part has an autocorrelation of 0.8";
  EXPECT_LE(of_mean, 3 * count / 1000);
}

}  // namespace
}  // namespace mwt
