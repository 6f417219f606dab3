#include "harness/explore/played_steps.h"

#include <gtest/gtest.h>

#include <set>

#include "algorithms/proof_trace.h"
#include "algorithms/registry.h"
#include "algorithms/step_trace.h"
#include "generators/registry.h"
#include "harness/run/execution.h"

namespace mwt {
namespace {

struct Played {
  Execution execution;
  ProofTrace proof;
  StepTrace steps;
};

Played play(const std::string& algorithm, const Instance& instance, const std::map<std::string, std::string>& given) {
  Played played;
  Request request;
  request.algorithm = &find_algorithm(algorithm);
  request.parameters = Parameters(algorithm, request.algorithm->parameters, given);
  request.proof = &played.proof;
  request.steps = &played.steps;
  played.execution = execute_once(request, instance.set.points);
  return played;
}

std::vector<Edge> edges_at_the_end(const PlayedSteps& played) {
  std::set<Edge> edges(played.start.begin(), played.start.end());
  for (const PlayedStep& step : played.steps) {
    using Kind = PlayedStep::Kind;
    if (step.kind == Kind::remove || step.kind == Kind::flip) {
      EXPECT_EQ(edges.erase({step.a, step.b}), 1U);
    }
    if (step.kind == Kind::add) {
      EXPECT_TRUE(edges.insert({step.a, step.b}).second);
    }
    if (step.kind == Kind::flip) {
      EXPECT_TRUE(edges.insert({step.c, step.d}).second);
    }
    if (step.kind == Kind::certain || step.kind == Kind::open) {
      EXPECT_TRUE(edges.contains({step.a, step.b}));
    }
  }
  return {edges.begin(), edges.end()};
}

std::vector<Edge> edges_in_input_of(const Solution& solution, const PointSet& set) {
  return edges_of({set.input_count, to_input_indices(set, solution.triangulation.triangles)});
}

class PlayedStepsTest : public ::testing::TestWithParam<const char*> {
 protected:
  // With a repeated point, so that positions in the input are others than those of the algorithm.
  static Instance instance() {
    std::vector<Point> points = generate(GetParam(), 60, 3);
    points.insert(points.begin() + 1, points.front());
    return make_instance(points, "test");
  }
};

TEST_P(PlayedStepsTest, OfGreedyAndInsertionEndInTheTriangulation) {
  const Instance points = instance();
  for (const std::string algorithm : {"greedy", "greedy_naive", "hull_insertion"}) {
    const Played played = play(algorithm, points, {});
    EXPECT_EQ(edges_at_the_end(played_trace(played.steps, points.set)),
              edges_in_input_of(played.execution.solution, points.set))
        << algorithm;
  }
}

TEST_P(PlayedStepsTest, OfBothGreediesAreTheSame) {
  const Instance points = instance();
  EXPECT_EQ(play("greedy", points, {}).steps.kept, play("greedy_naive", points, {}).steps.kept);
}

TEST_P(PlayedStepsTest, OfFlipsEndInTheTriangulation) {
  const Instance points = instance();
  const Played flips = play("flip", points, {{"start", "sweep"}, {"trace", "on"}});
  EXPECT_FALSE(flips.execution.solution.flips.empty());
  EXPECT_EQ(edges_at_the_end(played_flips(flips.execution.solution, points.set)),
            edges_in_input_of(flips.execution.solution, points.set));
}

TEST_P(PlayedStepsTest, OfProofsEndInTheTriangulation) {
  const Instance points = instance();
  const Played exact = play("exact", points, {});
  ASSERT_TRUE(exact.proof.is_complete);
  const PlayedSteps played = played_proof(exact.proof, exact.execution.solution, points.set);
  EXPECT_EQ(edges_at_the_end(played), edges_in_input_of(exact.execution.solution, points.set));
  EXPECT_EQ(played.stages.front().name, "diamond test");
  EXPECT_EQ(played.stages.back().name, "optimum");
}

INSTANTIATE_TEST_SUITE_P(Families, PlayedStepsTest, ::testing::Values("uniform", "lattice", "circle"));

}  // namespace
}  // namespace mwt
