// The finds that are kept as named instances, rated again.
#include "generators/hunted/hunted.h"

#include <gtest/gtest.h>

#include "harness/hunt/alpha_oracle.h"

namespace mwt {
namespace {

// Greedy's triangulation is fixed by its definition; local searches may get better.
TEST(HuntedInstances, are_as_bad_for_greedy_as_when_they_were_found) {
  const Catalogue catalogue = Catalogue::built_in();
  int rated = 0;
  for (const HuntedInstance& instance : hunted_instances()) {
    if (instance.algorithm != "greedy") continue;
    Request request;
    request.algorithm = &catalogue.algorithm("greedy");
    const auto n = static_cast<Index>(instance.points.size());
    const std::optional<Interval> alpha = AlphaOracle(request, solver_for_hunt(catalogue, n)).alpha(instance.points);
    ASSERT_TRUE(alpha) << n;
    EXPECT_NEAR(alpha->lower, instance.alpha, 1e-12) << n;
    ++rated;
  }
  EXPECT_EQ(rated, 5);
}

}  // namespace
}  // namespace mwt
