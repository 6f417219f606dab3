#include "harness/rating/optimum_search.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

std::vector<std::string> default_sources(Index n, bool in_convex_position) {
  static const Catalogue catalogue = Catalogue::built_in();
  std::vector<std::string> names;
  for (const AlgorithmInfo* source : optimum_sources_for(catalogue, {}, n, in_convex_position))
    names.push_back(source->name);
  return names;
}

TEST(OptimumSources, ByDefaultTheOneThatReachesFurthestComesFirst) {
  for (const Index n : {3, 13, 25, 1000, 1000000}) EXPECT_EQ(default_sources(n, false).front(), "exact") << n;
  EXPECT_EQ(default_sources(1000, false), (std::vector<std::string>{"exact", "two_chains"}));
}

TEST(OptimumSources, ConvexPositionHasItsOwn) {
  EXPECT_EQ(default_sources(1000, true), (std::vector<std::string>{"polygon_dp", "exact", "two_chains"}));
  EXPECT_EQ(default_sources(30000, true), (std::vector<std::string>{"exact", "two_chains"}));
}

}  // namespace
}  // namespace mwt
