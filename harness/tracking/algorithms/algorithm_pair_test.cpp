#include "harness/tracking/algorithms/algorithm_pair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "harness/tracking/algorithms/algorithm_pair_text.h"
#include "harness/tracking/testing/synthetic_nightly_runs.h"

namespace mwt {
namespace {

using testing::SyntheticStudy;

// 12 seeds on two families and two sizes. Synthetic weights are 105 for "patch" and 106 for "greedy", times 5 and 6 ms.
ResultSet results(const testing::Tamper& tamper = {}) {
  SyntheticStudy study;
  study.seeds = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  return {"results/x", testing::synthetic_runs(study, 0, 1, tamper), {testing::synthetic_environment()}};
}

AlgorithmPair greedy_against_patch(const testing::Tamper& tamper = {}) {
  return compare_algorithms(results(tamper), {"greedy", "patch", {}});
}

std::string mistake(const ResultSet& results, const AlgorithmPairOptions& options) {
  try {
    (void)compare_algorithms(results, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(AlgorithmPair, PairsInstancesAndJudgesEachCellAndAll) {
  const AlgorithmPair pair = greedy_against_patch();
  ASSERT_EQ(pair.alpha.size(), 5u);
  for (const PairRow& row : pair.alpha) {
    EXPECT_EQ(row.comparison.pairs(), row.n == 0 ? 48u : 12u);
    EXPECT_NEAR(std::exp(row.comparison.shift), 105.0 / 106, 1e-12);
    EXPECT_EQ(row.comparison.effect, -1);
    EXPECT_EQ(row.verdict, PairVerdict::b_is_better);
  }
  EXPECT_EQ(pair.alpha[0].a, 1.06);
  EXPECT_EQ(pair.alpha[0].b, 1.05);
  EXPECT_DOUBLE_EQ(pair.alpha[0].q_value, 2.0 / 4096);  // the smallest of 12 pairs; equal p-values are not adjusted
  ASSERT_EQ(pair.times.size(), 5u);
  EXPECT_EQ(pair.time_measure, "cpu_time_s");
  const PairRow& all = pair.times.back();
  ASSERT_TRUE(all.comparison.interval);
  EXPECT_LT(all.comparison.interval->lower, std::log(5.0 / 6));
  EXPECT_GT(all.comparison.interval->upper, std::log(5.0 / 6));
  EXPECT_EQ(all.verdict, PairVerdict::b_is_better);
}

TEST(AlgorithmPair, CertifiedWeightsThatMeetAreEqual) {
  const auto meet = [](int, RunRecord& run, RandomEngine&) { run.weight_lower = 100, run.weight_upper = 110; };
  const AlgorithmPair pair = greedy_against_patch(meet);
  EXPECT_EQ(pair.alpha.back().comparison.zero, 48u);
  EXPECT_EQ(pair.alpha.back().verdict, PairVerdict::equal);
  EXPECT_NE(summary_of(pair).find("alpha: equal"), std::string::npos) << summary_of(pair);
}

// In one cell of four greedy is lighter on 10 of 12: p = 0.0049 of ranks 1 and 2 lost; nowhere else is a difference.
TEST(AlgorithmPair, CellsAreCorrectedForTheirNumber) {
  const auto weigh = [](int, RunRecord& run, RandomEngine&) {
    const bool is_cell = run.generator == "uniform" && run.n == 100;
    const bool is_worse = run.seed <= 2;
    const double size = static_cast<double>(run.seed);
    const double weight = !is_cell || run.algorithm == "greedy" ? 100 : is_worse ? 100 - size : 100 + size;
    run.weight_lower = run.weight_upper = weight;
  };
  const AlgorithmPair pair = greedy_against_patch(weigh);
  for (const PairRow& row : pair.alpha) {
    const bool is_cell = row.family == "uniform" && row.n == 100;
    if (!is_cell) continue;
    EXPECT_NEAR(row.q_value, 4 * row.comparison.p_value, 1e-12) << "the three other cells have p = 1";
    EXPECT_EQ(row.verdict, PairVerdict::a_is_better);
    EXPECT_EQ(row.comparison.positive, 10u);
  }
}

TEST(AlgorithmPair, WithoutAnOptimumWeightsCompareAllTheSame) {
  const auto forget = [](int, RunRecord& run, RandomEngine&) {
    run.optimality = "none";
    run.alpha_lower = run.alpha_upper = run.optimum_lower = run.optimum_upper = {};
  };
  const AlgorithmPair pair = greedy_against_patch(forget);
  EXPECT_FALSE(pair.alpha[0].a);
  EXPECT_EQ(pair.alpha.back().verdict, PairVerdict::b_is_better);
}

TEST(AlgorithmPair, FailuresEarlyEndsAndOtherMachinesAreSaid) {
  const auto tamper = [](int, RunRecord& run, RandomEngine&) {
    if (run.algorithm == "patch" && run.seed == 3) run.status = RunStatus::timeout;
    if (run.algorithm == "greedy" && run.seed == 4) run.stopped_early = true;
    if (run.algorithm == "greedy" && run.seed == 5) run.env_id = "another";
  };
  ResultSet tampered = results(tamper);
  tampered.environments.push_back(testing::synthetic_environment("Difference Engine"));
  tampered.environments.back().env_id = "another";
  const AlgorithmPair pair = compare_algorithms(tampered, {"greedy", "patch", {}});
  const std::string text = algorithm_pair_text(pair);
  EXPECT_NE(text.find("left out: 4 instances on which greedy alone succeeded, 0 on which patch alone did, 0 on which "
                      "neither did (timeout)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("stopped early, and compared as they are: greedy on 4 instances"), std::string::npos) << text;
  EXPECT_NE(text.find("times left out of 4 instances: different machines"), std::string::npos) << text;
  EXPECT_EQ(pair.alpha.back().comparison.pairs(), 44u);
  EXPECT_EQ(pair.times.back().comparison.pairs(), 40u);
}

TEST(AlgorithmPair, ParametersChooseAmongSeveral) {
  const auto two_flips = [](int, RunRecord& run, RandomEngine&) {
    if (run.algorithm == "patch" || run.algorithm == "greedy") {
      run.params = run.algorithm == "patch" ? "order=stack start=sweep" : "order=stack start=greedy";
      run.algorithm = "flip";
    } else if (run.algorithm == "flip") {
      run.algorithm = "delaunay";
      run.seed += 100;
    }
  };
  const ResultSet both = results(two_flips);
  const AlgorithmPair pair = compare_algorithms(both, {"flip start=sweep", "flip start=greedy", {}});
  EXPECT_EQ(pair.a, "flip order=stack start=sweep");
  EXPECT_EQ(pair.b, "flip order=stack start=greedy");
  EXPECT_NE(mistake(both, {"flip", "exact", {}}).find("has several of these; add a parameter"), std::string::npos);
}

TEST(AlgorithmPair, Mistakes) {
  const ResultSet some = results();
  EXPECT_NE(mistake(some, {"greedy", "nothing", {}}).find("results/x has no such algorithm; it has: delaunay, exact"),
            std::string::npos);
  EXPECT_NE(mistake(some, {"greedy", "greedy", {}}).find("are both greedy"), std::string::npos);
  EXPECT_NE(mistake(some, {"greedy", "patch", "weight"}).find("not a time"), std::string::npos);
  const auto fail = [](int, RunRecord& run, RandomEngine&) {
    if (run.algorithm == "patch") run.status = RunStatus::crashed;
  };
  EXPECT_NE(mistake(results(fail), {"greedy", "patch", {}}).find("no instance on which both"), std::string::npos);
}

TEST(AlgorithmPair, TextAndJsonAgree) {
  const AlgorithmPair pair = greedy_against_patch();
  const auto json = nlohmann::json::parse(algorithm_pair_json(pair));
  EXPECT_EQ(json["alpha"].size(), 5u);
  EXPECT_EQ(json["alpha"][4]["family"], "all");
  EXPECT_EQ(json["alpha"][4]["verdict"], "patch better");
  EXPECT_EQ(json["alpha"][4]["b_better"], 48);
  EXPECT_TRUE(json["times"][0]["ratio_lower"].is_number());
  const std::string text = algorithm_pair_text(pair);
  EXPECT_NE(text.find("alpha: patch better (patch better on 48 of 48 instances, equal on 0; B/A x0.9906"),
            std::string::npos)
      << text;
  EXPECT_NE(algorithm_pair_markdown(pair).find("| uniform | 100 | 12 | 1.0600 | 1.0500 | 0.9906 |"), std::string::npos)
      << algorithm_pair_markdown(pair);
}

}  // namespace
}  // namespace mwt
