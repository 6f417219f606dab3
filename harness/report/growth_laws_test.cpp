#include "harness/report/growth_laws.h"

#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/registry.h"
#include "generators/registry.h"

namespace mwt {
namespace {

// A catalogue of one algorithm and one family that states a law about it.
class GrowthLaws : public testing::Test {
 protected:
  GrowthLaws() {
    algorithm_.name = "slow_hand";
    algorithm_.parameters = {{"start", ParameterType::text, "here", "where from"}};
    family_.name = "trap";
    family_.parameters = {{"depth", ParameterType::integer, "3", "how deep"}};
    law_.algorithm = "slow_hand";
    law_.lowest = .95;
    law_.highest = 1.05;
    law_.min_n = 100;
    law_.max_n = 10'000;
  }

  void add(Index n, double alpha_lower, double alpha_upper, const std::string& seed = "") {
    RunRecord run;
    run.generator = "trap";
    run.generator_params = "depth=3";
    run.algorithm = "slow_hand";
    run.params = "start=here";
    run.n = n;
    run.instance_id = std::to_string(n) + seed;
    run.status = RunStatus::ok;
    run.alpha_lower = alpha_lower;
    run.alpha_upper = alpha_upper;
    runs_.push_back(run);
  }
  void add(Index n, double alpha, const std::string& seed = "") { add(n, alpha, alpha * (1 + 1e-12), seed); }

  std::vector<LawFinding> findings() {
    family_.growth_laws = {law_};
    return test_growth_laws(runs_, Catalogue({&algorithm_, 1}, {&family_, 1}));
  }
  Agreement agreement() { return findings().at(0).agreement; }

  AlgorithmInfo algorithm_;
  GeneratorInfo family_;
  GrowthLaw law_;
  std::vector<RunRecord> runs_;
};

TEST_F(GrowthLaws, a_line_through_the_logarithms_is_recognised) {
  for (const Index n : {100U, 200U, 400U, 800U}) add(n, .01 * n);
  const LawFinding finding = findings().at(0);
  EXPECT_EQ(finding.agreement, Agreement::agrees);
  EXPECT_EQ(finding.sizes, 4U);
  EXPECT_NEAR(finding.measured.value, 1, 1e-9);
  EXPECT_NEAR(finding.measured.lower, 1, 1e-9);
  EXPECT_NEAR(finding.measured.upper, 1, 1e-9);
}

TEST_F(GrowthLaws, another_exponent_disagrees) {
  for (const Index n : {100U, 200U, 400U, 800U}) add(n, std::sqrt(n));
  EXPECT_EQ(agreement(), Agreement::disagrees);
}

TEST_F(GrowthLaws, a_curve_whose_slopes_meet_the_law_is_undecided) {
  add(100, 1);
  add(200, 2);
  add(400, 3);
  EXPECT_EQ(agreement(), Agreement::undecided);
}

TEST_F(GrowthLaws, several_instances_per_size_give_a_bootstrap_interval) {
  for (const Index n : {100U, 400U, 1600U}) {
    for (int seed = 0; seed < 8; ++seed) add(n, n * (1 + .05 * (seed % 4)), std::to_string(seed));
  }
  const LawFinding finding = findings().at(0);
  EXPECT_EQ(finding.agreement, Agreement::agrees);
  EXPECT_LT(finding.measured.lower, finding.measured.value);
  EXPECT_GT(finding.measured.upper, finding.measured.value);
}

TEST_F(GrowthLaws, two_sizes_or_a_narrow_range_are_too_few) {
  add(100, 1);
  add(1000, 10);
  EXPECT_EQ(agreement(), Agreement::too_few_sizes);
  runs_.clear();
  for (const Index n : {100U, 200U, 300U}) add(n, .01 * n);
  EXPECT_EQ(agreement(), Agreement::too_few_sizes);
}

TEST_F(GrowthLaws, what_the_law_does_not_speak_of_is_left_out) {
  for (const Index n : {100U, 200U, 400U}) add(n, .01 * n);
  add(50, 1000);
  add(20'000, 1);
  add(800, 1);
  runs_.back().params = "start=there";
  add(800, 1);
  runs_.back().generator_params = "depth=4";
  add(800, 1);
  runs_.back().status = RunStatus::timeout;
  add(800, 1, 1.2);
  add(200, 77);  // a repetition: same instance
  EXPECT_NEAR(findings().at(0).measured.value, 1, 1e-9);
  EXPECT_EQ(findings().at(0).sizes, 3U);
}

TEST_F(GrowthLaws, a_range_holds_if_every_alpha_lies_in_it_for_certain) {
  law_.kind = GrowthLaw::Kind::range;
  law_.lowest = 1.2;
  law_.highest = 1.3;
  add(100, 1.21);
  add(200, 1.29);
  EXPECT_EQ(agreement(), Agreement::agrees);
  add(300, 1.299, 1.301);
  EXPECT_EQ(agreement(), Agreement::undecided);
  add(400, 1.31);
  EXPECT_EQ(agreement(), Agreement::disagrees);
}

TEST_F(GrowthLaws, the_table_shows_law_and_measurement) {
  for (const Index n : {100U, 200U, 400U, 800U}) add(n, .01 * n);
  const std::string table = growth_law_table(findings());
  for (const char* text :
       {"trap", "slow_hand", "100..800", "exponent [0.95, 1.05]", "1.000 [1.0000, 1.0000]", "agrees"}) {
    EXPECT_NE(table.find(text), std::string::npos) << text << '\n' << table;
  }
  EXPECT_EQ(growth_law_table({}), "");
  runs_.clear();
  EXPECT_TRUE(findings().empty());
}

// The registries do not know each other: here their names are held together.
TEST(StatedGrowthLaws, name_known_algorithms_parameters_and_sizes) {
  for (const GeneratorInfo& family : generators()) {
    for (const GrowthLaw& law : family.growth_laws) {
      SCOPED_TRACE(family.name + ' ' + law.algorithm);
      const AlgorithmInfo& algorithm = find_algorithm(law.algorithm);
      EXPECT_NO_THROW(Parameters(algorithm.name, algorithm.parameters, law.algorithm_parameters));
      EXPECT_NO_THROW(generate(family.name, law.min_n, 1, law.parameters));
      EXPECT_LE(law.min_n, law.max_n);
      EXPECT_LE(law.max_n, family.max_n);
      EXPECT_LE(law.max_n, algorithm.max_n);
      EXPECT_LE(law.lowest, law.highest);
    }
  }
}

}  // namespace
}  // namespace mwt
