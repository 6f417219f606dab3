#include "generators/generation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>

#include "base/error.h"
#include "generators/arguments.h"

namespace mwt {

namespace {

[[noreturn]] void fail(const GeneratorInfo& family, Index n, std::uint64_t seed, const std::string& what) {
  throw GeneratorFailure(
      fmt::format("generator {}: {} for n={} seed={}; its function is wrong", family.name, what, n, seed));
}

bool is_finite(const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool has_equal_points(std::vector<Point> points) {
  const auto by_coordinates = [](const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::sort(points.begin(), points.end(), by_coordinates);
  return std::adjacent_find(points.begin(), points.end()) != points.end();
}

std::vector<Point> call(const GeneratorInfo& family, Index n, std::uint64_t seed, const Parameters& parameters) {
  try {
    return family.function(n, seed, parameters);
  } catch (const InputError&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& failure) {
    fail(family, n, seed, failure.what());
  }
}

}  // namespace

std::vector<Point> generate_verified(const GeneratorInfo& family, Index n, std::uint64_t seed,
                                     const Parameters& parameters) {
  const Index largest = family.max_n == 0 ? kMaxPoints : family.max_n;
  require_size(family.name, n, family.min_n, largest);
  std::vector<Point> points = call(family, n, seed, parameters);
  if (points.size() != n) fail(family, n, seed, fmt::format("returned {} points", points.size()));
  if (!std::all_of(points.begin(), points.end(), is_finite))
    fail(family, n, seed, "returned points that are not finite");
  if (!family.repeats_points && has_equal_points(points)) fail(family, n, seed, "returned equal points");
  return points;
}

}  // namespace mwt
