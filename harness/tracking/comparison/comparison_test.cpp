#include "harness/tracking/comparison/comparison.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "base/error.h"
#include "harness/tracking/comparison/comparison_text.h"
#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

using testing::SyntheticStudy;
using testing::Tamper;

constexpr std::uint64_t kSeed = 1;

ResultSet results_of(const SyntheticStudy& study, int nightly_run, const Tamper& tamper = {},
                     std::uint64_t seed = kSeed) {
  return {"night" + std::to_string(nightly_run),
          testing::synthetic_runs(study, nightly_run, seed, tamper),
          {testing::synthetic_environment()}};
}

SyntheticStudy twenty_pairs(double noise) {
  SyntheticStudy study;
  study.seeds = {1};
  study.repetitions = 20;
  study.noise = noise;
  return study;
}

/// Independent noise in every run, as two builds have it that are run in turn; wild values now and then.
Tamper paired_noise(double noise, const std::string& slow_algorithm = "", double factor = 1) {
  return [=](int nightly_run, RunRecord& run, RandomEngine& engine) {
    double time = 0.001 * std::exp(noise * standard_normal(engine));
    if (uniform_unit(engine) < 0.05) time *= 2;
    if (nightly_run == 1 && run.algorithm == slow_algorithm) time *= factor;
    run.wall_time_s = run.cpu_time_s = time;
  };
}

CompareOptions paired() {
  CompareOptions options;
  options.paired = true;
  return options;
}

const TimeRow& row_of(const std::vector<TimeRow>& rows, const std::string& algorithm) {
  for (const TimeRow& row : rows) {
    if (row.algorithm == algorithm) return row;
  }
  throw std::logic_error("no row of " + algorithm);
}

bool is_difference(Verdict verdict) { return verdict == Verdict::regression || verdict == Verdict::improvement; }

/// In how many of some experiments a slowdown of 15% was found and nothing else was.
int experiments_that_find_flip(double noise, std::uint64_t experiments) {
  const SyntheticStudy study = twenty_pairs(0);
  int found = 0;
  for (std::uint64_t seed = 1; seed <= experiments; ++seed) {
    const Comparison comparison = compare(results_of(study, 0, paired_noise(noise), seed),
                                          results_of(study, 1, paired_noise(noise, "flip", 1.15), seed), paired());
    found += row_of(comparison.algorithms, "flip").verdict == Verdict::regression;
    for (const std::vector<TimeRow>* rows : {&comparison.algorithms, &comparison.cells}) {
      for (const TimeRow& row : *rows) EXPECT_TRUE(row.algorithm == "flip" || !is_difference(row.verdict)) << seed;
    }
  }
  return found;
}

int false_alarms_of_pairs(double noise, std::uint64_t experiments) {
  const SyntheticStudy study = twenty_pairs(0);
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= experiments; ++seed) {
    alarms += compare(results_of(study, 0, paired_noise(noise), seed), results_of(study, 1, paired_noise(noise), seed),
                      paired())
                  .has_regression();
  }
  return alarms;
}

TEST(Compare, TwentyPairsFindASlowdownOfFifteenPercentAndNothingElse) {
  EXPECT_EQ(experiments_that_find_flip(0.05, 2), 2);
}

TEST(Compare, TwoBuildsThatAreAlikeGiveNoAlarm) { EXPECT_EQ(false_alarms_of_pairs(0.25, 3), 0); }

TEST(CompareSlow, TwentyPairsFindASlowdownOfFifteenPercent) {
  EXPECT_GE(experiments_that_find_flip(0.05, 20), 19);
  EXPECT_GE(experiments_that_find_flip(0.10, 20), 16);
  EXPECT_GE(experiments_that_find_flip(0.15, 20), 8);
}

TEST(CompareSlow, TwoBuildsThatAreAlikeGiveNoAlarm) {
  EXPECT_EQ(false_alarms_of_pairs(0.05, 20), 0);
  EXPECT_EQ(false_alarms_of_pairs(0.25, 20), 0);
}

