// Made-up records must flip every verdict.
#include "harness/claims/claims.h"

#include <gtest/gtest.h>

#include <array>

#include "harness/claims/testing/claim_records.h"
#include "harness/io/testing/folder_testing.h"
#include "harness/io/text/csv.h"
#include "harness/io/text/text.h"

namespace mwt {
namespace {

using testing::MadeUpRecords;
using testing::verdict;
using testing::wobble;

constexpr std::array<Index, 5> kSizes = {50, 100, 1000, 10'000, 100'000};

TEST(Claims, AreFifteenAndSayEverything) {
  const std::vector<Claim>& claims = claims_of_the_source_report();
  ASSERT_EQ(claims.size(), 15U);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    EXPECT_EQ(claims[i].id, "C" + std::to_string(i + 1));
    EXPECT_FALSE(claims[i].statement.empty() || claims[i].section.empty() || claims[i].data.empty());
    EXPECT_FALSE(claims[i].rule.empty());
  }
}

TEST(Claims, WithoutRowsNothingIsDecided) {
  for (const JudgedClaim& judged : judge_claims({})) {
    const bool is_theorem = judged.claim->id == "C14";
    EXPECT_EQ(judged.finding.verdict, is_theorem ? ClaimVerdict::by_citation : ClaimVerdict::undecided)
        << judged.claim->id;
    if (is_theorem) continue;
    EXPECT_TRUE(judged.finding.measured.starts_with("undecided: ")) << judged.claim->id << judged.finding.measured;
  }
}

std::string measured(const std::string& id, const MadeUpRecords& made_up) {
  for (const JudgedClaim& judged : judge_claims(made_up.records())) {
    if (judged.claim->id == id) return judged.finding.measured;
  }
  return "";
}

void expect_missing(const std::string& id, const MadeUpRecords& made_up, const std::string& part) {
  const std::string text = measured(id, made_up);
  const std::size_t place = text.find("undecided: ");
  ASSERT_NE(place, std::string::npos) << id << ": " << text;
  EXPECT_NE(text.find(part, place), std::string::npos) << id << ": " << text;
}

MadeUpRecords example_run(const std::string& algorithm, double weight, std::uint64_t triangles) {
  MadeUpRecords made_up;
  RunRecord& run = made_up.add(algorithm, "report_example", 10);
  run.params = algorithm == "hull_insertion" ? "order=index" : "";
  run.weight_lower = run.weight_upper = weight;
  run.triangles = triangles;
  return made_up;
}

TEST(Claims, C1FollowsTheWeightAndTheTriangles) {
  EXPECT_EQ(verdict("C1", example_run("greedy_naive", 70.9585925243, 12)), ClaimVerdict::reproduced);
  EXPECT_EQ(verdict("C1", example_run("greedy_naive", 70.9587, 12)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C1", example_run("greedy_naive", 70.9585925243, 11)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C1", example_run("delaunay", 70.9585925243, 12)), ClaimVerdict::undecided);
}

TEST(Claims, C2FollowsTheWeightAndTheTriangles) {
  EXPECT_EQ(verdict("C2", example_run("hull_insertion", 86.54474790067, 12)), ClaimVerdict::reproduced);
  EXPECT_EQ(verdict("C2", example_run("hull_insertion", 86.5447479010, 12)), ClaimVerdict::refuted);

  MadeUpRecords other;
  RunRecord& run = other.add("hull_insertion", "report_example", 10);
  run.params = "order=x";
  EXPECT_EQ(verdict("C2", other), ClaimVerdict::undecided);
}

TEST(Claims, C3CountsTriangles) {
  MadeUpRecords made_up;
  RunRecord& run = made_up.add("sweep", "uniform", 100);
  run.triangles = 2 * 100 - 10 - 2;
  EXPECT_EQ(verdict("C3", made_up), ClaimVerdict::undecided) << "the instance is unknown";
  made_up.add_instance("instance0", 100, 10);
  EXPECT_EQ(verdict("C3", made_up), ClaimVerdict::reproduced);
  made_up.add_instance("instance1", 100, 11);
  made_up.add("sweep", "uniform", 100).triangles = 2 * 100 - 10 - 2;
  EXPECT_EQ(verdict("C3", made_up), ClaimVerdict::refuted);
}

MadeUpRecords greedy_runs(double alpha, int count, double others = 1.0, int other_count = 0) {
  MadeUpRecords made_up;
  for (int i = 0; i < count; ++i) made_up.add_rated("greedy", "uniform", 100, alpha);
  for (int i = 0; i < other_count; ++i) made_up.add_rated("greedy", "clustered", 100, others);
  return made_up;
}

TEST(Claims, C4FollowsTheShareInsideTheBand) {
  EXPECT_EQ(verdict("C4", greedy_runs(1.001, 40)), ClaimVerdict::refuted_better);
  EXPECT_EQ(verdict("C4", greedy_runs(1.3, 40)), ClaimVerdict::reproduced);
  EXPECT_EQ(verdict("C4", greedy_runs(1.8, 40)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C4", greedy_runs(1.001, 29)), ClaimVerdict::undecided) << "too few";
  EXPECT_EQ(verdict("C4", greedy_runs(1.3, 20, 1.001, 20)), ClaimVerdict::undecided) << "one half";
  expect_missing("C4", greedy_runs(1.001, 29), "29 instances, 30 are needed");
  expect_missing("C4", greedy_runs(1.3, 20, 1.001, 20), "holds one half");
}

TEST(Claims, C4CountsAnInstanceOnce) {
  MadeUpRecords made_up = greedy_runs(1.001, 40);
  StudyRecords records = made_up.records();
  for (RunRecord run : made_up.records().runs) {
    run.algorithm = "greedy_naive";
    records.runs.push_back(run);
  }
  EXPECT_EQ(testing::claim("C4").judge(records).rows.size(), 40U);
}

// One algorithm whose alpha is factor n^exponent on a family.
MadeUpRecords growing(const std::string& algorithm, const std::string& family, double factor, double exponent) {
  MadeUpRecords made_up;
  for (const Index n : kSizes) {
    for (int seed = 0; seed < 3; ++seed) {
      RunRecord& run = made_up.add_rated(algorithm, family, n, factor * std::pow(n, exponent) * wobble(seed));
      run.params = "order=index";
    }
  }
  return made_up;
}

TEST(Claims, C5FollowsTheGrowthOfGreedy) {
  EXPECT_EQ(verdict("C5", growing("greedy", "bad", 0.6, 0.5)), ClaimVerdict::holds);
  EXPECT_EQ(verdict("C5", growing("greedy", "bad", 0.1, 1.3)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C5", growing("greedy", "bad", 60, 0.5)), ClaimVerdict::undecided) << "above n where n is small";
  expect_missing("C5", growing("greedy", "bad", 60, 0.5), "some alpha is above n");
  EXPECT_EQ(verdict("C5", growing("sweep", "bad", 0.1, 1.3)), ClaimVerdict::undecided);
}

TEST(Claims, PointsFromFilesAreNoSeries) {
  EXPECT_EQ(verdict("C5", growing("greedy", "file", 0.1, 1.3)), ClaimVerdict::undecided);
  EXPECT_EQ(verdict("C6", growing("hull_insertion", "file", 0.1, 1.0)), ClaimVerdict::undecided);
}

TEST(Claims, C6FollowsTheGrowthOfInsertionBesideLogN) {
  EXPECT_EQ(verdict("C6", growing("hull_insertion", "trap", 0.1, 1.0)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C6", growing("hull_insertion", "uniform", 1.0, 0.25)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C6", growing("hull_insertion", "uniform", 1.2, 0.0)), ClaimVerdict::holds);
  MadeUpRecords logarithmic;
  for (const Index n : kSizes) {
    for (int seed = 0; seed < 3; ++seed) {
      logarithmic.add_rated("hull_insertion", "uniform", n, std::log(n) * wobble(seed)).params = "order=index";
    }
  }
  EXPECT_EQ(verdict("C6", logarithmic), ClaimVerdict::undecided) << "log n itself: on the edge";
}

MadeUpRecords hull_run(double hull_weight, double optimum) {
  MadeUpRecords made_up;
  RunRecord& run = made_up.add_rated("hull_insertion", "any", 13, 1.1);
  run.optimum_lower = run.optimum_upper = optimum;
  run.counters = {{"hull_size", 12}, {"hull_weight", hull_weight}, {"interior_points", 1}};
  return made_up;
}

TEST(Claims, C7FollowsTheCertifiedEnds) {
  EXPECT_EQ(verdict("C7", hull_run(848.8, 846.8)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C7", hull_run(846.8, 846.8)), ClaimVerdict::holds);
  MadeUpRecords unproved = hull_run(848.8, 846.8);
  StudyRecords records = unproved.records();
  records.runs.front().optimality = "bounded";
  EXPECT_EQ(testing::claim("C7").judge(records).verdict, ClaimVerdict::undecided);
}

// Insertion whose every step adds n^exponent on a family.
void add_insertions(MadeUpRecords& made_up, const std::string& family, double exponent) {
  for (const Index n : kSizes) {
    for (int seed = 0; seed < 3; ++seed) {
      RunRecord& run = made_up.add("hull_insertion", family, n);
      run.weight_upper = 4 + 100 * std::pow(n, exponent) * wobble(seed);
      run.counters = {{"hull_weight", 4}, {"interior_points", 100}};
    }
  }
}

TEST(Claims, C8DependsOnTheUnitOfLength) {
  MadeUpRecords made_up;
  add_insertions(made_up, "uniform", -0.2);
  EXPECT_EQ(verdict("C8", made_up), ClaimVerdict::holds);
  add_insertions(made_up, "grid", 0.3);
  EXPECT_EQ(verdict("C8", made_up), ClaimVerdict::ill_posed);
  MadeUpRecords growing_in_unit_square;
  add_insertions(growing_in_unit_square, "uniform", 0.3);
  EXPECT_EQ(verdict("C8", growing_in_unit_square), ClaimVerdict::refuted);
  MadeUpRecords without_unit_square;
  add_insertions(without_unit_square, "grid", 0.3);
  EXPECT_EQ(verdict("C8", without_unit_square), ClaimVerdict::undecided);
}

MadeUpRecords local_search(double start, double middle, double end, int flips) {
  MadeUpRecords made_up;
  for (const auto& [max_flips, total] : {std::pair{"0", start}, std::pair{"1", middle}, std::pair{"-1", end}}) {
    RunRecord& run = made_up.add("flip_naive", "local_search_figure", 10);
    run.params = std::string("improvement=first max_flips=") + max_flips + " start=local_search_figure_start.csv";
    run.perimeter_sum = total;
    run.counters = {{"flips", flips}};
  }
  return made_up;
}

TEST(Claims, C9FollowsTheThreeSumsAndTheFlips) {
  EXPECT_EQ(verdict("C9", local_search(11.07512, 10.93468, 10.79291, 2)), ClaimVerdict::reproduced);
  EXPECT_EQ(verdict("C9", local_search(11.0751, 10.9346, 10.7929, 2)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C9", local_search(11.0751, 10.9347, 10.7929, 3)), ClaimVerdict::refuted);
}

MadeUpRecords searches(int near, int far) {
  MadeUpRecords made_up;
  for (int i = 0; i < near + far; ++i) {
    made_up.add_rated("flip_naive", "uniform", 100, i < near ? 1.05 : 1.3).params =
        "improvement=first max_flips=-1 start=sweep";
  }
  return made_up;
}

TEST(Claims, C10FollowsTheExactInterval) {
  EXPECT_EQ(verdict("C10", searches(6, 0)), ClaimVerdict::holds);
  EXPECT_EQ(verdict("C10", searches(5, 0)), ClaimVerdict::undecided) << "0.5^5 > 2.5%";
  expect_missing("C10", searches(5, 0), "start=sweep n=100 (5 of 5)");
  EXPECT_EQ(verdict("C10", searches(6, 6)), ClaimVerdict::undecided);
  EXPECT_EQ(verdict("C10", searches(1, 19)), ClaimVerdict::refuted);
}

void add_counts(MadeUpRecords& made_up, const std::string& family, double factor, double noise = 0.01) {
  for (const Index n : {12U, 13U, 14U, 15U}) {
    for (const double deviation : {1 - noise, 1.0, 1 + noise}) {
      made_up.add("subset_dp", family, n).triangulation_count =
          std::to_string(static_cast<std::uint64_t>(std::pow(factor, n) * deviation));
    }
  }
}

TEST(Claims, C11ComparesWithTheCatalanNumbers) {
  MadeUpRecords made_up;
  add_counts(made_up, "uniform", 4.5);
  EXPECT_EQ(verdict("C11", made_up), ClaimVerdict::undecided) << "nothing in convex position";
  made_up.add("subset_dp", "circle", 6).triangulation_count = "14";
  made_up.add("brute_force", "integer_circle", 12).triangulation_count = "16796";
  EXPECT_EQ(verdict("C11", made_up), ClaimVerdict::reproduced);
  made_up.add("subset_dp", "integer_circle", 13).triangulation_count = "58787";
  EXPECT_EQ(verdict("C11", made_up), ClaimVerdict::refuted);
}

void add_times(MadeUpRecords& made_up, const std::string& algorithm, const std::string& family, double exponent) {
  for (const Index n : {1000U, 3000U, 10'000U, 100'000U}) {
    for (int seed = 0; seed < 3; ++seed) {
      RunRecord& run = made_up.add(algorithm, family, n);
      run.params = "start=delaunay";
      run.cpu_time_s = 1e-4 * std::pow(n / 1000.0, exponent) * wobble(seed);
    }
  }
}

MadeUpRecords all_times(double greedy, double quadtree, double brute_force) {
  MadeUpRecords made_up;
  add_times(made_up, "greedy_naive", "uniform", greedy);
  add_times(made_up, "hull_insertion", "uniform", 1.2);
  add_times(made_up, "hull_insertion", "circle", 2.9);
  add_times(made_up, "flip_naive", "uniform", 1.3);
  add_times(made_up, "quadtree", "uniform", quadtree);
  add_times(made_up, "delaunay", "uniform", 1.1);
  for (const Index n : {9U, 10U, 11U, 12U}) {
    made_up.add("brute_force", "uniform", n).cpu_time_s = 1e-4 * std::pow(brute_force, n - 9.0);
  }
  return made_up;
}

TEST(Claims, C12FollowsTheFittedExponents) {
  EXPECT_EQ(verdict("C12", all_times(2.5, 1.1, 5)), ClaimVerdict::holds);
  EXPECT_EQ(verdict("C12", all_times(4.5, 1.1, 5)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C12", all_times(2.5, 2.0, 5)), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C12", all_times(2.5, 1.1, 1.1)), ClaimVerdict::refuted);
  MadeUpRecords incomplete;
  add_times(incomplete, "quadtree", "uniform", 1.1);
  EXPECT_EQ(verdict("C12", incomplete), ClaimVerdict::undecided);
}

TEST(Claims, C12SaysWhatIsMissing) {
  MadeUpRecords incomplete;
  add_times(incomplete, "quadtree", "uniform", 1.1);
  incomplete.add("hull_insertion", "circle", 50).cpu_time_s = 1e-4;
  incomplete.add("hull_insertion", "circle", 1000).cpu_time_s = 1e-1;
  expect_missing(
      "C12", incomplete,
      "hull_insertion on circle has CPU times of finished runs at 2 sizes from n = 20 (n = 50; 1,000), 3 are needed");
}

// On a machine a hundred times faster, where many runs take less than a microsecond, or slower.
TEST(Claims, C12DoesNotDependOnTheSpeedOfTheMachine) {
  for (const double speed : {0.001, 0.01, 1.0, 1000.0}) {
    StudyRecords records = all_times(2.5, 1.1, 5).records();
    for (RunRecord& run : records.runs) *run.cpu_time_s *= speed;
    EXPECT_EQ(testing::claim("C12").judge(records).verdict, ClaimVerdict::holds) << speed;
  }
}

TEST(Claims, C13FollowsAlphaAndItsGrowth) {
  MadeUpRecords good = growing("quadtree", "uniform", 1.03, 0);
  for (int i = 0; i < 20; ++i) good.add_rated("quadtree", "clustered", 100, 1.05);
  EXPECT_EQ(verdict("C13", good), ClaimVerdict::holds);
  for (int i = 0; i < 5; ++i) good.add_rated("quadtree", "normal", 100, 2);
  EXPECT_EQ(verdict("C13", good), ClaimVerdict::refuted);
  EXPECT_EQ(verdict("C13", growing("quadtree", "uniform", 1.03, 0)), ClaimVerdict::undecided) << "too few";
}

TEST(Claims, C15FollowsTheGrowthPerPoint) {
  MadeUpRecords made_up;
  add_counts(made_up, "circle", 3.6);
  EXPECT_EQ(verdict("C15", made_up), ClaimVerdict::holds);
  add_counts(made_up, "uniform", 4.02, 0.4);
  EXPECT_EQ(verdict("C15", made_up), ClaimVerdict::undecided);
  MadeUpRecords faster;
  add_counts(faster, "uniform", 4.5);
  EXPECT_EQ(verdict("C15", faster), ClaimVerdict::refuted);
}

TEST(Claims, FailedAndRepeatedRunsAreNoEvidence) {
  StudyRecords records = example_run("greedy_naive", 70.9585925243, 12).records();
  records.runs.front().status = RunStatus::timeout;
  EXPECT_EQ(testing::claim("C1").judge(records).verdict, ClaimVerdict::undecided);
  records = searches(6, 0).records();
  records.runs.front().stopped_early = true;
  EXPECT_EQ(testing::claim("C10").judge(records).verdict, ClaimVerdict::undecided) << "cut short by the deadline";
  records = searches(3, 0).records();
  for (int copy = 0; copy < 3; ++copy) {
    records.runs.push_back(records.runs.front());
    records.runs.back().repetition = 1;
  }
  EXPECT_EQ(testing::claim("C10").judge(records).verdict, ClaimVerdict::undecided);
}

TEST(Claims, AreWrittenWithTheirRowsAndDetails) {
  const testing::TestFolder folder;
  const MadeUpRecords made_up = searches(6, 0);
  const std::vector<JudgedClaim> judged = judge_claims(made_up.records());
  write_claims(folder.path(""), judged);
  const auto claims = parse_csv(testing::read_text(folder.path("claims.csv")));
  ASSERT_EQ(claims.size(), 16U);
  EXPECT_EQ(joined({claims[0].begin(), claims[0].begin() + 6}),
            "claim, statement, section, measured, evidence, verdict");
  EXPECT_EQ(claims[10][0], "C10");
  EXPECT_EQ(claims[10][5], "holds");
  EXPECT_TRUE(claims[10][4].starts_with("6 runs: ")) << claims[10][4];
  const auto rows = parse_csv(testing::read_text(folder.path("claim_rows.csv")));
  EXPECT_EQ(rows.size(), 7U);
  EXPECT_EQ(rows[1], (CsvRow{"C10", "run0"}));
  EXPECT_EQ(parse_csv(testing::read_text(folder.path("claim_details/C10.csv"))).size(), 5U);
  EXPECT_FALSE(std::filesystem::exists(folder.path("claim_details/C4.csv")));
  EXPECT_NE(claims_text(judged).find("C10  HOLDS"), std::string::npos);
  EXPECT_NE(claims_text(judged).find("about C1, C2, C3"), std::string::npos);
}

TEST(Claims, ANewReportLeavesNothingOfAnOldOne) {
  const testing::TestFolder folder;
  const MadeUpRecords made_up = searches(6, 0);
  write_claims(folder.path(""), judge_claims(made_up.records()));
  write_claims(folder.path(""), judge_claims({}));
  EXPECT_FALSE(std::filesystem::exists(folder.path("claim_details/C10.csv")));
  remove_claims(folder.path(""));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path("")));
  remove_claims(folder.path(""));
}

}  // namespace
}  // namespace mwt
