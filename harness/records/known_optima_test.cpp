#include "harness/records/known_optima.h"

#include <gtest/gtest.h>

#include <limits>

namespace mwt {
namespace {

RunRecord run_of_weight(double weight, const std::string& algorithm = "greedy") {
  RunRecord record;
  record.run_id = algorithm + std::to_string(weight);
  record.algorithm = algorithm;
  record.instance_id = "instance";
  record.status = RunStatus::ok;
  record.weight_lower = weight;
  record.weight_upper = weight;
  return record;
}

RunRecord exact_run(double lower, double weight) {
  RunRecord record = run_of_weight(weight, "exact");
  record.certified_lower = lower;
  return record;
}

InstanceRecord instance_with(double lower, double upper) {
  InstanceRecord record;
  record.instance_id = "instance";
  record.optimum_lower = lower;
  record.optimum_upper = upper;
  record.optimality = "proved";
  record.optimum_source = "exact";
  return record;
}

// The row as it is recorded when it comes.
RunRecord rated(KnownOptima& known, RunRecord record) {
  EXPECT_TRUE(known.add(record).empty());
  known.rate(record);
  return record;
}

TEST(KnownOptima, WithoutABoundThereIsNoAlpha) {
  KnownOptima known;
  const RunRecord record = rated(known, run_of_weight(10));
  EXPECT_FALSE(record.alpha_upper);
  EXPECT_FALSE(record.optimum_lower);
  EXPECT_EQ(record.optimality, "none");
  EXPECT_EQ(record.optimal, "undecided");
}

TEST(KnownOptima, RatesAgainstWhatIsKnown) {
  KnownOptima known;
  EXPECT_TRUE(known.add(instance_with(8, 8)).empty());
  const RunRecord record = rated(known, run_of_weight(10));
  EXPECT_EQ(record.alpha_lower, 1.25);
  EXPECT_EQ(record.alpha_upper, 1.25);
  EXPECT_EQ(record.optimality, "proved");
  EXPECT_EQ(record.optimal, "no");
}

TEST(KnownOptima, ALighterTriangulationImprovesAnUpperBound) {
  KnownOptima known;
  EXPECT_TRUE(known.add(instance_with(5, 12)).empty());
  EXPECT_EQ(rated(known, run_of_weight(10)).optimum_upper, 10);
  EXPECT_EQ(known.of("instance")->upper, 10);
  EXPECT_EQ(rated(known, run_of_weight(11)).optimum_upper, 10);
}

TEST(KnownOptima, WhatARunCertifiesServesLaterRuns) {
  KnownOptima known;
  EXPECT_EQ(rated(known, exact_run(10, 10)).optimal, "yes");
  EXPECT_EQ(rated(known, run_of_weight(20)).alpha_upper, 2);
}

// "exact" proved 5.2512 where the optimum was 5.00756, and greedy's row became the error.
TEST(KnownOptima, ATriangulationLighterThanAnOptimumDisprovesTheClaimant) {
  KnownOptima known;
  EXPECT_TRUE(known.add(instance_with(10, 10)).empty());
  RunRecord lighter = run_of_weight(9);
  const std::vector<Disproof> disproofs = known.add(lighter);
  ASSERT_EQ(disproofs.size(), 1u);
  EXPECT_EQ(disproofs[0].claim.id, "instance");
  EXPECT_EQ(disproofs[0].claim.claimant, "exact");
  EXPECT_EQ(disproofs[0].witness, "greedy");
  known.rate(lighter);
  EXPECT_EQ(lighter.status, RunStatus::ok);
  EXPECT_FALSE(lighter.alpha_upper);
  EXPECT_EQ(lighter.optimality, "none");
  EXPECT_FALSE(known.of("instance"));
}

TEST(KnownOptima, ABoundThatIsNoNumberIsNoClaim) {
  KnownOptima known;
  EXPECT_TRUE(known.add(instance_with(std::numeric_limits<double>::quiet_NaN(), 10)).empty());
  EXPECT_TRUE(known.add(instance_with(std::numeric_limits<double>::infinity(), 10)).empty());
  EXPECT_TRUE(known.add(instance_with(-1, 10)).empty());
  EXPECT_FALSE(known.of("instance"));
}

TEST(KnownOptima, FailedRunsStayAsTheyAre) {
  KnownOptima known;
  EXPECT_TRUE(known.add(instance_with(10, 10)).empty());
  RunRecord record = run_of_weight(1);
  record.status = RunStatus::timeout;
  record = rated(known, record);
  EXPECT_EQ(record.optimality, "");
  EXPECT_FALSE(record.optimum_lower);
}

TEST(RejectDisproved, TheClaimantsRowsAreErrorsAndTheOthersAreRatedAnew) {
  KnownOptima known;
  std::vector<InstanceRecord> instances = {instance_with(10, 10)};
  EXPECT_TRUE(known.add(instances[0]).empty());
  std::vector<RunRecord> runs = {rated(known, exact_run(10, 10)), rated(known, run_of_weight(12)),
                                 run_of_weight(9, "patch")};
  ASSERT_TRUE(runs[1].alpha_upper);
  EXPECT_EQ(reject_disproved(runs, instances).size(), 2u);
  EXPECT_EQ(runs[0].status, RunStatus::error);
  EXPECT_EQ(
      runs[0].message,
      "CONTRADICTION: exact certified that no triangulation weighs less than 10, but a checked one of patch weighs 9");
  EXPECT_FALSE(runs[0].alpha_upper);
  EXPECT_EQ(runs[0].optimality, "");
  EXPECT_TRUE(is_disproved(runs[0]));
  EXPECT_EQ(runs[1].status, RunStatus::ok);
  EXPECT_FALSE(runs[1].alpha_upper) << "it was rated by what is disproved";
  EXPECT_EQ(runs[1].optimality, "none");
  EXPECT_EQ(runs[2].status, RunStatus::ok);
  EXPECT_EQ(instances[0].optimality, "none");
  EXPECT_EQ(instances[0].optimum_source, "");
  EXPECT_FALSE(instances[0].optimum_lower);
  EXPECT_TRUE(is_disproved(instances[0]));
  EXPECT_TRUE(reject_disproved(runs, instances).empty()) << "settled";
}

TEST(RejectDisproved, WhatStandsRatesTheOthers) {
  std::vector<InstanceRecord> instances = {instance_with(10, 10)};
  std::vector<RunRecord> runs = {exact_run(9, 9), run_of_weight(18)};
  runs[0].algorithm = "subset_dp";
  EXPECT_EQ(reject_disproved(runs, instances).size(), 1u);
  EXPECT_TRUE(is_disproved(instances[0]));
  EXPECT_EQ(runs[0].optimal, "yes");
  EXPECT_EQ(runs[1].alpha_upper, 2);
}

}  // namespace
}  // namespace mwt
