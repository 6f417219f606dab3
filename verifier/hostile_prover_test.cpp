// A prover that tries whatever the format allows, on small sets whose triangulations are all known.
#include <gtest/gtest.h>

#include <limits>

#include "base/testing/test_folder.h"
#include "verifier/diamond.h"
#include "verifier/exact.h"
#include "verifier/reductions.h"
#include "verifier/refused.h"
#include "verifier/testing/damage.h"
#include "verifier/testing/naive_prover.h"
#include "verifier/verify.h"

namespace mwt::verifier {
namespace {

using namespace testing;

// By deciding on one segment after the other.
class AllTriangulations {
 public:
  explicit AllTriangulations(Points points) : points_(points), size_(3 * points.size() - 3 - hull_of(points).size()) {
    for (Index a = 0; a < points.size(); ++a) {
      for (Index b = a + 1; b < points.size(); ++b) {
        const bool is_free = std::none_of(points.begin(), points.end(),
                                          [&](const Point& p) { return is_inside_segment(p, points[a], points[b]); });
        if (is_free) segments_.push_back({a, b});
      }
    }
    decide(0);
  }

  // Those that may be the lightest: sums of the same lengths in another order are compared as equal.
  [[nodiscard]] const std::vector<std::vector<EdgeEnds>>& lightest() const { return lightest_; }
  [[nodiscard]] double weight() const { return upper_double(weight_); }

 private:
  void decide(std::size_t next) {
    if (chosen_.size() == size_) return weigh();
    if (chosen_.size() + segments_.size() - next < size_) return;
    const auto& [a, b] = segments_[next];
    const bool is_crossed = std::any_of(chosen_.begin(), chosen_.end(), [&](const EdgeEnds& edge) {
      return do_cross(points_[a], points_[b], points_[edge[0]], points_[edge[1]]);
    });
    if (!is_crossed) {
      chosen_.push_back(segments_[next]);
      decide(next + 1);
      chosen_.pop_back();
    }
    decide(next + 1);
  }

  void weigh() {
    Bounds sum = 0;
    for (const auto& [a, b] : chosen_) sum += length(points_[a], points_[b]);
    const Bounds margin = scaled(sum, -100);
    if (!lightest_.empty() && sum > weight_ + margin) return;
    if (lightest_.empty() || sum + margin < weight_) {
      lightest_.clear();
      weight_ = sum;
    }
    lightest_.push_back(chosen_);
  }

