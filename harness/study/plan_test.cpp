#include "harness/study/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "geometry/error.h"
#include "harness/test_support.h"

namespace mwt {
namespace {

Study small_study() {
  Study study;
  study.name = "s";
  study.families = {{"uniform", {}, {}, {}, "s.toml:1"}};
  study.algorithms = {{"well", {}, {}, "s.toml:2"}};
  study.sizes = {10, 20};
  study.seeds = {1, 2};
  return study;
}

Plan plan_of(const Study& study) { return make_plan(study, testing::test_catalogue()); }

TEST(Plan, MultipliesFamiliesSizesSeedsAlgorithmsRepetitions) {
  Study study = small_study();
  study.algorithms.push_back({"small", {}, {}, "s.toml:2"});
  study.repetitions = 3;
  const Plan plan = plan_of(study);
  EXPECT_EQ(plan.instances.size(), 4u);
  EXPECT_EQ(plan.runs.size(), 24u);
  EXPECT_NE(plan.runs[0].algorithm, plan.runs[1].algorithm) << "repetitions interleave";
  std::set<std::string> ids;
  for (const PlannedRun& run : plan.runs) ids.insert(run.run_id);
  EXPECT_EQ(ids.size(), 24u);
}

TEST(Plan, IdsDependOnTheCellAlone) {
  Study study = small_study();
  const std::string id = plan_of(study).runs.back().run_id;
  study.algorithms.insert(study.algorithms.begin(), {"small", {}, {}, ""});
  study.limits.time_s = 1;
  EXPECT_EQ(plan_of(study).runs.back().run_id, id);
}

TEST(Plan, AWildcardStandsForAllThatAreNotNamed) {
  Study study = small_study();
  study.families = {{"*", {}, {}, {}, ""}, {"clustered", {{"clusters", "3"}}, {}, {}, ""}};
  const Plan plan = plan_of(study);
  std::size_t clustered = 0;
  for (const PlannedInstance& instance : plan.instances) {
    if (instance.family->name != "clustered") continue;
    EXPECT_EQ(instance.parameters.text("clusters"), "3");
    ++clustered;
  }
  EXPECT_EQ(clustered, 4u);
  EXPECT_GT(plan.instances.size(), 20u);
}

TEST(Plan, NamedAndUnseededInstancesComeOnce) {
  Study study = small_study();
  study.families = {{"report_example", {}, {}, {}, ""}, {"fan", {}, {}, {}, ""}};
  const Plan plan = plan_of(study);
  ASSERT_EQ(plan.instances.size(), 3u);
  EXPECT_EQ(plan.instances[0].n, 10u);
  EXPECT_EQ(plan.instances[1].seed, 1u);
}

TEST(Plan, SizesAFamilyLacksBecomeTheNearest) {
  static const GeneratorInfo squares = [] {
    GeneratorInfo info;
    info.name = "squares";
    info.smallest_n = 4;
    info.function = [](Index n, std::uint64_t, const Parameters&) {
      const auto side = static_cast<Index>(std::lround(std::sqrt(n)));
      if (side * side != n) throw InputError("no square; nearest " + std::to_string(side * side));
      std::vector<Point> points;
      for (Index i = 0; i < n; ++i) points.push_back({static_cast<double>(i % side), static_cast<double>(i / side)});
      return points;
    };
    return info;
  }();
  Study study = small_study();
  study.families = {{"squares", {}, {3, 10, 50, 1000}, {1}, ""}};
  const Plan plan = make_plan(study, {testing::test_catalogue().algorithms(), {&squares, 1}});
  std::vector<Index> sizes;
  for (const PlannedInstance& instance : plan.instances) sizes.push_back(instance.n);
  EXPECT_EQ(sizes, (std::vector<Index>{4, 9, 49, 1024}));
  EXPECT_EQ(plan.notes.size(), 4u);
}

TEST(Plan, TheSmallerLimitCounts) {
  Study study = small_study();
  study.algorithms = {{"small", {}, {}, ""}, {"small", {}, 3, ""}, {"well", {}, 7, ""}};
  const Plan plan = plan_of(study);
  EXPECT_EQ(plan.runs[0].largest_n, 5u);
  EXPECT_EQ(plan.runs[1].largest_n, 7u) << "the second 'small' is the same cell as the first";
}

TEST(Plan, MistakesNameTheirPlace) {
  const auto complaint = [](const Study& study) -> std::string {
    try {
      plan_of(study);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  Study study = small_study();
  study.algorithms[0].name = "nothing";
  EXPECT_TRUE(complaint(study).starts_with("s.toml:2: unknown algorithm 'nothing'")) << complaint(study);
  study = small_study();
  study.families[0].parameters = {{"k", "1"}};
  EXPECT_TRUE(complaint(study).starts_with("s.toml:1: uniform: unknown parameter 'k'")) << complaint(study);
  study = small_study();
  study.sizes.clear();
  EXPECT_TRUE(complaint(study).starts_with("s.toml:1: no sizes")) << complaint(study);
  study = small_study();
  study.algorithms[0].families = {"nothing"};
  EXPECT_TRUE(complaint(study).starts_with("s.toml:2: unknown generator 'nothing'")) << complaint(study);
}

TEST(Plan, AnAlgorithmMayBeRunOnSomeFamiliesOnly) {
  Study study = small_study();
  study.families = {{"uniform", {}, {}, {}, ""}, {"grid", {}, {}, {}, ""}};
  study.algorithms = {{"small", {}, {}, ""}, {"well", {}, {}, "", {"grid"}}};
  bool small_on_uniform = false;
  for (const Plan plan = plan_of(study); const PlannedRun& run : plan.runs) {
    const std::string& family = plan.instances[run.instance].family->name;
    if (run.algorithm->name == "well") {
      EXPECT_EQ(family, "grid");
    }
    small_on_uniform = small_on_uniform || (run.algorithm->name == "small" && family == "uniform");
  }
  EXPECT_TRUE(small_on_uniform);
}

TEST(Plan, StartsAreSoughtBesideTheStudyFile) {
  Study study = small_study();
  study.folder = "studies";
  study.algorithms = {{"tuned", {{"start", "file.csv"}}, {}, ""}, {"tuned", {{"start", "sweep"}}, {}, ""}};
  const Plan plan = plan_of(study);
  EXPECT_EQ(plan.runs[0].start_file, "studies/file.csv");
  EXPECT_EQ(plan.runs[0].parameters.text("start"), "file.csv") << "records name no folder of this machine";
  EXPECT_FALSE(plan.runs[1].start_file.has_value());
}

}  // namespace
}  // namespace mwt
