#include "algorithms/two_chains/two_chains.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/common/testing/solver_testing.h"
#include "base/error.h"
#include "generators/registry.h"

namespace mwt {
namespace {

bool has_pair(Points points) { return find_chain_pair(points).has_value(); }

// Below (0, 0) (1, .8) (2, 1) (4, 0), above (4, 5) (2, 4.5) (0, 5), in some order.
const std::vector<Point> kFacing = {{2, 1}, {4, 5}, {0, 0}, {2, 4.5}, {1, .8}, {4, 0}, {0, 5}};

TEST(TwoChains, FindsBothChains) {
  const std::optional<ChainPair> pair = find_chain_pair(kFacing);
  ASSERT_TRUE(pair);
  // Counter-clockwise around their polygons; the hull's cycle starts at (0, 0).
  EXPECT_EQ(pair->first, (std::vector<Index>{5, 0, 4, 2}));
  EXPECT_EQ(pair->second, (std::vector<Index>{6, 3, 1}));
}

TEST(TwoChains, RefusesWhatIsNoPair) {
  const auto changed = [](std::size_t i, Point p) {
    std::vector<Point> points = kFacing;
    points[i] = p;
    return points;
  };
  EXPECT_TRUE(has_pair(kFacing));
  EXPECT_FALSE(has_pair(changed(0, {2, 4}))) << "(4, 5) is not beyond the line through (2, 4) and (4, 0)";
  EXPECT_TRUE(has_pair(changed(1, {4, 7}))) << "upper chain still convex, lower one out of its way";
  EXPECT_FALSE(has_pair(changed(4, {1, .2}))) << "lower chain not convex";
  EXPECT_FALSE(has_pair(changed(3, {2, 5.5}))) << "on the hull";
  const std::vector<Point> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_FALSE(has_pair(square)) << "convex position";
  EXPECT_FALSE(has_pair(changed(1, {4, 9}))) << "(0, 0) on the line through (4, 9) and (2, 4.5)";
  Context context;
  EXPECT_THROW((void)two_chains_entry().function(square, context), NotApplicable);
}

// With the roles of the points, and the plane, in any order.
TEST(TwoChains, DoesNotDependOnOrderOrDirection) {
  const double optimum = solve_to_optimality("two_chains", kFacing).optimum->middle();
  std::vector<Point> points = kFacing;
  for (int turn = 0; turn < 4; ++turn) {
    for (Point& p : points) p = {-p.y, p.x};
    std::rotate(points.begin(), points.begin() + 5, points.end());
    EXPECT_DOUBLE_EQ(solve_to_optimality("two_chains", points).optimum->middle(), optimum);
    std::vector<Point> mirrored = points;
    for (Point& p : mirrored) p.x = -p.x;
    EXPECT_DOUBLE_EQ(solve_to_optimality("two_chains", mirrored).optimum->middle(), optimum);
  }
  EXPECT_TRUE(
      overlap(*solve_to_optimality("subset_dp", kFacing).optimum, *solve_to_optimality("two_chains", kFacing).optimum));
}

TEST(TwoChains, AgreesWithTheGeneralSolverOnCorridors) {
  for (const char* family : {"greedy_corridor", "greedy_ratio", "flip_corridor"}) {
    for (const Index n : {8U, 9U, 16U, 40U, 100U}) {
      SCOPED_TRACE(std::string(family) + " n=" + std::to_string(n));
      const std::vector<Point> points = generate(family, n, 1);
      EXPECT_TRUE(
          overlap(*solve_to_optimality("two_chains", points).optimum, *solve_to_optimality("exact", points).optimum));
    }
  }
}

// Whatever it accepts among random small sets it solves right; collinear triples and equal lengths are common here.
TEST(TwoChains, AgreesWithSubsetsOnRandomSmallSets) {
  int accepted = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    const std::string family = seed % 3 == 0 ? "uniform" : "integer_uniform";
    const std::map<std::string, std::string> parameters =
        seed % 3 == 0 ? std::map<std::string, std::string>{} : std::map<std::string, std::string>{{"range", "5"}};
    std::vector<Point> points;
    try {
      points = generate(family, static_cast<Index>(5 + seed % 3), seed, parameters);
    } catch (const InputError&) {
      continue;
    }
    if (!has_pair(points)) continue;
    ++accepted;
    SCOPED_TRACE(seed);
    EXPECT_TRUE(
        overlap(*solve_to_optimality("two_chains", points).optimum, *solve_to_optimality("subset_dp", points).optimum));
  }
  EXPECT_GT(accepted, 30);
}

TEST(TwoChains, TakesCollinearPartsOfChains) {
  const std::vector<Point> points = {{0, 0}, {1, 1}, {2, 2}, {3, 2}, {4, 2}, {6, 0}, {-2, 9}, {3, 8}, {8, 9}};
  ASSERT_TRUE(has_pair(points));
  EXPECT_TRUE(
      overlap(*solve_to_optimality("two_chains", points).optimum, *solve_to_optimality("subset_dp", points).optimum));
}

TEST(TwoChains, ProvesLongChains) { solve_to_optimality("two_chains", generate("greedy_corridor", 4000, 1)); }

}  // namespace
}  // namespace mwt
