#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "base/testing/test_folder.h"
#include "mwt/mwt.h"

namespace mwt::v1 {
namespace {

using test::message_of;
using test::TestFolder;

const std::vector<Point> kSquareWithTwin{{0, 0}, {1, 0}, {1, 1.25}, {0, 1}, {1, 0}};

double length(const std::vector<Point>& points, std::uint32_t a, std::uint32_t b) {
  return std::hypot(points[a].x - points[b].x, points[a].y - points[b].y);
}

// Every edge counted by its triangles, hull edges twice: what certified sums must enclose.
double plain_weight(const std::vector<Point>& points, const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> lengths;
  for (const Triangle& t : triangles) {
    for (const auto& [a, b] : {std::pair(t[0], t[1]), {t[1], t[2]}, {t[2], t[0]}})
      lengths[{std::min(a, b), std::max(a, b)}] = length(points, a, b);
  }
  double sum = 0;
  for (const auto& [edge, own] : lengths) sum += own;
  return sum;
}

TEST(Library, TriangulatesWithEveryAlgorithm) {
  const std::vector<Point> points = generate("circle", 9);
  for (const Entry& algorithm : algorithms()) {
    try {
      Options options;
      options.algorithm = algorithm.name;
      const Result result = triangulate(points, options);
      EXPECT_FALSE(broken_rule(points, result.triangles)) << algorithm.name;
      EXPECT_NEAR(result.weight.upper, plain_weight(points, result.triangles), 1e-9) << algorithm.name;
      EXPECT_EQ(result.stop_reason, "") << algorithm.name;
    } catch (const NotApplicable&) {
      EXPECT_EQ(algorithm.name, "two_chains");
    }
  }
}

TEST(Library, ProvesOptima) {
  const TestFolder folder;
  const std::vector<Point> points = generate("uniform", 300, 5);
  const Result optimum = minimum_weight_triangulation(points, {.threads = 2, .proof_file = folder.path("p.mwtproof")});
  EXPECT_TRUE(optimum.is_proved);
  ASSERT_TRUE(optimum.optimum);
  EXPECT_LE(optimum.optimum->upper - optimum.optimum->lower, 1e-12 * optimum.optimum->upper);
  EXPECT_TRUE(verify_proof(folder.path("p.mwtproof"), points).is_optimal);
  EXPECT_NE(message_of<InputError>([&] {
              static_cast<void>(verify_proof(folder.path("p.mwtproof"), generate("uniform", 300, 6)));
            }).find("refused: instance: the proof is about other points"),
            std::string::npos);
  const Result greedy = triangulate(points);
  const Interval ratio = alpha(greedy.weight, *optimum.optimum);
  EXPECT_GE(ratio.lower, 1);
  EXPECT_GT(ratio.upper, 1);
  EXPECT_FALSE(greedy.is_proved);
  EXPECT_FALSE(greedy.optimum);
}

TEST(Library, CornersArePositionsInTheInput) {
  const Result result = minimum_weight_triangulation(kSquareWithTwin);
  EXPECT_EQ(result.triangles.size(), 2u);
  for (const Triangle& t : result.triangles) {
    for (const std::uint32_t corner : t) EXPECT_LT(corner, 4u) << "of equal points the first";
  }
  EXPECT_FALSE(broken_rule(kSquareWithTwin, result.triangles));
  EXPECT_DOUBLE_EQ(weight(kSquareWithTwin, result.triangles).upper, result.weight.upper);
  EXPECT_TRUE(broken_rule(kSquareWithTwin, std::vector<Triangle>{{0, 1, 2}}));
  EXPECT_THROW(static_cast<void>(weight(kSquareWithTwin, std::vector<Triangle>{{0, 1, 2}})), InputError);
}

TEST(Library, TimeLimitsGiveBounds) {
  const Result result = minimum_weight_triangulation(generate("circle", 3000), {.time_limit_s = 1e-3});
  EXPECT_EQ(result.stop_reason, "deadline");
  ASSERT_TRUE(result.optimum);
  EXPECT_GT(result.optimum->lower, 0);
}

TEST(Library, AnInterruptStopsEveryAlgorithm) {
  const std::atomic<bool> interrupt = true;
  for (const std::vector<Point>& points :
       {generate("circle", 12), generate("uniform", 300), generate("circle", 2000)}) {
    for (const Entry& algorithm : algorithms()) {
      Options options;
      options.algorithm = algorithm.name;
      options.interrupt = &interrupt;
      try {
        static_cast<void>(triangulate(points, options));
        FAIL() << algorithm.name;
      } catch (const Interrupted&) {
      } catch (const NotApplicable&) {
      }
    }
  }
  SolveOptions options;
  options.interrupt = &interrupt;
  EXPECT_THROW(static_cast<void>(minimum_weight_triangulation(generate("circle", 3000), options)), Interrupted);
}

TEST(Library, ReadsAndWritesFiles) {
  const TestFolder folder;
  const std::vector<Point> points = generate("clustered", 50, 2, {{"clusters", "3"}});
  write_points(folder.path("p.json"), points);
  EXPECT_EQ(read_points(folder.path("p.json")), points);
  EXPECT_EQ(read_points(folder.file("c.csv", "a;b;c\n1;2;3\n4;5;6\n"), "c,a"), (std::vector<Point>{{3, 1}, {6, 4}}));
  const Result result = triangulate(points);
  write_triangles(folder.path("t.csv"), result.triangles);
  EXPECT_EQ(read_triangulation(folder.path("t.csv"), points), result.triangles);
}

TEST(Library, ErrorsHaveTheWordsOfTheProgram) {
  const auto mistake = [](const std::vector<Point>& points, const Options& options) {
    return message_of<InputError>([&] { static_cast<void>(triangulate(points, options)); });
  };
  const std::vector<Point> three{{0, 0}, {1, 0}, {0, 1}};
  EXPECT_NE(mistake(three, {.algorithm = "greedily"}).find("unknown algorithm 'greedily'; known: "), std::string::npos);
  EXPECT_NE(mistake(three, {.algorithm = "patch", .parameters = {{"kk", "3"}}}).find("kk"), std::string::npos);
  EXPECT_NE(mistake({{0, 0}, {1, 1}, {2, 2}}, {}).find("on one line"), std::string::npos);
  EXPECT_NE(mistake({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}, {2, 2}}, {}), "");
  EXPECT_NE(mistake(three, {.threads = 0}).find("threads"), std::string::npos);
  EXPECT_NE(mistake(three, {.time_limit_s = -1}).find("time_limit_s"), std::string::npos);
  EXPECT_THROW(static_cast<void>(triangulate(generate("uniform", 20), {.algorithm = "two_chains"})), NotApplicable);
  EXPECT_THROW(static_cast<void>(generate("uniform", 1)), InputError);
  EXPECT_EQ(version().substr(0, 2), std::to_string(MWT_VERSION_MAJOR) + ".");
}

}  // namespace
}  // namespace mwt::v1
