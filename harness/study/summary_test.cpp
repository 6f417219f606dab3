#include "harness/study/summary.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

RunRecord row(const std::string& algorithm, RunStatus status, double alpha, double time) {
  RunRecord record;
  record.algorithm = algorithm;
  record.generator = "uniform";
  record.n = 10;
  record.status = status;
  if (status == RunStatus::ok) {
    record.alpha_upper = alpha;
    record.optimality = "proved";
    record.wall_time_s = time;
    record.optimal = alpha == 1 ? "yes" : "no";
  }
  return record;
}

TEST(Summary, MedianOfEvenAndOdd) {
  EXPECT_EQ(median({3, 1, 2}), 2);
  EXPECT_EQ(median({4, 1, 2, 3}), 2.5);
}

TEST(Summary, CountsAveragesAndShares) {
  const std::string text =
      summary_tables({row("b", RunStatus::ok, 1, 1e-3), row("b", RunStatus::ok, 1.5, 3e-3),
                      row("b", RunStatus::timeout, 0, 0), row("a", RunStatus::not_applicable, 0, 0)});
  EXPECT_EQ(text,
            "alpha by algorithm (upper ends of certified intervals; rated: runs with a proved optimum)\n"
            "algorithm  runs  failures  not applicable  rated  alpha mean  alpha max  optimal\n"
            "b             3         1               0      2    1.250000   1.500000      50%\n"
            "a             0         0               1      0           -          -        -\n"
            "\n"
            "by family, algorithm and n\n"
            "family   algorithm   n  runs  failures  median time  alpha mean  alpha max  optimal\n"
            "uniform  b          10     3         1      2.00 ms    1.250000   1.500000      50%\n");
}

TEST(Summary, ParametersAreNamedOnlyWhereTheyDiffer) {
  RunRecord one = row("a", RunStatus::ok, 1, 1);
  one.params = "k=1";
  RunRecord two = one;
  two.params = "k=2";
  EXPECT_EQ(summary_tables({one}).find("k=1"), std::string::npos);
  EXPECT_NE(summary_tables({one, two}).find("a k=2"), std::string::npos);
}

}  // namespace
}  // namespace mwt
