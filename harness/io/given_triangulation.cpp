#include "harness/io/given_triangulation.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "geometry/checker.h"
#include "harness/io/triangulation_file.h"

namespace mwt {

namespace {

// Corners 1 to n and no 0: counted from 1, as other programs do.
bool seem_to_count_from_one(const std::vector<Triangle>& triangles, std::size_t point_count) {
  Index smallest = kNoIndex, largest = 0;
  for (const Triangle& triangle : triangles) {
    const auto [low, high] = std::minmax_element(triangle.begin(), triangle.end());
    smallest = std::min(smallest, *low);
    largest = std::max(largest, *high);
  }
  return smallest == 1 && largest == point_count;
}

// The checker would name the corner only as out of range of the distinct points.
std::optional<std::string> corner_out_of_range(const std::vector<Triangle>& triangles, std::size_t point_count) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index corner : triangles[t]) {
      if (corner < point_count) continue;
      const bool from_one = seem_to_count_from_one(triangles, point_count);
      return fmt::format("{}: triangle {} has corner {}, but points go from 0 to {}{}",
                         name_of(TriangulationRule::indices_in_range), t, corner, point_count - 1,
                         from_one ? "; the corners seem to count from 1: subtract 1 from each" : "");
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> broken_rule(const PointSet& set, const std::vector<Point>& input,
                                       const std::vector<Triangle>& triangles) {
  if (auto complaint = corner_out_of_range(triangles, input.size())) return complaint;
  const auto violation = find_violation(set.points, from_input_indices(set, input, triangles));
  if (!violation) return std::nullopt;
  return violation->message + (set.duplicates() > 0 ? " (points numbered without the duplicates)" : "");
}

Triangulation read_triangulation(const std::string& path, const PointSet& set, const std::vector<Point>& input) {
  const std::vector<Triangle> triangles = read_triangles(path);
  if (const auto rule = broken_rule(set, input, triangles)) {
    throw InputError(path + ": not a triangulation of these points: " + *rule);
  }
  return from_input_indices(set, input, triangles);
}

}  // namespace mwt
