// Runs mwt_benchmark as its users do.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/cli/testing/commands_testing.h"
#include "harness/io/text/csv.h"

namespace mwt {
namespace {

class BenchmarkProgram : public testing::CommandTest {
 protected:
  [[nodiscard]] int benchmark(const std::string& arguments) const {
    return shell(MWT_BENCHMARK_EXECUTABLE " --benchmark_min_time=0.001 " + arguments + " >.out 2>.err </dev/null");
  }
};

// polygon_dp takes convex position only: its first cell is skipped, and comes before all others.
TEST_F(BenchmarkProgram, CsvHoldsAlgorithmsOfDifferentStages) {
  const std::string filter = "--benchmark_filter='^(delaunay|patch|polygon_dp|exact)/(uniform|circle)/10$'";
  for (const std::string& flags : {std::string(), std::string("--benchmark_repetitions=2")}) {
    ASSERT_EQ(benchmark(filter + " --benchmark_format=csv --benchmark_out=o.csv --benchmark_out_format=csv " + flags),
              0)
        << read(".err");
    const std::vector<CsvRow> rows = parse_csv(read(".out"));
    ASSERT_GE(rows.size(), 9U);
    for (const CsvRow& row : rows) EXPECT_EQ(row.size(), rows.front().size());
    EXPECT_EQ(CsvRow(rows.front().end() - 4, rows.front().end()),
              (CsvRow{"alpha_lower", "alpha_upper", "over_delaunay", "stopped_early"}));
    EXPECT_EQ(read("o.csv"), read(".out"));
    for (const char* name : {"delaunay/uniform/10", "patch/circle/10", "polygon_dp/uniform/10", "exact/circle/10"}) {
      EXPECT_TRUE(std::ranges::any_of(rows, [&](const CsvRow& row) { return row.front().starts_with(name); })) << name;
    }
    EXPECT_NE(read(".out").find("phase_patch_s="), std::string::npos);
  }
}

TEST_F(BenchmarkProgram, CsvMayBeginWithASkippedBenchmark) {
  ASSERT_EQ(benchmark("--benchmark_filter='^(polygon_dp/uniform|exact/uniform)/10$' --benchmark_format=csv"), 0);
  const std::vector<CsvRow> rows = parse_csv(read(".out"));
  ASSERT_EQ(rows.size(), 3U) << read(".out");
  EXPECT_EQ(rows[1].front(), "polygon_dp/uniform/10");
  EXPECT_EQ(rows[2].back().empty(), false) << "exact is timed over the Delaunay time";
}

TEST_F(BenchmarkProgram, NumbersOfFlagsAreHeldToTheirRange) {
  for (const char* flag :
       {"--max_n=0", "--max_n=-1", "--max_n=", "--max_n=1e3", "--threads=nan", "--threads=99999999999"}) {
    EXPECT_EQ(benchmark(flag), 2) << flag;
    EXPECT_TRUE(read(".err").starts_with("mwt_benchmark: " + std::string(flag) + " is ")) << read(".err");
  }
}

}  // namespace
}  // namespace mwt