TEST(Compare, SaysThatThereAreTooFewPairs) {
  SyntheticStudy study = twenty_pairs(0);
  const auto text = [&] {
    return comparison_text(
        compare(results_of(study, 0, paired_noise(0.05)), results_of(study, 1, paired_noise(0.05)), paired()), false);
  };
  EXPECT_EQ(text().find("too few repetitions"), std::string::npos);
  study.repetitions = 8;  // 24 cells: 2^-9 < 0.05 / 24 < 2^-8
  EXPECT_NE(text().find("too few repetitions to distinguish a single cell's change from noise: 9 are needed"),
            std::string::npos);
}

TEST(Compare, WhatSlowsBothOfAPairDoesNotMatter) {
  const SyntheticStudy study = twenty_pairs(0);
  const auto storm = [](int, RunRecord& run, RandomEngine&) {
    run.wall_time_s = run.cpu_time_s = 0.001 * std::pow(1.3, run.repetition);
  };
  const Comparison comparison = compare(results_of(study, 0, storm), results_of(study, 1, storm), paired());
  for (const TimeRow& row : comparison.cells) EXPECT_EQ(row.ratio.upper, 1);
}

TEST(Compare, LessThanTheThresholdIsNoRegression) {
  const SyntheticStudy study = twenty_pairs(0);
  const ResultSet base = results_of(study, 0, paired_noise(0.01));
  const ResultSet slower = results_of(study, 1, paired_noise(0.01, "flip", 1.03));
  EXPECT_FALSE(compare(base, slower, paired()).has_regression());
  CompareOptions keen = paired();
  keen.threshold = 0.01;
  EXPECT_TRUE(compare(base, slower, keen).has_regression());
}

TEST(Compare, AnImprovementIsNoRegression) {
  const SyntheticStudy study = twenty_pairs(0);
  const Comparison comparison = compare(results_of(study, 0, paired_noise(0.05)),
                                        results_of(study, 1, paired_noise(0.05, "exact", 0.7)), paired());
  EXPECT_FALSE(comparison.has_regression());
  EXPECT_EQ(row_of(comparison.algorithms, "exact").verdict, Verdict::improvement);
}

// Five sizes and two seeds on two families: 20 cells per algorithm, measured in two sessions that treat cells
// differently.
SyntheticStudy many_cells() {
  SyntheticStudy study;
  study.sizes = {100, 200, 500, 1000, 2000};
  return study;
}

int false_alarms_of_sessions(std::uint64_t experiments) {
  SyntheticStudy study = many_cells();
  study.noise = 0.1;
  const auto busier = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 0) return;
    *run.wall_time_s *= 1.4;
    *run.delaunay_time_s *= 1.4;
  };
  int alarms = 0;
  for (std::uint64_t seed = 1; seed <= experiments; ++seed) {
    const Comparison comparison = compare(results_of(study, 0, busier, seed), results_of(study, 1, busier, seed), {});
    EXPECT_EQ(comparison.time_measure, "relative_time");
    alarms += comparison.has_regression();
  }
  return alarms;
}

int sessions_that_find_patch(std::uint64_t experiments) {
  const auto slow_patch = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 1 && run.algorithm == "patch") *run.wall_time_s *= 1.15;
  };
  int found = 0;
  for (std::uint64_t seed = 1; seed <= experiments; ++seed) {
    const Comparison comparison =
        compare(results_of(many_cells(), 0, slow_patch, seed), results_of(many_cells(), 1, slow_patch, seed), {});
    found += row_of(comparison.algorithms, "patch").verdict == Verdict::regression;
    for (const TimeRow& row : comparison.algorithms)
      EXPECT_TRUE(row.algorithm == "patch" || !is_difference(row.verdict));
  }
  return found;
}

TEST(Compare, SessionsThatDifferGiveNoAlarm) { EXPECT_EQ(false_alarms_of_sessions(3), 0); }

TEST(Compare, FoldersShowASlowAlgorithm) { EXPECT_EQ(sessions_that_find_patch(2), 2); }

