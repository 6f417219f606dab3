#include "algorithms/triangle_lp/linear_program.h"

#include <gtest/gtest.h>

#include <thread>

namespace mwt {
namespace {

using Entry = LinearProgram::Entry;
using Method = LinearProgram::Method;

// Minimise 2 x + 3 y subject to x + y = 4 and x - y = `difference`.
double solve_small_program(double difference) {
  LinearProgram program;
  program.add_row({}, 4);
  program.add_row({}, difference);
  program.add_column(std::vector<Entry>{{0, 1}, {1, 1}});
  program.add_column(std::vector<Entry>{{0, 1}, {1, -1}});
  program.set_costs(std::vector<double>{2, 3});
  EXPECT_TRUE(program.solve(Method::dual, {}));
  EXPECT_NEAR(program.dual(0) * 4 + program.dual(1) * difference, 2 * program.value(0) + 3 * program.value(1), 1e-9);
  return program.value(0);
}

TEST(LinearProgram, FindsPrimalAndDualValues) { EXPECT_NEAR(solve_small_program(2), 3, 1e-9); }

TEST(LinearProgram, FollowsNewColumnsRowsAndRightSides) {
  LinearProgram program;
  program.add_row({}, 1);
  program.add_column(std::vector<Entry>{{0, 1}});
  program.set_costs(std::vector<double>{5});
  ASSERT_TRUE(program.solve(Method::dual, {}));
  EXPECT_NEAR(program.dual(0), 5, 1e-9);

  program.add_column(std::vector<Entry>{{0, 1}});
  program.set_costs(std::vector<double>{5, 2});
  ASSERT_TRUE(program.solve(Method::primal, {}));
  EXPECT_NEAR(program.value(1), 1, 1e-9);

  const int row = program.add_row(std::vector<Entry>{{1, 1}}, 0.25);
  ASSERT_TRUE(program.solve(Method::dual, {}));
  EXPECT_NEAR(program.value(0), 0.75, 1e-9);

  program.set_right_side(row, {});
  ASSERT_TRUE(program.solve(Method::dual, {}));
  EXPECT_NEAR(program.value(1), 1, 1e-9);
}

TEST(LinearProgram, SaysNoWhenThereIsNoSolution) {
  LinearProgram program;
  program.add_row({}, -1);
  program.add_column(std::vector<Entry>{{0, 1}});
  program.set_costs(std::vector<double>{1});
  EXPECT_FALSE(program.solve(Method::dual, {}));
  EXPECT_FALSE(program.failed());
}

TEST(LinearProgram, SurvivesErrorsInsideGlpk) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    LinearProgram program;
    program.add_row({}, 1);
    program.add_column(std::vector<Entry>{{7, 1}});  // there is no row 7: GLPK would end the process
    EXPECT_TRUE(program.failed());
    EXPECT_FALSE(program.solve(Method::dual, {}));
    EXPECT_EQ(program.value(0), 0);
    program.set_costs(std::vector<double>{1});
  }
  EXPECT_NEAR(solve_small_program(1), 2.5, 1e-9);
}

TEST(LinearProgram, HasAnEnvironmentPerThread) {
  std::vector<std::thread> threads;
  std::vector<double> found(4, 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    threads.emplace_back([&found, i] {
      for (int k = 0; k < 20; ++k) found[i] = solve_small_program(static_cast<double>(i));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], 2 + 0.5 * static_cast<double>(i), 1e-9);
}

}  // namespace
}  // namespace mwt
