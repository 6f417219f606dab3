#include "harness/rating/optimum_claims.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(OptimumClaims, BoundsAreTheBestThatStand) {
  OptimumClaims claims;
  EXPECT_FALSE(claims.bounds());
  EXPECT_TRUE(claims.add_weight({"greedy", 12}).empty());
  EXPECT_FALSE(claims.bounds()) << "no lower bound";
  EXPECT_TRUE(claims.add_claim({"1", "weak", {5, 11}}).empty());
  EXPECT_TRUE(claims.add_claim({"2", "exact", {10, 10.5}}).empty());
  EXPECT_EQ(claims.bounds(), (Interval{10, 10.5}));
  EXPECT_TRUE(claims.add_weight({"patch", 10}).empty()) << "as light as the bound allows";
  EXPECT_EQ(claims.bounds(), (Interval{10, 10}));
}

TEST(OptimumClaims, ALighterTriangulationDisprovesTheClaimNotItself) {
  OptimumClaims claims;
  EXPECT_TRUE(claims.add_claim({"1", "weak", {4, 11}}).empty());
  EXPECT_TRUE(claims.add_claim({"2", "exact", {5.25, 5.25}}).empty());
  const std::vector<Disproof> disproofs = claims.add_weight({"greedy", 5});
  ASSERT_EQ(disproofs.size(), 1u);
  EXPECT_EQ(disproofs[0].claim.id, "2");
  EXPECT_EQ(disproofs[0].text(),
            "CONTRADICTION: exact certified that no triangulation weighs less than 5.25, but a checked one of greedy "
            "weighs 5");
  EXPECT_EQ(claims.bounds(), (Interval{4, 5})) << "what is not disproved stands";
  EXPECT_EQ(claims.standing().size(), 1u);
}

TEST(OptimumClaims, AClaimAboveAKnownTriangulationIsDisprovedAtOnce) {
  OptimumClaims claims;
  EXPECT_TRUE(claims.add_weight({"greedy", 5}).empty());
  const std::vector<Disproof> disproofs = claims.add_claim({"2", "exact", {5.25, 5.25}});
  ASSERT_EQ(disproofs.size(), 1u);
  EXPECT_EQ(disproofs[0].claim.id, "2");
  EXPECT_EQ(disproofs[0].witness, "greedy");
  EXPECT_FALSE(claims.bounds());
}

TEST(OptimumClaims, OfTwoClaimsTheOneWithTheLighterTriangulationStands) {
  for (const bool wrong_first : {true, false}) {
    const OptimumClaim wrong{"wrong", "exact", {5.25, 5.25}};
    const OptimumClaim right{"right", "subset_dp", {5, 5}};
    OptimumClaims claims;
    EXPECT_TRUE(claims.add_claim(wrong_first ? wrong : right).empty());
    const std::vector<Disproof> disproofs = claims.add_claim(wrong_first ? right : wrong);
    ASSERT_EQ(disproofs.size(), 1u);
    EXPECT_EQ(disproofs[0].claim.id, "wrong");
    EXPECT_EQ(claims.bounds(), (Interval{5, 5}));
  }
}

TEST(OptimumClaims, ASolverMayDisproveItself) {
  const Disproof disproof{{"", "exact", {7, 7}}, "", 6};
  EXPECT_EQ(disproof.text(),
            "CONTRADICTION: exact certified that no triangulation weighs less than 7, but its own weighs 6");
}

}  // namespace
}  // namespace mwt