TEST(CompareSlow, SessionsThatDifferGiveNoAlarm) { EXPECT_EQ(false_alarms_of_sessions(20), 0); }

TEST(CompareSlow, FoldersShowASlowAlgorithm) { EXPECT_GE(sessions_that_find_patch(15), 14); }

TEST(Compare, WhatSlowsEverythingShowsOnlyInTheDelaunayTime) {
  const auto slow = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 1) *run.wall_time_s *= 1.3, *run.cpu_time_s *= 1.3;
  };
  const Comparison with = compare(results_of(many_cells(), 0, slow), results_of(many_cells(), 1, slow), {});
  EXPECT_EQ(row_of(with.algorithms, "all").verdict, Verdict::regression);
  SyntheticStudy without_delaunay_time = many_cells();
  without_delaunay_time.has_delaunay_time = false;
  const Comparison without =
      compare(results_of(without_delaunay_time, 0, slow), results_of(without_delaunay_time, 1, slow), {});
  EXPECT_EQ(without.time_measure, "cpu_time_s");
  EXPECT_EQ(row_of(without.algorithms, "all").verdict, Verdict::unclear);
  EXPECT_NEAR(row_of(without.algorithms, "all").ratio.value, 1.3, 0.03);
  EXPECT_FALSE(without.has_regression());
}

TEST(Compare, IdenticalBinariesAreReportedAsSuch) {
  const auto same_binary = [](int nightly_run, RunRecord& run, RandomEngine&) {
    run.binary_sha256 = "one";
    if (nightly_run == 1) *run.wall_time_s *= 3, *run.cpu_time_s *= 3;
  };
  const ResultSet base = results_of({}, 0, same_binary);
  const ResultSet now = results_of({}, 1, same_binary);
  const Comparison comparison = compare(base, now, {});
  EXPECT_FALSE(comparison.has_regression());
  for (const TimeRow& row : comparison.cells) EXPECT_EQ(row.verdict, Verdict::identical_binary);
  CompareOptions force;
  force.force = true;
  EXPECT_TRUE(compare(base, now, force).has_regression());
}

TEST(Compare, TimesOfDifferentMachinesAreRefused) {
  const auto slow = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 1 && run.algorithm == "exact") *run.wall_time_s *= 3;
  };
  const ResultSet base = results_of(many_cells(), 0, slow);
  ResultSet now = results_of(many_cells(), 1, slow);
  now.environments = {testing::synthetic_environment("Difference Engine")};
  const Comparison refused = compare(base, now, {});
  EXPECT_TRUE(refused.cells.empty());
  EXPECT_EQ(refused.outcome(), Outcome::not_compared);
  EXPECT_NE(comparison_text(refused, true).find("the machines differ: times are not compared"), std::string::npos);
  CompareOptions force;
  force.force = true;
  EXPECT_TRUE(compare(base, now, force).has_regression());
}

// Two shards of one study, on different machines each night.
TEST(Compare, MachinesAreComparedCellByCell) {
  const auto set_machine = [](ResultSet& results, const std::string& of_uniform, const std::string& of_others) {
    results.environments = {testing::synthetic_environment("A"), testing::synthetic_environment("B")};
    results.environments[0].env_id = "a";
    results.environments[1].env_id = "b";
    for (RunRecord& run : results.runs) run.env_id = run.generator == "uniform" ? of_uniform : of_others;
  };
  ResultSet base = results_of({}, 0), now = results_of({}, 1);
  set_machine(base, "a", "b");
  set_machine(now, "b", "b");
  const Comparison comparison = compare(base, now, {});
  EXPECT_EQ(comparison.cells_of_other_machines, 24u);
  EXPECT_EQ(comparison.cells.size(), 24u) << "those that one machine ran both times";
  EXPECT_EQ(comparison.outcome(), Outcome::not_compared);
}

TEST(Compare, NothingInCommonIsAMistake) {
  SyntheticStudy other;
  other.families = {"wheel"};
  EXPECT_THROW((void)compare(results_of({}, 0), results_of(other, 1), {}), InputError);
}

