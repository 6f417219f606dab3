#include "algorithms/boolean_model/boolean_model.h"

#include <gtest/gtest.h>

#include "algorithms/boolean_model/crossing_model.h"
#include "algorithms/boolean_model/model_search.h"
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
    const CrossingModel model(points);
    const ModelSummary all = search_models(points, model, std::vector<ModelEdge>(model.edges.size()), {});
    EXPECT_FALSE(all.stop_reason);
    EXPECT_TRUE(all.have_the_same_size);
    const Solution expected = solve_and_check("brute_force", points);
    EXPECT_EQ(all.count, expected.count);
    EXPECT_TRUE(overlap(all.weight, *expected.optimum)) << "without the linear program";
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

TEST(BooleanModelSlow, AgreesWithExactOnTwentyPoints) {
  for (const Index n : {13U, 20U}) {
    for_each_family(n, [](Points points) {
      EXPECT_TRUE(overlap(*solve_to_optimality("boolean_model", points).optimum,
                          *solve_to_optimality("exact", points).optimum));
    });
  }
}

TEST(BooleanModel, CountsTheTriangulationsOfAPolygon) {
  const Solution solution = solve_and_check("boolean_model", instance("convex_position", 20, 1), {{"count", "on"}});
  EXPECT_EQ(solution.count, "477638700") << "the 18th Catalan number";
}

TEST(ModelSearch, KeepsToWhatIsKnown) {
  const std::vector<Point> square = {{0, 0}, {3, 0}, {4, 4}, {0, 3}};
  const CrossingModel model(square);  // edges 0 1, 0 2, 0 3, 1 2, 1 3, 2 3
  std::vector<ModelEdge> known(6, ModelEdge::open);
  EXPECT_EQ(search_models(square, model, known, {}).count, "2");
  EXPECT_EQ(search_models(square, model, known, {}).lightest, (std::vector<std::uint32_t>{0, 2, 3, 4, 5}));
  known[4] = ModelEdge::out;
  EXPECT_EQ(search_models(square, model, known, {}).lightest, (std::vector<std::uint32_t>{0, 1, 2, 3, 5}));
  known[1] = ModelEdge::out;
  EXPECT_EQ(search_models(square, model, known, {}).count, "0");
  known[1] = known[4] = ModelEdge::in;
  EXPECT_EQ(search_models(square, model, known, {}).count, "0");
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
