// Proves the figures of direction_bins.h, in long double.
#include "algorithms/exact/candidates/direction_bins.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mwt {
namespace {

using Real = long double;

constexpr Real kPi = std::numbers::pi_v<Real>;
constexpr Real kOctant = kPi / 4;

// The angle in [0, pi / 4] at which the bin function reaches bin position f in [0, kBinsPerOctant]: the inverse of
// f = kBinsPerOctant t (kBinSlope - kBinCurve t), t = tan(angle).
Real octant_angle(Real position) {
  const Real slope = kBinSlope, curve = kBinCurve, share = position / kBinsPerOctant;
  return std::atan((slope - std::sqrt(slope * slope - 4 * curve * share)) / (2 * curve));
}

// The same on the whole circle: octants are mirror images of their neighbours, as in the kernels.
Real angle_at(Real position) {
  const int octant = static_cast<int>(std::floor(position / kBinsPerOctant));
  const Real within = position - static_cast<Real>(octant) * kBinsPerOctant;
  const bool is_mirrored = octant % 2 != 0;
  const Real angle = octant_angle(is_mirrored ? kBinsPerOctant - within : within);
  return kOctant * static_cast<Real>(octant + (is_mirrored ? 1 : 0)) + (is_mirrored ? -angle : angle);
}

// What a bin's border may be off: the last octant's end is kBinSlope - kBinCurve instead of 1, and floats round.
constexpr Real kBorderError = 1e-6L;

Real widest_span(int bins) {
  Real widest = 0;
  for (int first = 0; first < kDirectionBins; ++first) {
    widest = std::max(widest, angle_at(static_cast<Real>(first + bins)) - angle_at(static_cast<Real>(first)));
  }
  return widest;
}

TEST(DirectionBins, FillTheCircle) {
  EXPECT_EQ(kDirectionBins, 8 * kBinsPerOctant);
  EXPECT_NEAR(static_cast<double>(octant_angle(kBinsPerOctant)), static_cast<double>(kOctant), 1e-6)
      << "the bin function reaches the octant's end";
  for (int i = 0; i < 100 * kDirectionBins; ++i) {
    const Real position = static_cast<Real>(i) / 100;
    EXPECT_LT(angle_at(position), angle_at(position + 0.01L)) << "at " << i;
  }
  EXPECT_NEAR(static_cast<double>(angle_at(kDirectionBins)), static_cast<double>(2 * kPi), 1e-6);
}

TEST(DirectionBins, HaveOppositeBinsOppositeEachOther) {
  for (int bin = 0; bin < kDirectionBins / 2; ++bin) {
    const Real here = angle_at(static_cast<Real>(bin)), there = angle_at(static_cast<Real>(bin + kDirectionBins / 2));
    EXPECT_NEAR(static_cast<double>(there - here), static_cast<double>(kPi), 1e-12) << bin;
  }
}

TEST(DirectionBins, SpanLessThanTheDiamondAngleBySixes) {
  const Real guard = 2 * kBorderError;
  EXPECT_LT(widest_span(kBlockingBins + 1) + guard, static_cast<Real>(kDiamondAngle));
  EXPECT_NEAR(static_cast<double>(widest_span(kBlockingBins + 1)), 0.677, 1e-3);
  EXPECT_GT(widest_span(kBlockingBins + 2), static_cast<Real>(kDiamondAngle)) << "a seventh would be too much";
}

TEST(DirectionBins, NameTheDiamondAngle) {
  EXPECT_NEAR(kDiamondAngle, static_cast<double>(kPi / 4.6L), 1e-15);
  const Real tangent = std::tan(kPi / 4.6L);
  EXPECT_LT(static_cast<Real>(kTangentOfDiamondAngle), tangent);
  EXPECT_LT(static_cast<Real>(static_cast<float>(kTangentOfDiamondAngle)), tangent) << "as the float the kernels use";
  EXPECT_GT(kTangentOfDiamondAngle, static_cast<double>(tangent) - 1e-5);
}

// A point at distance r, an angle d beside the edge, is in the triangle beyond r sin(d + a) / sin(a); that grows with
// d.
TEST(DirectionBins, HaveBlockingFactorsThatCoverTheWidestSpan) {
  const Real a = kPi / 4.6L;
  Real smaller = 0;
  for (int bins = 1; bins <= kBlockingBins; ++bins) {
    const Real span = widest_span(bins + 1) + 2 * kBorderError;
    ASSERT_LT(span + a, kPi / 2) << "the sine grows up to here";
    const Real exact = std::sin(span + a) / std::sin(a);
    const auto factor = static_cast<Real>(kBlockingFactor[static_cast<std::size_t>(bins)]);
    EXPECT_GE(factor, exact * (1 + 2e-5L)) << bins << ": covers the rounding of floats as well";
    EXPECT_LE(factor, exact * (1 + 4e-4L)) << bins << ": no larger than need be";
    EXPECT_GT(factor, smaller) << bins;
    smaller = factor;
  }
}

// By trying: every direction, and a point at each bin distance, is inside the triangle of an edge just longer than the
// factor says.
TEST(DirectionBins, BlockEdgesBeyondTheFactor) {
  const Real tangent = std::tan(kPi / 4.6L);
  constexpr int kSteps = 20;
  for (int bin = 0; bin < kDirectionBins; ++bin) {
    for (int away = 1; away <= kBlockingBins; ++away) {
      const Real length = kBlockingFactor[static_cast<std::size_t>(away)];
      for (int i = 0; i <= kSteps; ++i) {
        for (int k = 1; k < kSteps; ++k) {
          const Real edge = angle_at(static_cast<Real>(bin) + static_cast<Real>(i) / kSteps);
          const Real point = angle_at(static_cast<Real>(bin + away) + static_cast<Real>(k) / kSteps);
          const Real along = std::cos(point - edge), height = std::sin(point - edge);
          EXPECT_GT(height, 0);
          EXPECT_LT(height, tangent * along) << bin << ' ' << away;
          EXPECT_LT(height, tangent * (length - along)) << bin << ' ' << away;
        }
      }
    }
  }
}

TEST(DirectionBins, AreTurnedByAUnitVector) {
  const Real cosine = kBinTurnCosine, sine = kBinTurnSine;
  EXPECT_NEAR(static_cast<double>(std::hypot(cosine, sine)), 1, 1e-6);
  // The directions that lattices prefer, turned, stay clear of the bins' borders.
  const Real turn = std::atan2(sine, cosine);
  for (const auto& [x, y] : {std::pair<Real, Real>{1, 0}, {1, 1}, {2, 1}, {3, 1}, {3, 2}}) {
    const Real angle = std::atan2(y, x) + turn;
    for (int bin = 0; bin <= 2 * kBinsPerOctant; ++bin) {
      EXPECT_GT(std::abs(angle - angle_at(static_cast<Real>(bin))), 1e-3L) << x << ' ' << y << ' ' << bin;
    }
  }
}

}  // namespace
}  // namespace mwt
