// Regions whose bounds can be computed by hand.
#include "verifier/region.h"

#include <gtest/gtest.h>

#include "base/testing/test_folder.h"
#include "verifier/diamond.h"
#include "verifier/refused.h"
#include "verifier/regions.h"
#include "verifier/testing/naive_prover.h"
#include "verifier/verify.h"

namespace mwt::verifier {
namespace {

using namespace testing;

std::vector<std::uint8_t> bytes_of(const RegionStep& step) {
  Encoder out;
  encode_region(out, step);
  return out.bytes();
}

std::vector<Leaf> leaves_of(const std::vector<Point>& points, const std::vector<std::uint8_t>& bytes) {
  const test::TestFolder folder;
  write_file(folder.path("proof"), file_of(bytes));
  ProofReader reader(folder.path("proof"));
  EXPECT_EQ(reader.number(), 5U);
  const PointTree tree(points);
  Region region(points, tree, reader);
  std::vector<Leaf> leaves;
  region.read_leaves(reader, [&](const Leaf& leaf) { leaves.push_back(leaf); });
  reader.expect_end();
  return leaves;
}

// The leaves of one region that is written by hand.
std::vector<Leaf> leaves_of(const std::vector<Point>& points, const RegionStep& step) {
  return leaves_of(points, bytes_of(step));
}

// A square of side 8 with both diagonals, in units of 1: half diagonals are 5.65..., rounded down to 5.
const std::vector<Point> kSquare = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};

RegionStep square_region(std::vector<std::int64_t> side_duals, std::vector<std::int64_t> diagonal_duals) {
  RegionStep region{0, {{0, 1, 2, 3}}, {}, {{0, 2}, {1, 3}}, {TreeNode{}}};
  region.tree.front().side_duals = std::move(side_duals);
  for (const std::int64_t dual : diagonal_duals) region.tree.front().edge_duals.push_back({dual});
  return region;
}

TEST(Region, DualValuesWithinTheirMeansCountInFull) {
  // Every triangle has two sides with dual value and a half diagonal.
  const std::vector<Leaf> leaves = leaves_of(kSquare, square_region({3, 2, 3, 2}, {0, 0}));
  ASSERT_EQ(leaves.size(), 1U);
  EXPECT_EQ(leaves[0].sum, 10);
  EXPECT_EQ(leaves[0].worst, 0);
}

TEST(Region, ANodeIsOfAKnownKind) {
  RegionStep region = square_region({3, 2, 3, 2}, {0, 0});
  std::vector<std::uint8_t> bytes = bytes_of(region);
  region.tree.clear();
  std::uint8_t& tag = bytes[bytes_of(region).size()];
  ASSERT_EQ(tag, 0);
  tag = 4;
  EXPECT_THROW(static_cast<void>(leaves_of(kSquare, bytes)), Refused);
}

TEST(Region, TheWorstTriangleIsFound) {
  // Triangles 0 1 2 and 1 2 3 pay 5 for dual values of 7 and of 4.
  const std::vector<Leaf> leaves = leaves_of(kSquare, square_region({5, 2, 2, 2}, {0, 0}));
  EXPECT_EQ(leaves[0].sum, 11);
  EXPECT_EQ(leaves[0].worst, -2);
}

TEST(Region, WhatOneSideOfADiagonalGetsTheOtherPays) {
  // The side from 0 to 2 belongs to triangle 0 2 3, that from 2 to 0 to 0 1 2.
  const std::vector<Leaf> leaves = leaves_of(kSquare, square_region({0, 0, 0, 0}, {6, 0}));
  EXPECT_EQ(leaves[0].worst, -1);
  EXPECT_EQ(leaves_of(kSquare, square_region({0, 0, 0, 0}, {-7, 0}))[0].worst, -2);
}

TEST(Region, DecisionsRemoveTrianglesAndFreeDualValues) {
  RegionStep region{0, {{0, 1, 2, 3}}, {}, {{0, 2}, {1, 3}}, {}};
  // In: triangles 0 1 2 and 0 2 3 alone; the dual values of both sides of diagonal 0 2 count.
  region.tree.push_back({false, 0, {}, {}});
  region.tree.push_back({true, 0, {0, 0, 0, 0}, {{5, 5}, {100}}});
  // Out: triangles 0 1 3 and 1 2 3 alone.
  region.tree.push_back({true, 0, {5, 5, 0, 0}, {{100}, {0}}});
  const std::vector<Leaf> leaves = leaves_of(kSquare, region);
  ASSERT_EQ(leaves.size(), 2U);
  EXPECT_EQ(leaves[0].sum, 10);
  EXPECT_EQ(leaves[0].worst, 0);
  EXPECT_EQ(leaves[1].sum, 10);
  EXPECT_EQ(leaves[1].worst, 0);
}

TEST(Region, TakesDecisionsBack) {
  RegionStep region{0, {{0, 1, 2, 3}}, {}, {{0, 2}, {1, 3}}, {}};
  const TreeNode leaf{true, 0, {0, 0, 0, 0}, {{6}, {0}}};
  region.tree = {{false, 1, {}, {}}, {true, 0, {0, 0, 0, 0}, {{6}, {0, 0}}}, leaf};
  const std::vector<Leaf> leaves = leaves_of(kSquare, region);
  EXPECT_EQ(leaves[0].worst, 0) << "diagonal 0 2 crosses the one that is in";
  EXPECT_EQ(leaves[1].worst, -1) << "and is back";
}

TreeNode changes(std::vector<std::uint64_t> sides, std::vector<std::int64_t> side_duals,
                 std::vector<std::uint64_t> edges, std::vector<std::vector<std::int64_t>> edge_duals) {
  return {true, 0, std::move(side_duals), std::move(edge_duals), false, true, std::move(sides), std::move(edges)};
}

// The base: 0 0 0 0 on the sides, which is 5 less than what every triangle pays.
RegionStep square_with_base() {
  RegionStep region{0, {{0, 1, 2, 3}}, {}, {{0, 2}, {1, 3}}, {}};
  region.tree.push_back({true, 0, {0, 0, 0, 0}, {{0}, {0}}, true});
  return region;
}

TEST(Region, LeavesChangeTheDualValuesOfTheirBase) {
  RegionStep region = square_with_base();
  region.tree.push_back({false, 0, {}, {}});
  region.tree.push_back(changes({}, {}, {0}, {{5, 4}}));
  region.tree.push_back(changes({0, 3}, {3, 4}, {}, {}));
  const std::vector<Leaf> leaves = leaves_of(kSquare, region);
  ASSERT_EQ(leaves.size(), 2U);
  EXPECT_EQ(leaves[0].sum, 9);
  EXPECT_EQ(leaves[0].worst, 0);
  EXPECT_EQ(leaves[1].sum, 7);
  EXPECT_EQ(leaves[1].worst, -2) << "triangle 0 1 3 pays 5 for both sides, whatever the leaf before changed";
}

TEST(Region, WhatABaseLacksItsLeavesLack) {
  RegionStep region = square_with_base();
  region.tree.front().side_duals = {6, 0, 0, 0};
  region.tree.push_back(changes({2}, {1}, {}, {}));
  const std::vector<Leaf> leaves = leaves_of(kSquare, region);
  EXPECT_EQ(leaves[0].sum, 7);
  EXPECT_EQ(leaves[0].worst, -1);
}

TEST(Region, ABaseHoldsForWhatIsBelowIt) {
  RegionStep region = square_with_base();
  region.tree.front().side_duals = {2, 2, 0, 0};
  region.tree.push_back({false, 0, {}, {}});
  region.tree.push_back({true, 0, {1, 1, 1, 0}, {{0, 0}, {0}}, true});
  region.tree.push_back(changes({}, {}, {}, {}));
  region.tree.push_back(changes({}, {}, {}, {}));
  const std::vector<Leaf> leaves = leaves_of(kSquare, region);
  ASSERT_EQ(leaves.size(), 2U);
  EXPECT_EQ(leaves[0].sum, 3);
  EXPECT_EQ(leaves[1].sum, 4);
  region.tree[2].is_base = false;
  region.tree.erase(region.tree.begin() + 3);
  EXPECT_EQ(leaves_of(kSquare, region)[1].sum, 4) << "after a leaf of its own dual values";
  region.tree.front() = {false, 1, {}, {}};
  EXPECT_THROW(leaves_of(kSquare, region), Refused) << "changes without a base";
}

TEST(Region, ChangesAreInRange) {
  for (const TreeNode& leaf : {changes({4}, {1}, {}, {}), changes({}, {}, {2}, {{1}})}) {
    RegionStep region = square_with_base();
    region.tree.push_back(leaf);
    EXPECT_THROW(leaves_of(kSquare, region), Refused);
  }
}

TEST(Region, PointsWithoutCertainEdgesBelongToIt) {
  // A point in a triangle: each of the three small triangles pays two halves of spokes.
  const std::vector<Point> points = {{0, 0}, {12, 0}, {6, 12}, {6, 4}};
  RegionStep region{0, {{0, 1, 2}}, {3}, {{0, 3}, {1, 3}, {2, 3}}, {TreeNode{}}};
  region.tree.front().side_duals = {6, 7, 7};  // halves: 3, 3, 4
  region.tree.front().edge_duals = {{0}, {0}, {0}};
  EXPECT_EQ(leaves_of(points, region)[0].worst, 0);
  region.tree.front().side_duals = {7, 7, 7};
  EXPECT_EQ(leaves_of(points, region)[0].worst, -1);
}

TEST(Region, TheLargeTriangleWithAPointInsideIsNone) {
  const std::vector<Point> points = {{0, 0}, {12, 0}, {6, 12}, {6, 4}};
  RegionStep region{0, {{0, 1, 2}}, {3}, {{0, 3}, {1, 3}, {2, 3}}, {TreeNode{}}};
  region.tree.front().side_duals = {6, 7, 7};  // the large triangle would pay nothing for 20
  region.tree.front().edge_duals = {{0}, {0}, {0}};
  EXPECT_EQ(leaves_of(points, region)[0].worst, 0);
}

TEST(Region, EdgesAppearOnce) {
  RegionStep twice = square_region({0, 0, 0, 0}, {0, 0});
  twice.open_edges[1] = {0, 2};
  EXPECT_THROW(leaves_of(kSquare, twice), Refused);
  RegionStep side = square_region({0, 0, 0, 0}, {0, 0});
  side.open_edges[1] = {0, 3};
  EXPECT_THROW(leaves_of(kSquare, side), Refused);
}

TEST(Verify, SaysWhereAProofFails) {
  const test::TestFolder folder;
  std::vector<Point> points = random_points(12, 5);
  points.insert(points.begin() + 3, points[1]);  // a duplicate: positions in the file are not those of the points
  std::vector<Point> distinct = points;
  distinct.erase(distinct.begin() + 3);
  Proof proof = *NaiveProver(distinct).prove();
  const Corners& t = proof.triangles.front();
  proof.steps.insert(proof.steps.begin(), {1, {{t[0], t[1]}}, {}});
  write_file(folder.path("proof"), file_of(encode(proof)));
  const auto in_file = [](Index p) { return std::to_string(p < 3 ? p : p + 1); };
  try {
    static_cast<void>(verify(points, folder.path("proof")));
    FAIL();
  } catch (const Refused& refused) {
    const std::string message = refused.what();
    EXPECT_NE(message.find("step 1, edge 1: "), std::string::npos) << message;
    EXPECT_NE(message.find("points " + in_file(t[0]) + " " + in_file(t[1])), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace mwt::verifier
