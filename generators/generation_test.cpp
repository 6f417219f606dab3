#include "generators/generation.h"

#include <gtest/gtest.h>

#include <limits>
#include <new>

#include "base/error.h"

namespace mwt {
namespace {

GeneratorInfo family(GeneratorFunction function) {
  GeneratorInfo info;
  info.name = "broken";
  info.function = function;
  return info;
}

std::vector<Point> on_a_parabola(Index n) {
  std::vector<Point> points;
  for (Index i = 0; i < n; ++i) points.push_back({static_cast<double>(i), static_cast<double>(i) * i});
  return points;
}

std::string failure_of(GeneratorFunction function) {
  try {
    static_cast<void>(generate_verified(family(function), 10, 7, {}));
  } catch (const GeneratorFailure& failure) {
    return failure.what();
  }
  return "none";
}

TEST(Generation, RightPointsPass) {
  const auto right = [](Index n, std::uint64_t, const Parameters&) { return on_a_parabola(n); };
  EXPECT_EQ(generate_verified(family(right), 10, 7, {}), on_a_parabola(10));
}

TEST(Generation, AWrongNumberOfPointsIsTheFamilysFailure) {
  const auto more = [](Index n, std::uint64_t, const Parameters&) { return on_a_parabola(n + 1); };
  EXPECT_EQ(failure_of(more), "generator broken: returned 11 points for n=10 seed=7; its function is wrong");
  const auto two = [](Index, std::uint64_t, const Parameters&) { return on_a_parabola(2); };
  EXPECT_EQ(failure_of(two), "generator broken: returned 2 points for n=10 seed=7; its function is wrong");
}

TEST(Generation, EqualPointsAreAFailureUnlessTheEntrySaysSo) {
  const auto equal = [](Index n, std::uint64_t, const Parameters&) {
    std::vector<Point> points = on_a_parabola(n);
    points.back() = {0.0, -0.0};
    return points;
  };
  EXPECT_EQ(failure_of(equal), "generator broken: returned equal points for n=10 seed=7; its function is wrong");
  GeneratorInfo allowed = family(equal);
  allowed.repeats_points = true;
  EXPECT_EQ(generate_verified(allowed, 10, 7, {}).size(), 10u);
}

TEST(Generation, PointsThatAreNotFiniteAreAFailure) {
  const auto infinite = [](Index n, std::uint64_t, const Parameters&) {
    std::vector<Point> points = on_a_parabola(n);
    points[3].y = std::numeric_limits<double>::infinity();
    return points;
  };
  const auto nan = [](Index n, std::uint64_t, const Parameters&) {
    std::vector<Point> points = on_a_parabola(n);
    points[3].x = std::numeric_limits<double>::quiet_NaN();
    return points;
  };
  for (const GeneratorFunction function : {GeneratorFunction(infinite), GeneratorFunction(nan)}) {
    EXPECT_EQ(failure_of(function),
              "generator broken: returned points that are not finite for n=10 seed=7; its function is wrong");
  }
}

TEST(Generation, AnUndeclaredParameterIsNamed) {
  const auto misspelt = [](Index n, std::uint64_t, const Parameters& parameters) {
    return on_a_parabola(n + static_cast<Index>(parameters.integer("sgima")));
  };
  GeneratorInfo info = family(misspelt);
  info.parameters = {{"sigma", ParameterType::integer, "1", "a number"}};
  try {
    static_cast<void>(generate_verified(info, 10, 7, Parameters(info.name, info.parameters, {})));
    ADD_FAILURE();
  } catch (const GeneratorFailure& failure) {
    EXPECT_EQ(std::string(failure.what()),
              "generator broken: the code of 'broken' reads a parameter 'sgima' that its entry does not declare; it "
              "declares sigma "
              "for n=10 seed=7; its function is wrong");
  }
}

TEST(Generation, TheUsersMistakesStayTheUsers) {
  const auto refuses = [](Index, std::uint64_t, const Parameters&) -> std::vector<Point> {
    throw InputError("no such n");
  };
  EXPECT_THROW(static_cast<void>(generate_verified(family(refuses), 10, 7, {})), InputError);
  EXPECT_THROW(static_cast<void>(generate_verified(family(refuses), 2, 7, {})), InputError);
  const auto exhausts = [](Index, std::uint64_t, const Parameters&) -> std::vector<Point> { throw std::bad_alloc(); };
  EXPECT_THROW(static_cast<void>(generate_verified(family(exhausts), 10, 7, {})), std::bad_alloc);
}

}  // namespace
}  // namespace mwt
