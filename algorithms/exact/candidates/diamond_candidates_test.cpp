#include "algorithms/exact/candidates/diamond_candidates.h"
#include "algorithms/exact/search_stopped.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <numbers>

#include "algorithms/common/testing/extreme_points.h"
#include "algorithms/common/testing/solver_testing.h"
#include "algorithms/exact/testing/stage_testing.h"
#include "geometry/numbers/scaling.h"
#include "geometry/predicates.h"

namespace mwt {
namespace {

// Holds differences of doubles, products of two and multiples of these without rounding.
using Exact =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<4400, boost::multiprecision::digit_base_2>>;

using stage_testing::diamond_candidates;
using stage_testing::DiamondCandidates;
using stage_testing::edges_in;
using stage_testing::instances_of_all_families;
using stage_testing::reordered_edges;

// Which sides of an edge have a point in their open diamond triangle, by the definition, in these numbers.
template <class Number>
class Diamonds {
 public:
  Diamonds(const Point& p, const Point& q) : p_(p), x_(difference(q.x, p.x)), y_(difference(q.y, p.y)) {}

  // +1: in the left triangle, -1: in the right one, 0: in none.
  [[nodiscard]] int side_of(const Point& r) const {
    const Number x = difference(r.x, p_.x), y = difference(r.y, p_.y);
    const Number along = x * x_ + y * y_, height = x_ * y - y_ * x, beyond = x_ * x_ + y_ * y_ - along;
    const Number nearer_end = along < beyond ? along : beyond, distance = height < 0 ? Number(-height) : height;
    if (distance >= tangent() * nearer_end) return 0;
    return height > 0 ? 1 : height < 0 ? -1 : 0;
  }

 private:
  static Number difference(double a, double b) { return Number(a) - Number(b); }
  static Number tangent() { return Number(std::tan(std::numbers::pi_v<long double> / 4.6L)); }

  Point p_;
  Number x_, y_;
};

template <class Number>
bool is_excluded(Points points, Index p, Index q) {
  const Diamonds<Number> diamonds(points[p], points[q]);
  bool left = false, right = false;
  for (const Point& r : points) {
    const int side = diamonds.side_of(r);
    left = left || side > 0;
    right = right || side < 0;
    if ((left && right) || in_segment_interior(r, points[p], points[q])) return true;
  }
  return false;
}

void expect_reasons_for_exclusion(Points points, const std::set<Edge>& candidates) {
  for (Index p = 0; p < points.size(); ++p) {
    for (Index q = p + 1; q < points.size(); ++q) {
      if (candidates.contains({p, q})) continue;
      const bool is_missing_for_a_reason = is_excluded<long double>(points, p, q) || is_excluded<Exact>(points, p, q);
      ASSERT_TRUE(is_missing_for_a_reason) << p << ' ' << q;
    }
  }
}

TEST(DiamondCandidates, LeaveOutOnlyWhatTheDiamondTestExcludes) {
  for (const auto& [name, points] : instances_of_all_families({3, 4, 5, 10, 17, 40, 100, 300})) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    expect_reasons_for_exclusion(order.points, edges_in(diamond_candidates(order)));
    if (HasFatalFailure()) return;
  }
}

TEST(DiamondCandidatesSlow, LeaveOutOnlyWhatTheDiamondTestExcludes) {
  for (const auto& [name, points] : instances_of_all_families({50, 250, 600}, 2)) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    expect_reasons_for_exclusion(order.points, edges_in(diamond_candidates(order)));
    if (HasFatalFailure()) return;
  }
}

TEST(DiamondCandidates, HoldAtAllScales) {
  for (const double scale : {0x1p-996, 0x1p-500, 0x1p500, 0x1p996}) {
    std::vector<Point> points = generate("clustered", 300, 1);
    for (Point& p : points) p = {p.x * scale, p.y * scale};
    const KdOrder order = make_kd_order(points);
    expect_reasons_for_exclusion(order.points, edges_in(diamond_candidates(order)));
  }
}

TEST(DiamondCandidates, HoldAtTheLimitsOfFloats) {
  for (std::uint64_t seed = 0; seed < 800; ++seed) {
    SCOPED_TRACE(seed);
    const auto kind = static_cast<test::ExtremePoints::Kind>(seed % test::ExtremePoints::kKinds);
    const std::vector<Point> points = exactly_scaled(test::ExtremePoints(seed).draw(kind, 5 + seed % 20));
    if (points.empty()) continue;
    const KdOrder order = make_kd_order(points);
    expect_reasons_for_exclusion(order.points, edges_in(diamond_candidates(order)));
    if (HasFatalFailure()) return;
  }
}