TEST(Compare, CellsOfOneSideAndOtherInstancesAreCounted) {
  SyntheticStudy fewer;
  fewer.algorithms = {"delaunay", "flip"};
  fewer.sizes = {100, 500};
  const auto other_points = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (run.generator == "clustered") run.instance_id += std::to_string(nightly_run);
  };
  const Comparison comparison = compare(results_of({}, 0, other_points), results_of(fewer, 1, other_points), {});
  EXPECT_EQ(comparison.compared_cells, 4u);
  const std::string text = comparison_text(comparison, false);
  EXPECT_NE(text.find("4 cells not compared: the generator makes other points now: delaunay on clustered n=100 seed=1"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("40 cells only in the base: delaunay on clustered n=1000 seed=1; "), std::string::npos) << text;
  EXPECT_NE(text.find("8 cells only in the new results: "), std::string::npos) << text;
  EXPECT_EQ(nlohmann::json::parse(comparison_json(comparison))["only_in_base"].size(), 40u) << "all by name";
}

TEST(Compare, AnAlgorithmThatVanishedIsARegression) {
  SyntheticStudy fewer;
  fewer.algorithms = {"delaunay", "exact", "flip", "greedy", "patch"};
  const Comparison comparison = compare(results_of({}, 0), results_of(fewer, 1), {});
  EXPECT_TRUE(comparison.has_sure_regression());
  EXPECT_TRUE(comparison_text(comparison, false)
                  .starts_with("1 regression (sweep on all instances: has no runs any more; the base "
                               "has 8 cells)"))
      << comparison_text(comparison, false);
  EXPECT_FALSE(compare(results_of(fewer, 0), results_of({}, 1), {}).has_sure_regression()) << "a new one";
}

TEST(Compare, ACellThatVanishedIsARegressionByName) {
  ResultSet fewer = results_of({}, 1);
  std::erase_if(fewer.runs, [](const RunRecord& run) {
    return run.algorithm == "greedy" && run.generator == "uniform" && run.n == 1000 && run.seed == 2;
  });
  const Comparison comparison = compare(results_of({}, 0), fewer, {});
  EXPECT_TRUE(comparison.has_sure_regression());
  EXPECT_TRUE(comparison_text(comparison, false)
                  .starts_with("1 regression (greedy on uniform n=1000 seed=2: is not run any more)"))
      << comparison_text(comparison, false);
  EXPECT_EQ(comparison.outcome(), Outcome::regression);
}

TEST(Compare, TheVerdictNamesCommitsFactorAndInterval) {
  const auto slower = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 1 && run.algorithm == "greedy") *run.wall_time_s *= 1.5;
  };
  const Comparison comparison = compare(results_of({}, 0, slower), results_of({}, 1, slower), {});
  const std::string text = comparison_text(comparison, false);
  EXPECT_TRUE(std::regex_search(text, std::regex("time of greedy x1\\.[45]\\d\\d \\(1\\.[345]\\d\\d \\.\\. "
                                                 "1\\.[456]\\d\\d\\), by itself in \\d of 8 cells")))
      << text;
  EXPECT_NE(text.find("base: commit cccccccccc; new: commit cccccccccc"), std::string::npos) << text;
}

// What a nightly study is like: one algorithm became slower by a fifth, and the noise was taken for sameness.
SyntheticStudy small_nightly_run() {
  SyntheticStudy study;
  study.algorithms = {"delaunay", "flip", "greedy"};
  study.noise = 0.1;
  return study;
}

