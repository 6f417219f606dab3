// Random numbers that are the same on every platform: what all families draw from.
//
// Every family runs its own stream of the Mersenne twister (Boost.Random's mt19937_64), started from a hash of its name
// and the seed, so that families with the same seed share nothing. Which numbers come out depends only on integer
// arithmetic and on +, -, *, / of doubles (rounded once each: the build sets -ffp-contract=off), with one exception:
// Boost's normal_distribution, which standard_normal() uses, compares a draw with std::exp() to accept or reject it.
// The values themselves never come from std::exp(), so another library's last bit could only matter if it lay exactly
// between the two sides of a comparison (about one draw in 10^16).
#pragma once

#include <boost/random/mersenne_twister.hpp>
#include <cstdint>
#include <string_view>
#include <vector>

#include "geometry/point.h"

namespace mwt {

using RandomEngine = boost::random::mt19937_64;

/// splitmix64's finaliser, a bijection that scatters every bit.
/// G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
[[nodiscard]] constexpr std::uint64_t scatter_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// The engine of a family: seeded with scatter_bits(FNV-1a(family) ^ scatter_bits(seed)).
[[nodiscard]] RandomEngine make_engine(std::string_view family, std::uint64_t seed);

/// Uniform in [0, 1).
[[nodiscard]] double uniform_unit(RandomEngine& engine);

/// Uniform among 0 .. count - 1. Precondition: count >= 1.
[[nodiscard]] std::uint64_t uniform_below(RandomEngine& engine, std::uint64_t count);

/// Normal with mean 0 and standard deviation 1.
[[nodiscard]] double standard_normal(RandomEngine& engine);

/// Uniform in the unit square [0, 1) x [0, 1).
[[nodiscard]] Point uniform_in_square(RandomEngine& engine);

/// Both coordinates standard normal, independent.
[[nodiscard]] Point standard_normal_point(RandomEngine& engine);

/// Uniform on the unit circle.
[[nodiscard]] Point random_direction(RandomEngine& engine);

/// All orders are equally likely. O(n).
void shuffle(std::vector<Point>& points, RandomEngine& engine);

}  // namespace mwt
