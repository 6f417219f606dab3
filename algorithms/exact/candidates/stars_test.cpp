#include "algorithms/exact/candidates/stars.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(Star, HoldsComponentsThatFloatsCanMultiply) {
  EXPECT_EQ(Star::component(0, 0x1p60), 0);
  EXPECT_EQ(Star::component(-3, 0x1p58), -0x3p58F);
  EXPECT_EQ(Star::component(0x1p-110, 0x1p60), Star::kMinComponent);
  EXPECT_TRUE(std::isnan(Star::component(0x1.fffp-111, 0x1p60)));
  EXPECT_TRUE(std::isnan(Star::component(-0x1p-1074, 0x1p60)));
  EXPECT_TRUE(std::isnan(Star::component(0x1p-1074, 0x1p-900))) << "the product is 0";
}

// Two stars in one arena do not share any row.
TEST(Star, KeepsItsRowsInOneArenaWithOthers) {
  StarArena arena(7);
  Star one = arena.allot(3), other = arena.allot(4);
  for (std::uint32_t i = 0; i < 3; ++i) one.append(10 + i, static_cast<float>(i), 0.5F);
  for (std::uint32_t i = 0; i < 4; ++i) other.append(20 + i, -static_cast<float>(i), 0.25F);
  for (std::uint32_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.target()[i], 10 + i);
    EXPECT_EQ(one.x()[i], static_cast<float>(i));
    EXPECT_EQ(one.y()[i], 0.5F);
    EXPECT_EQ(one.certificate()[i], Star::kNoCertificate);
  }
  EXPECT_EQ(other.targets().back(), 23U);
  EXPECT_EQ(other.x()[3], -3);
}

TEST(Star, LosesOneHalfedgeAndItsRoom) {
  StarArena arena(5);
  Star star = arena.allot(5);
  for (std::uint32_t i = 0; i < 4; ++i) star.append(i, static_cast<float>(i), -static_cast<float>(i));
  star.certificate()[3] = 7;
  star.erase(1);
  StarArena compact(3);
  const Star copy = compact_copy(star, compact);
  EXPECT_EQ(copy.capacity, 3U);
  EXPECT_EQ(std::vector(copy.targets().begin(), copy.targets().end()), (std::vector<std::uint32_t>{0, 2, 3}));
  EXPECT_EQ(copy.x()[1], 2);
  EXPECT_EQ(copy.y()[2], -3);
  EXPECT_EQ(copy.certificate()[2], 7U);
  EXPECT_EQ(copy.certificate()[1], Star::kNoCertificate);
}

}  // namespace
}  // namespace mwt