TEST(DiamondCandidates, ContainTheHull) {
  for (const auto& [name, points] : instances_of_all_families({10, 100, 400})) {
    SCOPED_TRACE(name);
    const KdOrder order = make_kd_order(points);
    const DiamondTest test(order);
    const std::vector<Index> hull = convex_hull(order.points);
    std::vector<Index> possible = test.possible_hull_points(), sorted_hull = hull;
    std::sort(possible.begin(), possible.end());
    std::sort(sorted_hull.begin(), sorted_hull.end());
    EXPECT_TRUE(std::includes(possible.begin(), possible.end(), sorted_hull.begin(), sorted_hull.end()));
    const std::set<Edge> candidates = edges_in(diamond_candidates(order));
    for (std::size_t i = 0; i < hull.size(); ++i) {
      EXPECT_TRUE(candidates.contains(make_edge(hull[i], hull[(i + 1) % hull.size()])));
    }
  }
}

void expect_optimum_among_candidates(Points points) {
  const KdOrder order = make_kd_order(points);
  const std::set<Edge> candidates = edges_in(diamond_candidates(order));
  const Triangulation optimum = solve_to_optimality("triangle_lp", points).triangulation;
  for (const Edge& edge : reordered_edges(order, optimum)) EXPECT_TRUE(candidates.contains(edge));
}

TEST(DiamondCandidates, ContainEveryOptimum) {
  for (const auto& [name, points] : instances_of_all_families({10, 30})) {
    SCOPED_TRACE(name);
    expect_optimum_among_candidates(points);
  }
}

TEST(DiamondCandidatesSlow, ContainEveryOptimum) {
  for (const auto& [name, points] : instances_of_all_families({60})) {
    SCOPED_TRACE(name);
    expect_optimum_among_candidates(points);
  }
}

// Far points next to a dense cluster, and a hollow: where the near points of a leaf say little.
TEST(DiamondCandidates, HoldWhereDensityJumps) {
  std::vector<Point> points = generate("uniform", 200, 1);
  for (Point& p : points) p = {1e-9 * p.x, 1e-9 * p.y};
  const std::vector<Point> ring = generate("circle", 150, 1);
  points.insert(points.end(), ring.begin(), ring.end());
  const std::vector<Point> around = generate("normal", 150, 2);
  for (const Point& p : around) points.push_back({1e6 * p.x, 1e6 * p.y});
  const KdOrder order = make_kd_order(points);
  expect_reasons_for_exclusion(order.points, edges_in(diamond_candidates(order)));
}

TEST(DiamondCandidates, AreFewOnUniformPoints) {
  const KdOrder order = make_kd_order(generate("uniform", 20'000, 1));
  const double per_point = static_cast<double>(edges_in(diamond_candidates(order)).size()) / 20'000;
  EXPECT_GT(per_point, 10);
  EXPECT_LT(per_point, 13);
}

// Floats do not tell on which side of an edge the points between its ends lie.
TEST(DiamondCandidates, AreFewOnNearlyCollinearPoints) {
  const KdOrder order = make_kd_order(generate("near_collinear", 1000, 1));
  EXPECT_LT(edges_in(diamond_candidates(order)).size(), 8'000);
}

TEST(DiamondCandidates, AreFiledByBlocks) {
  const KdOrder order = make_kd_order(generate("uniform", 20'000, 2));
  const DiamondCandidates candidates = diamond_candidates(order);
  const PointBlocks blocks(order);
  ASSERT_GT(blocks.count(), 4U);
  for (std::uint32_t block = 0; block < blocks.count(); ++block) {
    const Index first = order.first_of(blocks.node_of(block)), last = order.last_of(blocks.node_of(block));
    EXPECT_EQ(blocks.block_of(first), block);
    EXPECT_EQ(blocks.block_of(last - 1), block);
    for (const auto& [p, q] : candidates.inner[block]) EXPECT_TRUE(first <= p && p < q && q < last);
    for (const auto& [p, q] : candidates.outer[block]) EXPECT_TRUE(first <= p && p < last && last <= q);
  }
}

TEST(DiamondCandidates, DoNotDependOnThreads) {
  const KdOrder order = make_kd_order(generate("clustered", 20'000, 3));
  const DiamondCandidates one = diamond_candidates(order);
  tbb::task_arena arena(3);
  const DiamondCandidates three = arena.execute([&] { return diamond_candidates(order); });
  const auto is_same = [](const CandidatePair& a, const CandidatePair& b) { return a.p == b.p && a.q == b.q; };
  for (std::uint32_t block = 0; block < one.inner.size(); ++block) {
    for (const auto lists : {&DiamondCandidates::inner, &DiamondCandidates::outer}) {
      const auto& a = (one.*lists)[block];
      const auto& b = (three.*lists)[block];
      EXPECT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end(), is_same)) << block;
    }
  }
}

TEST(DiamondCandidates, StopAtTheDeadline) {
  const KdOrder order = make_kd_order(generate("uniform", 5000, 1));
  Context context;
  context.deadline = Context::Clock::now() - std::chrono::seconds(1);
  DiamondTest test(order);
  ASSERT_GT(test.blocks().count(), 1U);
  std::vector<CandidatePair> found;
  EXPECT_THROW((void)test.find_outer(context), SearchStopped);
  EXPECT_THROW(test.take_inner(0, context, found), SearchStopped);
}

}  // namespace
}  // namespace mwt
