#include "algorithms/boolean_model/boolean_model.h"

#include <gtest/gtest.h>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/boolean_model/model_count.h"
#include "algorithms/common/testing/solver_testing.h"
#include "base/error.h"
#include "generators/registry.h"
#include "geometry/point_set.h"

namespace mwt {
namespace {

std::vector<Point> instance(const std::string& family, Index n, std::uint64_t seed) {
  return make_point_set(generate(family, n, seed), family).points;
}

// Every family at this size, where it has one.
template <class Visit>
void for_each_family(Index n, const Visit& visit) {
  for (const GeneratorInfo& family : generators()) {
    std::vector<Point> points;
    try {
      points = instance(family.name, n, 1);
    } catch (const InputError&) {
      continue;
    }
    SCOPED_TRACE(family.name + " n=" + std::to_string(n));
    visit(points);
  }
}

TEST(BooleanModel, CountsTheModelsOfTheReportsExample) {
  const Solution solution = solve_and_check("boolean_model", instance("report_example", 10, 1), {{"count", "on"}});
  EXPECT_EQ(solution.count, "586");
}

TEST(BooleanModel, ModelsAreExactlyTheTriangulations) {
  for_each_family(8, [](Points points) {
    const auto models = count_models(CrossingModel(points), {});
    ASSERT_TRUE(models);
    EXPECT_TRUE(models->have_the_same_size);
    EXPECT_EQ(std::to_string(models->count), solve_and_check("brute_force", points).count);
  });
}

TEST(BooleanModel, AgreesWithOtherSolversOnEveryFamily) {
  for (const Index n : {6U, 8U, 9U}) {
    for_each_family(n, [](Points points) {
      EXPECT_TRUE(overlap(*solve_to_optimality("boolean_model", points).optimum,
                          *solve_to_optimality("subset_dp", points).optimum));
    });
  }
}

TEST(BooleanModelSlow, AgreesWithOtherSolversOnTwelvePoints) {
  for (const char* family : {"uniform", "integer_uniform", "lattice", "wheel"}) {
    SCOPED_TRACE(family);
    const std::vector<Point> points = instance(family, 12, 1);
    EXPECT_TRUE(
        overlap(*solve_to_optimality("boolean_model", points).optimum, *solve_to_optimality("exact", points).optimum));
  }
}

// Every fourth point on a side of the hull, and a lattice: edges overlap and pass through points.
TEST(BooleanModel, TakesCollinearPoints) {
  const std::vector<Point> points = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 2}, {3, 2}};
  EXPECT_TRUE(overlap(*solve_to_optimality("boolean_model", points).optimum,
                      *solve_to_optimality("brute_force", points).optimum));
}

TEST(BooleanModel, StopsAtTheDeadlineWithBounds) {
  const std::vector<Point> points = instance("uniform", 20, 3);
  const Solution solution = solve_and_check("boolean_model", points, {}, Context::Clock::now());
  EXPECT_TRUE(solution.stopped_early());
  ASSERT_TRUE(solution.optimum);
}

TEST(BooleanModel, RefusesMorePointsThanItTakes) {
  Context context;
  const AlgorithmInfo& info = find_algorithm("boolean_model");
  context.parameters = Parameters(info.name, info.parameters, {});
  EXPECT_THROW((void)info.function(instance("uniform", 25, 1), context), NotApplicable);
}

}  // namespace
}  // namespace mwt
