#include "harness/report/optima.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

InstanceRecord instance(Index n, std::uint64_t seed, std::optional<Interval> optimum) {
  InstanceRecord record;
  record.generator = "uniform";
  record.n = n;
  record.seed = seed;
  record.instance_id = std::to_string(n) + '/' + std::to_string(seed);
  if (optimum) {
    record.optimum_lower = optimum->lower;
    record.optimum_upper = optimum->upper;
  }
  record.optimum_time_s = 7;
  return record;
}

RunRecord exact_run(const InstanceRecord& of, double lower, double time_s) {
  RunRecord run;
  run.status = RunStatus::ok;
  run.generator = of.generator;
  run.n = of.n;
  run.instance_id = of.instance_id;
  run.certified_lower = lower;
  run.wall_time_s = time_s;
  run.peak_rss_bytes = static_cast<std::uint64_t>(1e6 * time_s);
  run.optimum_lower = lower;
  run.optimum_upper = 2;
  return run;
}

class OptimaOfAStudy : public ::testing::Test {
 protected:
  OptimaOfAStudy() {
    records_.instances = {instance(10, 1, Interval{1, 2}), instance(10, 2, std::nullopt),
                          instance(20, 1, Interval{2, 2})};
    records_.runs = {exact_run(records_.instances[0], 2, 3), exact_run(records_.instances[0], 2, 0.5),
                     exact_run(records_.instances[0], 1.5, 0.1), exact_run(records_.instances[2], 2, 1)};
    records_.runs[2].optimum_lower = 2;  // rated by all
    RunRecord heuristic = records_.runs[3];
    heuristic.certified_lower.reset();
    records_.runs[3] = heuristic;
  }

  StudyRecords records_;
};

TEST_F(OptimaOfAStudy, AreTheBestInTheRecords) {
  const std::vector<OptimumCell> optima = optima_of(records_);
  ASSERT_EQ(optima.size(), 2u);
  EXPECT_EQ(optima[0].instances, 2u);
  EXPECT_EQ(optima[0].proved, 1u) << "by a run, not by the search";
  EXPECT_EQ(optima[0].without_bounds, 1u);
  EXPECT_EQ(optima[0].time_s, 7) << "of the search that found nothing";
  EXPECT_EQ(optima[0].peak_rss_bytes, 500'000u) << "of the fastest run that proves it";
  EXPECT_EQ(optima[1].proved, 1u);
}

TEST_F(OptimaOfAStudy, ShowTheWidestInterval) {
  for (RunRecord& run : records_.runs) run.optimum_lower = run.instance_id == "10/1" ? 1.5 : 1.75;
  const std::vector<OptimumCell> optima = optima_of(records_);
  EXPECT_EQ(optima[0].proved + optima[1].proved, 0u);
  EXPECT_DOUBLE_EQ(optima[0].widest, 0.25);
  EXPECT_DOUBLE_EQ(optima[1].widest, 0.125);
  EXPECT_EQ(optimum_table(optima),
            "optima of the instances\n"
            "n   instances  proved  widest interval  no bounds\n"
            "10          2       0             25 %          1\n"
            "20          1       0             12 %          0\n");
}

TEST_F(OptimaOfAStudy, CountWhatTheVerifierSays) {
  EXPECT_EQ(optimum_summary(optima_of(records_)), "optima: 2 of 3 instances proved\n");
  EXPECT_EQ(rejected_proof_table(records_.instances), "");
  records_.instances[0].verified = ProofVerdict::optimal;
  records_.instances[2].verified = ProofVerdict::refused;
  records_.instances[2].proof_note = "step 3: it does not follow";
  EXPECT_EQ(
      optimum_summary(optima_of(records_)),
      "optima: 2 of 3 instances proved; mwt_verify verifies 1 of them, and bounds of 0 others; it refuses 1 proofs "
      "and has no verdict on 0\n");
  EXPECT_EQ(rejected_proof_table(records_.instances),
            "proof of             verdict  why\n"
            "uniform n=20 seed=1  refused  step 3: it does not follow\n");
}

TEST_F(OptimaOfAStudy, LeaveOutFamiliesWithoutRuns) {
  records_.instances[1].generator = "normal";
  EXPECT_EQ(optima_of(records_).size(), 2u);
}

}  // namespace
}  // namespace mwt