TEST(Compare, ASlowdownThatIsNotExcludedIsNeverTheSame) {
  for (const double factor : {1.2, 3.0}) {
    const auto slow_flip = [=](int nightly_run, RunRecord& run, RandomEngine&) {
      if (nightly_run == 1 && run.algorithm == "flip") *run.wall_time_s *= factor;
    };
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      const Comparison comparison = compare(results_of(small_nightly_run(), 0, slow_flip, seed),
                                            results_of(small_nightly_run(), 1, slow_flip, seed), {});
      const Verdict flip = row_of(comparison.algorithms, "flip").verdict;
      EXPECT_TRUE(flip == Verdict::unclear || flip == Verdict::regression) << factor << ' ' << seed;
      EXPECT_NE(comparison.outcome(), Outcome::not_slower);
      std::size_t open = 0;
      for (const TrackedCell& cell : comparison.open_cells()) open += cell.algorithm == "flip" ? 1U : 0U;
      EXPECT_EQ(open, 8u) << "all of its cells are to be run in turn";
    }
  }
}

TEST(Compare, FoldersOfAQuietMachineExcludeASlowdown) {
  SyntheticStudy study = small_nightly_run();
  study.noise = 0.002;
  const Comparison comparison = compare(results_of(study, 0), results_of(study, 1), {});
  for (const TimeRow& row : comparison.algorithms) EXPECT_EQ(row.verdict, Verdict::same) << row.algorithm;
  EXPECT_EQ(comparison.outcome(), Outcome::not_slower) << comparison_text(comparison, true);
  EXPECT_TRUE(comparison.open_cells().empty());
}

// On either side: a base that was slowed by others would hide a slowdown.
TEST(Compare, FoldersOfABusyMachineExcludeNothing) {
  SyntheticStudy study = small_nightly_run();
  study.noise = 0.002;
  for (const bool base_is_busy : {true, false}) {
    ResultSet base = results_of(study, 0), now = results_of(study, 1);
    for (RunRecord& run : (base_is_busy ? base : now).runs) *run.wall_time_s *= 2;
    const Comparison comparison = compare(base, now, {});
    EXPECT_EQ(comparison.outcome(), Outcome::unclear);
    const std::string text = comparison_text(comparison, false);
    EXPECT_NE(text.find("the machine was busy with other programs"), std::string::npos) << text;
    EXPECT_NE(text.find("its runs had the CPU 50% of the time"), std::string::npos) << text;
  }
}

// Such a base is compared by wall times, on both sides.
TEST(Compare, ABaseWhoseCpuClockTickedExcludesNothing) {
  SyntheticStudy study = small_nightly_run();
  study.noise = 0.002;
  ResultSet base = results_of(study, 0), now = results_of(study, 1);
  base.has_ticking_clock = true;
  for (RunRecord& run : now.runs) *run.cpu_time_s /= 2;
  const Comparison comparison = compare(base, now, {});
  EXPECT_NEAR(row_of(comparison.algorithms, "flip").ratio.value, 1, 0.01);
  EXPECT_EQ(comparison.outcome(), Outcome::unclear);
}

TEST(Compare, FoldersOfAMachineThatBecameSlowerExcludeNothing) {
  SyntheticStudy study = small_nightly_run();
  study.noise = 0.002;
  const auto slower = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 1) *run.wall_time_s *= 1.3, *run.delaunay_time_s *= 1.3;
  };
  const Comparison comparison = compare(results_of(study, 0, slower), results_of(study, 1, slower), {});
  EXPECT_EQ(comparison.outcome(), Outcome::unclear);
  EXPECT_NE(comparison_text(comparison, false).find("the Delaunay time itself took x1.300 as long"), std::string::npos);
}

TEST(Compare, FasterButNotSurelySoIsNotTheSame) {
  const auto faster = [](int nightly_run, RunRecord& run, RandomEngine& engine) {
    const double ratio = run.repetition % 2 == 0 ? 0.93 : 0.99;
    run.wall_time_s = 0.001 * (nightly_run == 1 ? ratio : 1) * std::exp(0.001 * standard_normal(engine));
  };
  const SyntheticStudy study = twenty_pairs(0);
  const Comparison comparison = compare(results_of(study, 0, faster), results_of(study, 1, faster), paired());
  for (const TimeRow& row : comparison.cells) EXPECT_EQ(row.verdict, Verdict::not_slower) << row.ratio.lower;
  EXPECT_EQ(comparison.outcome(), Outcome::not_slower);
}

