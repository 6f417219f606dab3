#include "generators/random.h"

#include <boost/random/normal_distribution.hpp>
#include <boost/random/uniform_int_distribution.hpp>
#include <boost/random/uniform_real_distribution.hpp>
#include <utility>

#include "generators/unit_circle.h"

namespace mwt {

namespace {

// Fowler-Noll-Vo hash, variant 1a, 64 bits.
std::uint64_t fnv_1a(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

}  // namespace

RandomEngine make_engine(std::string_view family, std::uint64_t seed) {
  return RandomEngine(scatter_bits(fnv_1a(family) ^ scatter_bits(seed)));
}

double uniform_unit(RandomEngine& engine) { return boost::random::uniform_real_distribution<double>(0, 1)(engine); }

std::uint64_t uniform_below(RandomEngine& engine, std::uint64_t count) {
  return boost::random::uniform_int_distribution<std::uint64_t>(0, count - 1)(engine);
}

double standard_normal(RandomEngine& engine) { return boost::random::normal_distribution<double>(0, 1)(engine); }

// Statements of their own: the order in which arguments are evaluated is not fixed by the language.
Point uniform_in_square(RandomEngine& engine) {
  const double x = uniform_unit(engine);
  const double y = uniform_unit(engine);
  return {x, y};
}

Point standard_normal_point(RandomEngine& engine) {
  const double x = standard_normal(engine);
  const double y = standard_normal(engine);
  return {x, y};
}

Point random_direction(RandomEngine& engine) {
  constexpr std::uint64_t kFullTurn = std::uint64_t{1} << 53;
  return unit_circle_point(uniform_below(engine, kFullTurn), kFullTurn);
}

void shuffle(std::vector<Point>& points, RandomEngine& engine) {
  for (std::size_t left = points.size(); left > 1; --left) {
    std::swap(points[left - 1], points[uniform_below(engine, left)]);
  }
}

}  // namespace mwt
