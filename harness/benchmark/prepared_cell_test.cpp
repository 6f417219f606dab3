#include "harness/benchmark/prepared_cell.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "harness/run/testing/algorithms_testing.h"

namespace mwt {
namespace {

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const BenchmarkCell& cell : benchmark_cells(testing::test_catalogue(), 1'000'000)) result.push_back(cell.name());
  return result;
}

bool has(const std::vector<std::string>& all, const std::string& name) {
  return std::find(all.begin(), all.end(), name) != all.end();
}

TEST(BenchmarkCells, GoByAlgorithmFamilyAndPowersOfTen) {
  const std::vector<std::string> all = names();
  EXPECT_TRUE(has(all, "well/uniform/10"));
  EXPECT_TRUE(has(all, "well/uniform/100000"));
  EXPECT_FALSE(has(all, "well/uniform/1000000")) << "beyond the algorithm's largest n";
  EXPECT_FALSE(has(all, "small/uniform/10"));
  EXPECT_TRUE(has(all, "well/report_example/10"));
  EXPECT_FALSE(has(all, "well/report_example/100"));
  EXPECT_TRUE(has(all, "well/clustered:clusters=50,sigma=.01/1000"));
}

PreparedCell prepared(const std::string& algorithm, const std::string& family, Index n) {
  const Catalogue catalogue = testing::test_catalogue();
  return prepare(catalogue, {&catalogue.algorithm(algorithm), {}, &catalogue.generator(family), {}, n});
}

TEST(TimeOverDelaunay, IsTheRatioOfMedians) {
  const PreparedCell cell = prepared("well", "uniform", 1000);
  ASSERT_EQ(cell.reason_to_skip, "");
  TimeOverDelaunay once, thrice;
  once.add(1e6);
  for (const double time : {1e9, 2e9, 1e3}) thrice.add(time);
  EXPECT_GT(once.ratio(cell.instance.set.points), 1e6) << "a Delaunay triangulation takes less than a second";
  EXPECT_GT(thrice.ratio(cell.instance.set.points), 1e9);
}

TEST(PreparedCell, SkipsWhatCannotBeTimed) {
  EXPECT_EQ(prepared("declines", "uniform", 10).reason_to_skip, "takes nothing");
  EXPECT_TRUE(prepared("invalid", "uniform", 10).reason_to_skip.starts_with("invalid output"));
  EXPECT_NE(prepared("well", "report_example", 11).reason_to_skip, "");
  EXPECT_EQ(prepared("throws", "uniform", 10).reason_to_skip, "lost\nits way");
}

TEST(PreparedCell, AnAlgorithmThatCertifiesTooMuchIsSkippedAndRatesNobody) {
  EXPECT_TRUE(prepared("claims", "grid", 16).reason_to_skip.starts_with("CONTRADICTION: claims certified"));
  const PreparedCell cell = prepared("well", "grid", 16);
  EXPECT_EQ(cell.reason_to_skip, "");
  ASSERT_TRUE(cell.run.alpha_upper) << "by the weak bound";
  EXPECT_LT(*cell.run.alpha_upper, 2.1);
}

TEST(PreparedCell, IsRatedWhereAnOptimumIsCheap) {
  const PreparedCell cell = prepared("well", "fan", 10);
  ASSERT_TRUE(cell.run.alpha_upper);
  EXPECT_EQ(cell.run.alpha_lower, 1);
}

}  // namespace
}  // namespace mwt
