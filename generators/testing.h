// What the tests of the families share.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "generators/registry.h"
#include "geometry/convex_hull.h"
#include "geometry/point_set.h"
#include "geometry/predicates.h"

namespace mwt {

/// Content hash of an instance, duplicates removed. Tests compare it with a recorded one: a difference means that the
/// family gives other points than it used to, so that results are no longer comparable with older ones.
inline std::string golden_hash(const std::string& family, Index n, std::uint64_t seed,
                               const std::map<std::string, std::string>& parameters = {}) {
  return instance_id(make_point_set(generate(family, n, seed, parameters), family).points);
}

/// The message with which a family refuses, empty if it does not.
inline std::string refusal(const std::string& family, Index n,
                           const std::map<std::string, std::string>& parameters = {}) {
  try {
    (void)generate(family, n, 1, parameters);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// Whether every three consecutive points of the open chain make a turn of that sign.
inline bool turns_everywhere(const std::vector<Point>& chain, int sign) {
  for (std::size_t i = 2; i < chain.size(); ++i) {
    if (orientation(chain[i - 2], chain[i - 1], chain[i]) != sign) return false;
  }
  return true;
}

/// Whether no two points are the same and each of them is a corner of the convex hull.
inline bool is_in_strictly_convex_position(const std::vector<Point>& points) {
  std::vector<Point> cycle;
  for (const Index i : convex_hull(points)) cycle.push_back(points[i]);
  if (cycle.size() != points.size()) return false;
  cycle.insert(cycle.end(), {cycle[0], cycle[1]});
  return turns_everywhere(cycle, 1);
}

}  // namespace mwt