  Points points_;
  std::size_t size_;
  std::vector<EdgeEnds> segments_, chosen_;
  std::vector<std::vector<EdgeEnds>> lightest_;
  Bounds weight_ = 0;
};

// What reductions() found out, and the steps that it believed.
struct Believed {
  std::vector<EdgeStep> steps;
  EdgeSet candidates, certain;
};

// Every kind of step for random edges in a random order.
Believed try_steps(const std::vector<Point>& points, Dice& dice, const AllTriangulations& all) {
  const PointTree tree(points);
  Reductions reductions(points, tree, diamond_candidates(points, tree), hull_of(points));
  std::vector<EdgeStep> steps;
  const auto any_point = [&] { return static_cast<Index>(dice.below(points.size())); };
  for (int i = 0; i < 500; ++i) {
    const Index a = any_point(), b = any_point(), c = any_point(), d = any_point();
    if (a == b) continue;
    EdgeStep step{1 + dice.below(4), {{a, b}}, {}};
    if (step.tag == 2) step.crossed.push_back({c, d});
    try {
      switch (step.tag) {
        case 1: reductions.remove_not_minimal(a, b); break;
        case 2: reductions.remove_crossing(a, b, c, d); break;
        case 3: reductions.mark_uncrossed(a, b); break;
        default: reductions.mark_beta_skeleton(a, b); break;
      }
    } catch (const Refused&) {
      continue;
    }
    steps.push_back(step);
    for (const auto& edges : all.lightest()) {
      EdgeSet present(points.size());
      for (const auto& [p, q] : edges) {
        present.insert(p, q);
        EXPECT_TRUE(reductions.candidates().contains(p, q)) << "step " << step.tag << ": " << a << " " << b;
      }
      for (Index v = 0; v < points.size(); ++v) {
        for (const Index to : reductions.certain().star(v))
          EXPECT_TRUE(present.contains(v, to)) << "step " << step.tag << ": " << a << " " << b;
      }
    }
  }
  return {steps, reductions.candidates(), reductions.certain()};
}

std::vector<Point> small_set(unsigned seed) {
  return random_points(5 + seed % 4, seed, seed % 4 == 0 ? 0 : 3 + seed % 3);
}

TEST(HostileProver, NoStepLosesALightestTriangulation) {
  std::size_t believed = 0;
  for (unsigned seed = 1; seed <= 200; ++seed) {
    const std::vector<Point> points = small_set(seed);
    if (hull_of(points).empty()) continue;
    SCOPED_TRACE(seed);
    Dice dice(seed);
    believed += try_steps(points, dice, AllTriangulations(points)).steps.size();
    if (HasFailure()) return;
  }
  EXPECT_GT(believed, 5000U);
}

// One region for everything inside the hull: both sides of all certain edges, and all pairs of points that are not
// certain, candidates or not.
RegionStep region_of_everything(const std::vector<Point>& points, const Believed& believed, Dice& dice) {
  RegionStep region{-20, {hull_of(points)}, {}, {}, {}};
  EdgeSet on_hull(points.size());
  const auto& hull = region.walks.front();
  for (std::size_t i = 0; i < hull.size(); ++i) on_hull.insert(hull[i], hull[(i + 1) % hull.size()]);
  for (Index a = 0; a < points.size(); ++a) {
    for (const Index b : believed.certain.star(a)) {
      if (a < b && !on_hull.contains(a, b)) region.walks.push_back({a, b});
    }
  }
  std::size_t first = 0;
  for (const auto& walk : region.walks) first += walk.size();
  for (Index v = 0; v < points.size(); ++v) region.isolated.push_back(v);
  for (Index a = 0; a < points.size(); ++a) {
    for (Index b = a + 1; b < points.size(); ++b) {
      const bool is_open = believed.candidates.contains(a, b) || dice.below(4) == 0;
      if (is_open && !believed.certain.contains(a, b)) region.open_edges.push_back({first + a, first + b});
    }
  }
  return region;
}

// A leaf that changes about half of the dual values.
TreeNode some_changes(const TreeNode& leaf, Dice& dice) {
  TreeNode changes;
  changes.is_changed = true;
  for (std::size_t i = 0; i < leaf.side_duals.size(); ++i) {
    if (dice.below(2) == 0) continue;
    changes.changed_sides.push_back(i);
    changes.side_duals.push_back(leaf.side_duals[i]);
  }
  for (std::size_t i = 0; i < leaf.edge_duals.size(); ++i) {
    if (dice.below(2) == 0) continue;
    changes.changed_edges.push_back(i);
    changes.edge_duals.push_back(leaf.edge_duals[i]);
  }
  return changes;
}

// A leaf, or a decision on an open edge and what follows from either answer, or a base for what is below.
void add_nodes(RegionStep& region, Dice& dice, std::vector<bool> is_in, int depth, bool has_base = false) {
  TreeNode leaf;
  for (const auto& walk : region.walks) leaf.side_duals.resize(leaf.side_duals.size() + walk.size());
  for (std::size_t i = 0; i < region.open_edges.size(); ++i) leaf.edge_duals.emplace_back(is_in[i] ? 2 : 1);
  if (dice.below(4) == 0) {
    region.tree.push_back(leaf);
    region.tree.back().is_base = true;
    has_base = true;
  }
  if (depth > 0 && !region.open_edges.empty() && dice.below(2) == 0) {
    const std::size_t edge = dice.below(region.open_edges.size());
    region.tree.push_back({false, edge, {}, {}});
    is_in[edge] = true;
    add_nodes(region, dice, is_in, depth - 1, has_base);
    is_in[edge] = false;
    add_nodes(region, dice, is_in, depth - 1, has_base);
    return;
  }
  if (has_base && dice.below(4) != 0) leaf = some_changes(leaf, dice);
  region.tree.push_back(leaf);
}

std::vector<std::int64_t*> duals_of(RegionStep& region) {
  std::vector<std::int64_t*> duals;
  for (TreeNode& node : region.tree) {
    for (std::int64_t& dual : node.side_duals) duals.push_back(&dual);
    for (auto& of_edge : node.edge_duals) {
      for (std::int64_t& dual : of_edge) duals.push_back(&dual);
    }
  }
  return duals;
}

// What the verifier believes of a proof that claims nothing; nothing if it refuses.
std::optional<double> proved_lower(const test::TestFolder& folder, const std::vector<Point>& points,
                                   const Proof& proof) {
  write_file(folder.path("proof"), file_of(encode(proof)));
  try {
    return verify(points, folder.path("proof")).lower;
  } catch (const Refused&) {
    return {};
  }
}

// Changes dual values one by one, at random, and keeps what proves more.
TEST(HostileProver, NoDualValuesProveMoreThanTheOptimum) {
  const test::TestFolder folder;
  int tight = 0, proofs = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    const std::vector<Point> points = small_set(seed);
    std::optional<Proof> proof = NaiveProver(points).prove();
    if (!proof) continue;
    SCOPED_TRACE(seed);
    Dice dice(seed);
    const AllTriangulations all(points);
    const Believed believed = try_steps(points, dice, all);
    proof->claimed_lower = 0;
    proof->claimed_upper = std::numeric_limits<double>::infinity();
    proof->steps = believed.steps;
    proof->regions = {region_of_everything(points, believed, dice)};
    RegionStep& region = proof->regions.front();
    add_nodes(region, dice, std::vector<bool>(region.open_edges.size(), false), 2);
    std::optional<double> best = proved_lower(folder, points, *proof);
    if (!best) continue;  // an edge was decided on twice
    ++proofs;
    const std::vector<std::int64_t*> duals = duals_of(region);
    for (int i = 0; i < 300 && !duals.empty(); ++i) {
      std::int64_t& dual = *duals[dice.below(duals.size())];
      const std::int64_t before = dual;
      dual += (dice.below(2) == 0 ? 1 : -1) * (std::int64_t{1} << dice.below(24));
      const std::optional<double> lower = proved_lower(folder, points, *proof);
      ASSERT_LE(lower.value_or(0), all.weight());
      if (lower && *lower >= *best) {
        best = lower;
      } else {
        dual = before;
      }
    }
    if (*best > 0.95 * all.weight()) ++tight;
  }
  EXPECT_GT(proofs, 15);
  EXPECT_GT(tight, 5);
}

}  // namespace
}  // namespace mwt::verifier
