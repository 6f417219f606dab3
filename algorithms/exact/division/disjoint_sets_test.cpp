#include "algorithms/exact/division/disjoint_sets.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(DisjointSets, AreRepresentedByTheirSmallestMember) {
  DisjointSets sets(6);
  sets.unite(5, 3);
  sets.unite(4, 5);
  sets.unite(1, 2);
  EXPECT_EQ(sets.find(4), 3U);
  EXPECT_EQ(sets.find(2), 1U);
  EXPECT_EQ(sets.find(0), 0U);
  sets.unite(4, 2);
  sets.unite(2, 4);
  EXPECT_EQ(sets.find(5), 1U);
}

}  // namespace
}  // namespace mwt
