#include "harness/study/plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/run/testing/algorithms_testing.h"

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
  for (std::size_t i = 0; i < 24; i += 2) {
    EXPECT_NE(plan.runs[i].algorithm, plan.runs[i + 1].algorithm) << "repetitions interleave";
    EXPECT_EQ(plan.runs[i].repetition, plan.runs[i + 1].repetition);
  }
  std::set<std::string> ids;
  for (const PlannedRun& run : plan.runs) ids.insert(run.run_id);
  EXPECT_EQ(ids.size(), 24u);
}

TEST(Plan, IdsDependOnTheCellAlone) {
  Study study = small_study();
  const std::string id = plan_of(study).runs.back().run_id;
  study.algorithms.insert(study.algorithms.begin(), {"small", {}, {}, ""});
  study.limits.time_s = 1;
  const Plan plan = plan_of(study);
  EXPECT_TRUE(std::any_of(plan.runs.begin(), plan.runs.end(), [&](const PlannedRun& run) { return run.run_id == id; }));
}

TEST(Plan, AWildcardStandsForAllThatAreNotNamed) {
  Study study = small_study();
  study.families = {{"*", {}, {}, {}, ""}, {"clustered", {{"clusters", "3"}}, {}, {}, ""}};
  const Plan plan = plan_of(study);
  std::size_t clustered = 0;
  for (const PlannedInstance& instance : plan.instances) {
    if (instance.generator != "clustered") continue;
    EXPECT_TRUE(instance.parameters.starts_with("clusters=3 ")) << instance.parameters;
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
    info.min_n = 4;
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

TEST(Plan, ASizeThatIsLeftOutSaysWhyForThatSize) {
  Study study = small_study();
  study.families = {{"hunted", {{"algorithm", "quadtree"}}, {50, 9}, {}, ""}};
  const Plan plan = plan_of(study);
  ASSERT_EQ(plan.notes.size(), 2u);
  EXPECT_EQ(
      plan.notes[0],
      "left out: hunted algorithm=quadtree n=50: hunted: has no instance of n=50 points; the nearest legal n is 20");
  EXPECT_EQ(plan.notes[1], "hunted algorithm=quadtree has no n=9; taken: n=8");
}

// What a machine has no memory for is refused before anything is made.
TEST(Plan, HugeSizesAndCountsAreRefused) {
  Study study = small_study();
  study.sizes = {2000000000};
  EXPECT_THROW(plan_of(study), InputError);
  study = small_study();
  study.algorithms.push_back({"small", {}, {}, "s.toml:2"});
  study.algorithms.push_back({"tuned", {}, {}, "s.toml:2"});
  EXPECT_NO_THROW(plan_of(study));
  study.repetitions = 1000000;
  EXPECT_THROW(plan_of(study), InputError);
}

std::vector<Point> one_more(Index n, std::uint64_t, const Parameters&) {
  std::vector<Point> points;
  for (Index i = 0; i <= n; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  return points;
}

TEST(Plan, AFamilyThatFailsIsPlannedSoThatItsRunsSaySo) {
  GeneratorInfo family;
  family.name = "one_more";
  family.function = one_more;
  Study study = small_study();
  study.families = {{"one_more", {}, {}, {}, ""}};
  const Plan plan = make_plan(study, {testing::test_catalogue().algorithms(), {&family, 1}});
  EXPECT_EQ(plan.runs.size(), 4u);
  EXPECT_TRUE(plan.notes.empty());
}

TEST(Plan, RunIdsChangeWithTheFilesTheyDependOn) {
  const testing::TestFolder folder;
  Study study = small_study();
  study.families.clear();
  study.folder = folder.path("");
  study.instance_files = {folder.path(""), {"a b.txt"}, "s.toml:3"};
  study.algorithms = {{"tuned", {{"start", "s.csv"}}, {}, ""}};
  testing::write_text(folder.path("a b.txt"), "0 0\n1 0\n0 1\n");
  testing::write_text(folder.path("s.csv"), "0,1,2\n");
  const Plan first = plan_of(study);
  EXPECT_EQ(first.instances[0].label(), "file file=a%20b.txt n=3 seed=1");
  testing::write_text(folder.path("s.csv"), "1,2,0\n");
  const Plan other_start = plan_of(study);
  testing::write_text(folder.path("a b.txt"), "0 0\n1 0\n0 2\n");
  const Plan other_points = plan_of(study);
  EXPECT_NE(first.runs[0].run_id, other_start.runs[0].run_id);
  EXPECT_NE(other_start.runs[0].run_id, other_points.runs[0].run_id);
}

TEST(Plan, TheSmallerLimitCounts) {
  Study study = small_study();
  study.algorithms = {{"small", {}, {}, ""}, {"small", {}, 3, ""}, {"well", {}, 7, ""}};
  const Plan plan = plan_of(study);
  ASSERT_EQ(plan.runs.size(), 8u) << "the second 'small' is the same cell as the first";
  for (const PlannedRun& run : plan.runs) EXPECT_EQ(run.max_n, run.algorithm->name == "small" ? 5u : 7u);
}

TEST(Plan, AlgorithmsComeInAnOrderThatVaries) {
  Study study = small_study();
  study.algorithms.push_back({"small", {}, {}, "s.toml:2"});
  study.repetitions = 20;
  const Plan plan = plan_of(study);
  std::size_t well_first = 0;
  for (std::size_t i = 0; i < plan.runs.size(); i += 2) well_first += plan.runs[i].algorithm->name == "well" ? 1 : 0;
  EXPECT_GT(well_first, 20u);  // of 80, each with probability a half
  EXPECT_LT(well_first, 60u);
}

TEST(Plan, FilesAreInstancesToo) {
  const testing::TestFolder folder;
  testing::write_text(folder.path("a.txt"), "0 0\n1 0\n0 1\n0 1\n");
  testing::write_text(folder.path("b.txt"), "0 0\n1 0\n0 1\n");
  testing::write_text(folder.path("c.txt"), "0 0\nx y\n");
  testing::write_text(folder.path("d.csv"), "0 0\n");
  Study study = small_study();
  study.families.clear();
  study.instance_files = {folder.path(""), {"*.txt", "a*"}, "s.toml:3"};
  const Plan plan = plan_of(study);
  ASSERT_EQ(plan.instances.size(), 2u);
  EXPECT_EQ(plan.instances[0].label(), "file file=a.txt n=4 seed=1");
  EXPECT_EQ(plan.instances[1].make_points().size(), 3u);
  ASSERT_EQ(plan.notes.size(), 1u);
  EXPECT_NE(plan.notes[0].find("c.txt:2"), std::string::npos) << plan.notes[0];
  study.instance_files.patterns = {"*.xy"};
  EXPECT_THROW(plan_of(study), InputError);
  study.instance_files.folder = folder.path("missing");
  EXPECT_THROW(plan_of(study), InputError);
}

TEST(Shard, IsReadFromItsText) {
  EXPECT_EQ(parse_shard("2/4").text(), "2/4");
  EXPECT_EQ(parse_shard("1/1").text(), "");
  for (const char* text : {"", "1", "0/4", "5/4", "1/", "/4", "a/b", "1/4x", "-1/4", "1 /4", "1/0"}) {
    EXPECT_THROW(static_cast<void>(parse_shard(text)), InputError) << text;
  }
}

TEST(Shard, EveryInstanceIsInExactlyOneAndSizesAreSpread) {
  Study study = small_study();
  study.sizes = {10, 20, 30, 40};
  study.seeds = {1, 2, 3, 4};
  study.algorithms.push_back({"small", {}, {}, "s.toml:2"});
  const Plan plan = plan_of(study);
  std::multiset<std::string> ids;
  for (std::size_t number = 1; number <= 4; ++number) {
    const Plan part = part_of(plan, {number, 4});
    std::set<Index> sizes;
    for (const PlannedInstance& instance : part.instances) sizes.insert(instance.n);
    EXPECT_EQ(sizes.size(), 4u);
    EXPECT_EQ(part.instances.size(), 4u);
    for (const PlannedRun& run : part.runs) {
      ids.insert(run.run_id);
      EXPECT_EQ(std::count_if(part.runs.begin(), part.runs.end(),
                              [&](const PlannedRun& other) { return other.instance == run.instance; }),
                2);
    }
  }
  std::multiset<std::string> all;
  for (const PlannedRun& run : plan.runs) all.insert(run.run_id);
  EXPECT_EQ(ids, all);
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
    const std::string& family = plan.instances[run.instance].generator;
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
  for (const Plan plan = plan_of(study); const PlannedRun& run : plan.runs) {
    const bool is_given = run.parameters.text("start") == "file.csv";  // records name no folder of this machine
    EXPECT_EQ(run.start_file, is_given ? std::optional<std::string>("studies/file.csv") : std::nullopt);
  }
}

}  // namespace
}  // namespace mwt
