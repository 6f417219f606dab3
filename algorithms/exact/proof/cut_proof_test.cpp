#include "algorithms/exact/proof/cut_proof.h"

#include <gtest/gtest.h>

#include "algorithms/common/testing/counted_time.h"
#include "algorithms/exact/proof/hole_cuts.h"
#include "algorithms/exact/proof/outlined_region.h"
#include "algorithms/exact/proof/slit_proof.h"
#include "algorithms/exact/proof/strip_proof.h"
#include "algorithms/exact/testing/region_instances.h"

namespace mwt {
namespace {

using region_instances::Instance;
using region_instances::NaiveEvaluation;

std::size_t triangles_of(const Instance& instance) {
  return instance.local.boundary.size() + 2 * instance.components - 4;
}

// Whether `fill` proves the optimum; whatever it states must be proved by the definition.
template <class Fill>
bool proves_optimum(const Instance& instance, const Fill& fill) {
  DualRegion region = outline_of(instance.local);
  if (!fill(region)) return false;
  const double proved = NaiveEvaluation(instance.local, region, triangles_of(instance)).length();
  EXPECT_LE(region.lower_bound, proved);
  EXPECT_LE(proved, instance.length * (1 + 1e-15));
  return region.lower_bound >= instance.length * (1 - 1e-13);
}

TEST(CutProof, StatesWhatItsDualValuesProve) {
  int proved = 0;
  for (const Instance& instance : region_instances::some(120, 5)) {
    for (const bool is_known : {true, false}) {
      const std::vector<Edge> known = is_known ? instance.optimum : std::vector<Edge>{};
      const bool is_optimal = proves_optimum(instance, [&](DualRegion& region) {
        return add_cut_duals(region, instance.local, instance.components, known, {});
      });
      proved += is_optimal ? 1 : 0;
    }
  }
  EXPECT_GT(proved, 20);
}

// Triangles that cross cuts cost far less than nothing before edges have been balanced.
TEST(CutProof, StatesNoMoreWhereverTheDeadlineStopsIt) {
  for (const Instance& instance : region_instances::some(12, 4)) {
    for (std::int64_t readings = 0; readings < 40; ++readings) {
      const test::CountedTime time;
      const Deadline deadline = test::CountedTime::after(readings);
      proves_optimum(instance, [&](DualRegion& region) {
        return add_cut_duals(region, instance.local, instance.components, instance.optimum, deadline);
      });
    }
  }
}

TEST(StripProof, ProvesEveryOptimumAroundOneHole) {
  for (const Instance& instance : region_instances::some(60, 1)) {
    EXPECT_TRUE(proves_optimum(
        instance, [&](DualRegion& region) { return add_strip_duals(region, instance.local, instance.optimum, {}); }));
    const bool by_tree =
        proves_optimum(instance, [&](DualRegion& region) { return add_strip_duals(region, instance.local, {}, {}); });
    EXPECT_TRUE(by_tree);
  }
}

TEST(SlitProof, ProvesMostOptimaAroundTwoHoles) {
  int proved = 0, tried = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Instance instance = region_instances::make(5 + seed % 12, 2, seed % 2 == 0 ? 1e-6 : .8, seed);
    ++tried;
    const bool is_optimal = proves_optimum(
        instance, [&](DualRegion& region) { return add_slit_duals(region, instance.local, instance.optimum, {}); });
    proved += is_optimal ? 1 : 0;
  }
  EXPECT_GT(proved, tried / 2);
}

TEST(SlitProof, DoesNotProveMoreThanTheOptimum) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Instance instance = region_instances::make(8, 2, .8, seed);
    std::vector<Edge> too_much = instance.optimum;
    too_much.push_back(instance.optimum.front());
    EXPECT_FALSE(proves_optimum(
        instance, [&](DualRegion& region) { return add_slit_duals(region, instance.local, too_much, {}); }));
  }
}

// Every triangulation has one of the cuts, and the point beyond the hole lies in one triangle.
TEST(HoleCuts, AreUnavoidableAndTheRayLeavesOneTriangle) {
  for (const Instance& instance : region_instances::some(40, 1)) {
    const LocalRegion& local = instance.local;
    std::vector<Index> hole;
    std::set<Index> outer;
    for (std::size_t i = 0; i < local.boundary.size(); ++i) {
      const Point& p = local.points[local.boundary[i].a];
      if (std::hypot(p.x, p.y) > .7) outer.insert(local.boundary[i].a);
    }
    for (Index v = 0; v < local.points.size(); ++v) {
      if (!outer.contains(v)) hole.push_back(v);
    }
    std::vector<Edge> open;
    for (std::size_t i = local.boundary.size(); i < local.sides.size(); i += 2) open.push_back(local.sides[i]);
    const HoleCuts cuts(local.points, hole, open);
    EXPECT_TRUE(std::any_of(cuts.edges().begin(), cuts.edges().end(), [&](std::uint32_t cut) {
      return std::binary_search(instance.optimum.begin(), instance.optimum.end(), make_edge(open[cut].a, open[cut].b));
    }));
    const auto triangles = region_triangles(local.points, local.sides, std::numeric_limits<std::size_t>::max(), {});
    int holding = 0;
    for (const auto& [a, b, c] : *triangles) {
      const int sum = cuts.crossing_of_ray(a, b) + cuts.crossing_of_ray(b, c) + cuts.crossing_of_ray(c, a);
      EXPECT_TRUE(sum == 0 || sum == 1);
      holding += sum;
    }
    EXPECT_GT(holding, 0);
    int around = 0;
    for (const Edge& side : local.boundary) around += cuts.crossing_of_ray(side.a, side.b);
    EXPECT_EQ(around, 1);
  }
}

}  // namespace
}  // namespace mwt
