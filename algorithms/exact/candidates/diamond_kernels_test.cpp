#include "algorithms/exact/candidates/diamond_kernels.h"

#include <gtest/gtest.h>

#include <array>

#include "algorithms/common/testing/extreme_points.h"
#include "algorithms/exact/candidates/near_points.h"
#include "algorithms/exact/testing/instruction_sets.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/numbers/scaling.h"

namespace mwt {
namespace {

using stage_testing::for_each_instruction_set;
using stage_testing::instances_of_all_families;

void expect_same_dead_distances(const NearPoints& near, std::span<DeadDistances> dead) {
  std::vector<DeadDistances> plain(dead.size());
  compute_dead_distances(near, dead);
  compute_dead_distances_plainly(near, plain);
  for (std::size_t i = 0; i < dead.size(); ++i) ASSERT_EQ(dead[i].code, plain[i].code) << "point " << i << " of a leaf";
}

using Found = std::vector<std::pair<Index, Index>>;

template <class Append>
Found found_by(const Append& append, const CandidateSearch& search, const PartnerLeaf& partners) {
  std::array<CandidatePair, KdOrder::kMaxLeaf * KdOrder::kMaxLeaf> out;
  const std::size_t count = append(search, partners, out.data());
  Found found;
  for (std::size_t i = 0; i < count; ++i) found.emplace_back(out[i].p, out[i].q);
  return found;
}

void expect_same_results(Points points) {
  const KdOrder order = make_kd_order(points);
  NearPointsFinder finder(order);
  std::vector<DeadDistances> dead(order.points.size());
  const auto points_of = [&](std::uint32_t leaf) {
    return std::span(dead).subspan(order.first_of(leaf), order.last_of(leaf) - order.first_of(leaf));
  };
  for (std::uint32_t leaf = order.leaf_count; leaf < 2 * order.leaf_count; ++leaf) {
    ASSERT_NO_FATAL_FAILURE(expect_same_dead_distances(finder.find(leaf), points_of(leaf)));
    ASSERT_NO_FATAL_FAILURE(expect_same_dead_distances(finder.add_samples(leaf), points_of(leaf)));
  }
  for (std::uint32_t leaf = order.leaf_count; leaf < 2 * order.leaf_count; ++leaf) {
    const CandidateSearch search{order.points, finder.find(leaf), order.first_of(leaf), points_of(leaf)};
    for (std::uint32_t partner = leaf; partner < 2 * order.leaf_count; ++partner) {
      const PartnerLeaf partners{order.first_of(partner), points_of(partner)};
      ASSERT_EQ(found_by(append_candidates, search, partners), found_by(append_candidates_plainly, search, partners))
          << "leaves " << leaf << " and " << partner;
    }
  }
}

// Bit by bit, with every instruction set.
TEST(DiamondKernels, AgreeWithThePlainLoops) {
  for_each_instruction_set([] {
    for (const auto& [name, points] : instances_of_all_families({4, 17, 80})) {
      SCOPED_TRACE(name);
      ASSERT_NO_FATAL_FAILURE(expect_same_results(points));
    }
  });
}

TEST(DiamondKernels, AgreeWithThePlainLoopsAtTheLimitsOfFloats) {
  for_each_instruction_set([] {
    for (std::uint64_t seed = 0; seed < 160; ++seed) {
      SCOPED_TRACE(seed);
      const auto kind = static_cast<test::ExtremePoints::Kind>(seed % test::ExtremePoints::kKinds);
      const std::vector<Point> points = exactly_scaled(test::ExtremePoints(seed).draw(kind, 5 + seed % 40));
      if (points.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_same_results(points));
    }
  });
}

// The two shortest distances of the test: at kMinDistance edges and near points begin to count.
TEST(DiamondKernels, AgreeWithThePlainLoopsAroundTheShortestDistance) {
  for_each_instruction_set([] {
    for (const double size : {0x1p-117, 0x1p-116, 0x1p-115, 0x1p-114, 0x1p-113}) {
      std::vector<Point> points = generate("uniform", 40, 3);
      for (Point& p : points) p = {p.x * size, p.y * size};
      points.push_back({1, 1});
      SCOPED_TRACE(size);
      ASSERT_NO_FATAL_FAILURE(expect_same_results(points));
    }
  });
}

}  // namespace
}  // namespace mwt