TEST(Compare, TooFewPairsAreUnclear) {
  SyntheticStudy study = twenty_pairs(0);
  study.repetitions = 4;  // 2^-4 > 5%
  const auto equal = [](int, RunRecord& run, RandomEngine&) { run.wall_time_s = 0.001; };
  const Comparison comparison = compare(results_of(study, 0, equal), results_of(study, 1, equal), paired());
  for (const TimeRow& row : comparison.cells) EXPECT_EQ(row.verdict, Verdict::unclear);
  EXPECT_TRUE(comparison_text(comparison, false).starts_with("0 regressions, 0 improvements, 7 unclear (time of "));
}

TEST(Compare, MissingTimesAreNotSilent) {
  const auto timeless = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 1 && run.algorithm == "flip") run.wall_time_s = std::nullopt;
  };
  SyntheticStudy study = small_nightly_run();
  study.noise = 0.002;
  const Comparison comparison = compare(results_of(study, 0, timeless), results_of(study, 1, timeless), {});
  EXPECT_EQ(comparison.untimed.size(), 8u);
  EXPECT_EQ(comparison.outcome(), Outcome::unclear);
}

TEST(Compare, WhatFailsOnBothSidesIsNamed) {
  const auto fail = [](int, RunRecord& run, RandomEngine&) {
    if (run.algorithm == "flip" && run.n == 100 && run.generator == "uniform" && run.seed == 2)
      run.status = RunStatus::crashed;
  };
  const Comparison comparison = compare(results_of({}, 0, fail), results_of({}, 1, fail), {});
  EXPECT_FALSE(comparison.has_sure_regression());
  EXPECT_NE(
      comparison_text(comparison, false).find("1 cell with failed runs on both sides: flip on uniform n=100 seed=2"),
      std::string::npos);
}

TEST(Compare, OtherSchemaVersionsAreRefused) {
  ResultSet old = results_of({}, 0);
  old.schema_version = 1;
  EXPECT_THROW((void)compare(old, results_of({}, 1), {}), InputError);
}

TEST(Compare, AnInstanceThatCannotBeMadeAnyMoreIsAFailure) {
  const auto fail = [](int nightly_run, RunRecord& run, RandomEngine&) {
    if (nightly_run == 0 || run.generator != "uniform") return;
    run.instance_id = "";
    run.status = RunStatus::error;
    run.wall_time_s = run.cpu_time_s = std::nullopt;
  };
  const Comparison comparison = compare(results_of({}, 0, fail), results_of({}, 1, fail), {});
  EXPECT_EQ(comparison.compared_cells, 48u);
  EXPECT_TRUE(comparison.has_sure_regression());
}

TEST(Compare, JsonAndMarkdownSayTheSame) {
  const SyntheticStudy study = twenty_pairs(0);
  const Comparison comparison = compare(results_of(study, 0, paired_noise(0.05)),
                                        results_of(study, 1, paired_noise(0.05, "flip", 1.5)), paired());
  const auto json = nlohmann::json::parse(comparison_json(comparison));
  EXPECT_EQ(json["regression"], true);
  EXPECT_EQ(json["algorithms"].size(), 7u) << "six and all";
  EXPECT_EQ(json["cells"].size(), 24u);
  EXPECT_EQ(json["cells"][0]["ratio"], comparison.cells[0].ratio.value);
  EXPECT_NEAR(json["cells"][0]["base"].get<double>(), 0.001, 1e-4);
  EXPECT_FALSE(json["algorithms"][0].contains("base")) << "its cells are not alike";
  EXPECT_EQ(json["outcome"], "regression");
  const std::string markdown = comparison_markdown(comparison, false);
  EXPECT_TRUE(markdown.starts_with("**1 regression (time of flip x1.")) << markdown;
  EXPECT_NE(markdown.find("| flip | 20 | 1."), std::string::npos) << markdown;
}

}  // namespace
}  // namespace mwt
