#include "generators/hunted/hunted.h"

#include <gtest/gtest.h>

#include "generators/testing.h"

namespace mwt {
namespace {

TEST(Hunted, points_are_the_recorded_ones) {
  EXPECT_EQ(golden_hash("hunted", 10, 1), "9e17077788b4546d47b74d6b38213f31");
  EXPECT_EQ(golden_hash("hunted", 20, 1, {{"algorithm", "flip"}}), "929a43bafea846aa813d19c35a383479");
  EXPECT_EQ(golden_hash("hunted", 16, 1, {{"algorithm", "patch"}}), "82d500d53b205f75cd39379b5c801293");
  EXPECT_EQ(golden_hash("hunted", 12, 1, {{"algorithm", "quadtree"}}), "ec27636803ecb587749f468a7e268ea5");
}

TEST(Hunted, every_find_can_be_generated_and_has_its_law) {
  for (const HuntedInstance& instance : hunted_instances()) {
    const auto n = static_cast<Index>(instance.points.size());
    EXPECT_EQ(generate("hunted", n, 1, {{"algorithm", instance.algorithm}}), instance.points);
    EXPECT_GE(instance.alpha, 1);
  }
  EXPECT_EQ(hunted_entry().growth_laws.size(), hunted_instances().size());
}

TEST(Hunted, other_sizes_are_refused) {
  EXPECT_NE(refusal("hunted", 14).find("nearest legal n is 12"), std::string::npos);
  EXPECT_NE(refusal("hunted", 19).find("nearest legal n is 20"), std::string::npos);
}

}  // namespace
}  // namespace mwt
