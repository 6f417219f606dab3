#include "generators/distinct_points.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "base/error.h"
#include "generators/random.h"

namespace mwt {
namespace {

TEST(DistinctPoints, keeps_the_first_of_equal_points) {
  DistinctPoints found(3);
  EXPECT_TRUE(found.insert({1, 0}));
  EXPECT_FALSE(found.insert({1, -0.0}));
  EXPECT_TRUE(found.insert({-0.0, 1}));
  EXPECT_FALSE(found.insert({0, 1}));
  EXPECT_TRUE(found.insert({1, 1}));
  const std::vector<Point> points = found.take();
  EXPECT_EQ(points, (std::vector<Point>{{1, 0}, {0, 1}, {1, 1}}));
  EXPECT_FALSE(std::signbit(points[1].x));
}

TEST(DistinctPoints, agrees_with_a_set_on_many_points) {
  constexpr Index kCapacity = 4000;
  RandomEngine engine = make_engine("test", 1);
  DistinctPoints found(kCapacity);
  std::set<std::pair<double, double>> expected;
  while (found.size() < kCapacity) {
    const auto x = static_cast<double>(uniform_below(engine, 64));
    const auto y = static_cast<double>(uniform_below(engine, 64));
    ASSERT_EQ(found.insert({x, y}), expected.insert({x, y}).second);
  }
  EXPECT_EQ(found.take().size(), expected.size());
}

TEST(DistinctPoints, draws_again_after_a_collision) {
  const std::vector<Point> draws = {{0, 0}, {0, 0}, {1, 0}, {0, 0}, {0, 1}};
  std::size_t next = 0;
  const auto points = draw_distinct_points("test", 3, [&](Index) { return draws.at(next++); });
  EXPECT_EQ(points, (std::vector<Point>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST(DistinctPoints, draws_all_again_if_they_lie_on_one_line) {
  const std::vector<Point> draws = {{0, 0}, {1, 1}, {2, 2}, {0, 0}, {1, 1}, {2, 3}};
  std::size_t next = 0;
  const auto points = draw_distinct_points("test", 3, [&](Index) { return draws.at(next++); });
  EXPECT_EQ(points, (std::vector<Point>{{0, 0}, {1, 1}, {2, 3}}));
}

TEST(DistinctPoints, gives_up_when_there_are_not_enough) {
  try {
    (void)draw_distinct_points("test", 5, [](Index i) { return Point{static_cast<double>(i % 2), 0}; });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("test: "), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("ended at 2"), std::string::npos);
  }
}

}  // namespace
}  // namespace mwt
