#include "harness/explore/played_proof.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "algorithms/registry.h"
#include "generators/registry.h"
#include "geometry/predicates.h"
#include "harness/explore/edge_witnesses.h"
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
    if (step.kind == Kind::remove || step.kind == Kind::flip || step.kind == Kind::refute) {
      EXPECT_EQ(edges.erase({step.a, step.b}), 1U);
    }
    if (step.kind == Kind::add || step.kind == Kind::pass) {
      EXPECT_TRUE(edges.insert({step.a, step.b}).second);
    }
    if (step.kind == Kind::flip) {
      EXPECT_TRUE(edges.insert({step.c, step.d}).second);
    }
    if (step.kind == Kind::certain || step.kind == Kind::open || step.kind == Kind::cut) {
      EXPECT_TRUE(edges.contains({step.a, step.b}));
    }
  }
  return {edges.begin(), edges.end()};
}

std::size_t count(const PlayedSteps& played, PlayedStep::Kind kind) {
  return static_cast<std::size_t>(std::ranges::count(played.steps, kind, &PlayedStep::kind));
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

TEST_P(PlayedStepsTest, OfAllAlgorithmsEndInTheirTriangulations) {
  const Instance points = instance();
  for (const std::string algorithm : {"greedy", "greedy_naive", "hull_insertion", "patch", "quadtree", "annealing"}) {
    const Played played = play(algorithm, points, {});
    const PlayedSteps steps = played_trace(played.steps, played.execution.solution, points.set);
    EXPECT_EQ(edges_at_the_end(steps), edges_in_input(played.execution.solution, points.set)) << algorithm;
    for (const PlayedStage& stage : steps.stages) EXPECT_NE(stage.name, "result") << algorithm;
  }
}

TEST_P(PlayedStepsTest, ChangeNoTriangulation) {
  const Instance points = instance();
  for (const std::string algorithm : {"greedy", "hull_insertion", "patch", "quadtree", "annealing", "exact"}) {
    Request request;
    request.algorithm = &find_algorithm(algorithm);
    request.parameters = Parameters(algorithm, request.algorithm->parameters, {});
    const Execution plain = execute_once(request, points.set.points);
    EXPECT_EQ(canonical_triangles(plain.solution.triangulation),
              canonical_triangles(play(algorithm, points, {}).execution.solution.triangulation))
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
            edges_in_input(flips.execution.solution, points.set));
}

TEST_P(PlayedStepsTest, OfProofsEndInTheTriangulation) {
  const Instance points = instance();
  const Played exact = play("exact", points, {});
  ASSERT_TRUE(exact.proof.is_complete);
  const PlayedSteps played = played_proof(exact.proof, exact.steps, exact.execution.solution, points.set);
  EXPECT_EQ(edges_at_the_end(played), edges_in_input(exact.execution.solution, points.set));
  EXPECT_EQ(played.stages.front().name, "diamond test");
  EXPECT_EQ(played.stages.back().name, "optimum");
}

// Of a given instance, with what it says about each step.
PlayedSteps play_exact(const Instance& points) {
  const Played exact = play("exact", points, {});
  EXPECT_TRUE(exact.proof.is_complete);
  return played_proof(exact.proof, exact.steps, exact.execution.solution, points.set);
}

TEST(PlayedProof, ShowsAnEmptyTriangleOfEachDiamondAndAShorterDiagonalOfWhatLeaves) {
  const std::vector<Point> points = generate("uniform", 300, 5);
  const PlayedSteps played = play_exact(make_instance(points, "test"));
  const auto length_of = [&](Index a, Index b) {
    return std::hypot(points[a].x - points[b].x, points[a].y - points[b].y);
  };
  const auto turn = [&](Index a, Index b, Index c) { return orientation(points[a], points[b], points[c]); };
  std::size_t diagonals = 0;
  for (const auto& [kind, a, b, c, d, value] : played.steps) {
    if (kind == PlayedStep::Kind::pass) {
      EXPECT_TRUE(c == kNoIndex || d == kNoIndex) << a << "-" << b;
      EXPECT_TRUE(c == kNoIndex || turn(a, b, c) > 0);
      EXPECT_TRUE(d == kNoIndex || turn(a, b, d) < 0);
    }
    if (kind != PlayedStep::Kind::refute || c == kNoIndex || d == kNoIndex) continue;
    ++diagonals;
    EXPECT_LT(length_of(c, d), length_of(a, b)) << a << "-" << b;
    EXPECT_TRUE(turn(a, b, c) > 0 && turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) << a << "-" << b;
  }
  EXPECT_GT(count(played, PlayedStep::Kind::pass), 1000U);
  EXPECT_GT(diagonals, 500U);
}

TEST(PlayedProof, ShowsWhereFacesWithHolesAreCut) {
  const PlayedSteps played = play_exact(make_instance(generate("annulus", 1500, 2), "test"));
  EXPECT_GT(count(played, PlayedStep::Kind::cut), 0U);
}

TEST(PlayedSteps, GroupWhatIsOneStep) {
  const Instance points = make_instance(generate("uniform", 100, 1), "test");
  const Played quadtree = play("quadtree", points, {});
  const PlayedSteps cells = played_trace(quadtree.steps, quadtree.execution.solution, points.set);
  EXPECT_EQ(cells.boxes.size(), count(cells, PlayedStep::Kind::cell));
  EXPECT_EQ(cells.stages.back().name, "merge");
  for (const PlayedStep& step : cells.steps) {
    const bool is_split = step.kind == PlayedStep::Kind::cell && step.c == kNoIndex;
    EXPECT_TRUE(!is_split || step.b == 0) << "a split cell has no edges";
  }
  const Played patch = play("patch", points, {});
  const PlayedSteps patches = played_trace(patch.steps, patch.execution.solution, points.set);
  std::size_t steps = 0;
  for (const PlayedStep& step : patches.steps) {
    if (step.kind != PlayedStep::Kind::group) continue;
    EXPECT_GT(step.value, 0);
    steps += 1 + step.a;
  }
  EXPECT_EQ(steps, patches.steps.size());
}

TEST(PlayedSteps, AreInTheUnitOfThePoints) {
  const std::vector<Point> points = generate("uniform", 200, 1);
  std::vector<Point> huge;
  for (const Point& p : points) huge.push_back({std::ldexp(p.x, 600), std::ldexp(p.y, 600)});
  for (const std::string algorithm : {"quadtree", "patch", "annealing"}) {
    const Instance small = make_instance(points, "test"), large = make_instance(huge, "test");
    const Played of_small = play(algorithm, small, {}), of_large = play(algorithm, large, {});
    const PlayedSteps one = played_trace(of_small.steps, of_small.execution.solution, small.set);
    const PlayedSteps other = played_trace(of_large.steps, of_large.execution.solution, large.set);
    ASSERT_EQ(one.steps.size(), other.steps.size());
    for (std::size_t i = 0; i < one.steps.size(); ++i) {
      EXPECT_EQ(one.steps[i].a, other.steps[i].a);
      EXPECT_NEAR(std::ldexp(other.steps[i].value, -600), one.steps[i].value, 1e-12);
    }
    ASSERT_EQ(one.boxes.size(), other.boxes.size());
    for (std::size_t i = 0; i < one.boxes.size(); ++i)
      EXPECT_EQ(std::ldexp(one.boxes[i].left, 600), other.boxes[i].left);
  }
}

TEST(EdgeWitnesses, AreInsideHalvesOfTheDiamondAndCornersOfEmptyTriangles) {
  const std::vector<Point> points = {{0, 0}, {4, 0}, {2, 1}, {2, -3}, {1, 3}};
  EdgeWitnesses witnesses(points);
  EXPECT_EQ(witnesses.in_diamond({0, 1}), (EdgeWitnesses::Sides{2, kNoIndex}));
  CandidateStars stars(points.size());
  for (const Index apex : {2, 3, 4}) {
    stars.add({0, apex});
    stars.add({1, apex});
  }
  EXPECT_EQ(witnesses.apexes({0, 1}, stars), (EdgeWitnesses::Sides{2, 3}));
  stars.remove({0, 2});
  EXPECT_EQ(witnesses.apexes({0, 1}, stars), (EdgeWitnesses::Sides{kNoIndex, 3}))
      << "point 2 lies in the triangle with 4";
}

INSTANTIATE_TEST_SUITE_P(Families, PlayedStepsTest, ::testing::Values("uniform", "lattice", "circle"));

}  // namespace
}  // namespace mwt
