// Points in Gaussian clusters, each with a centre and a covariance of its own.
#pragma once

#include <cstdint>
#include <vector>

#include "generators/generator.h"
#include "geometry/point.h"

namespace mwt {

GeneratorInfo clustered_entry();

enum class ClusterShape {
  elliptic,  ///< a random rotation of a normal distribution whose two standard deviations lie in [.25, 1.75) sigma
  isotropic  ///< standard deviation sigma in every direction
};

/// n distinct points, each from one of `clusters` clusters chosen at random, centres uniform in the unit square, not
/// all collinear. Preconditions: n >= 3, clusters >= 1, sigma > 0. Throws InputError if sigma is so small that doubles
/// carry fewer than n points. Platforms: see standard_normal() in generators/random.h. Expected O(n + clusters) time.
[[nodiscard]] std::vector<Point> clustered_points(Index n, std::uint64_t seed, Index clusters, double sigma,
                                                  ClusterShape shape);

}  // namespace mwt
