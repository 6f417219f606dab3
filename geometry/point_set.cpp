#include "geometry/point_set.h"

#include <fmt/core.h>
#include <openssl/evp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "base/error.h"
#include "geometry/convex_hull.h"
#include "geometry/numbers/trusted_range.h"

namespace mwt {

namespace {

void require_usable_coordinates(const std::vector<Point>& input, const std::string& source) {
  for (std::size_t i = 0; i < input.size(); ++i) {
    const double size = std::max(std::abs(input[i].x), std::abs(input[i].y));
    if (!std::isfinite(input[i].x) || !std::isfinite(input[i].y)) {
      throw InputError(fmt::format("{}: point {} has a coordinate that is not finite", source, i));
    }
    if (size > kMaxCoordinate) {
      throw InputError(fmt::format(
          "{}: point {} has a coordinate beyond 1e300, where sums of lengths overflow; scale the points down", source,
          i));
    }
  }
}

// Whether each point is the first of its kind.
std::vector<bool> first_occurrences(Points points) {
  const std::vector<Index> order = lexicographic_order(points);
  std::vector<bool> first(points.size(), true);
  for (std::size_t i = 1; i < order.size(); ++i) {
    if (points[order[i]] == points[order[i - 1]]) first[order[i]] = false;
  }
  return first;
}

void append_little_endian(std::vector<unsigned char>& bytes, double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int shift = 0; shift < 64; shift += 8) bytes.push_back(static_cast<unsigned char>(bits >> shift));
}

}  // namespace

PointSet make_point_set(const std::vector<Point>& input, const std::string& source) {
  require_usable_coordinates(input, source);
  PointSet set;
  set.input_count = static_cast<Index>(input.size());
  const std::vector<bool> first = first_occurrences(input);
  for (Index i = 0; i < input.size(); ++i) {
    if (!first[i]) continue;
    set.points.push_back({input[i].x + 0.0, input[i].y + 0.0});  // -0 + 0 = 0: one zero only
    set.input_indices.push_back(i);
  }
  if (set.points.size() < 3) {
    throw InputError(
        fmt::format("{}: {} distinct points; a triangulation needs at least 3", source, set.points.size()));
  }
  if (all_collinear(set.points)) {
    throw InputError(source + ": all points lie on one line; a triangulation needs a point off it");
  }
  return set;
}

std::array<unsigned char, 32> content_hash(Points points) {
  std::vector<unsigned char> bytes;
  bytes.reserve(16 * points.size());
  for (const Point& p : points) {
    append_little_endian(bytes, p.x);
    append_little_endian(bytes, p.y);
  }
  std::array<unsigned char, 32> hash{};
  if (EVP_Digest(bytes.data(), bytes.size(), hash.data(), nullptr, EVP_sha256(), nullptr) != 1) {
    throw std::runtime_error("SHA-256 is not available");
  }
  return hash;
}

std::string instance_id(Points points) {
  const std::array<unsigned char, 32> hash = content_hash(points);
  std::string text;
  for (std::size_t i = 0; i < 16; ++i) fmt::format_to(std::back_inserter(text), "{:02x}", hash[i]);
  return text;
}

std::vector<Triangle> to_input_indices(const PointSet& set, const std::vector<Triangle>& triangles) {
  std::vector<Triangle> result = triangles;
  for (Triangle& triangle : result) {
    for (Index& corner : triangle) corner = set.input_indices[corner];
  }
  return result;
}

Triangulation from_input_indices(const PointSet& set, const std::vector<Point>& input,
                                 const std::vector<Triangle>& triangles) {
  const std::vector<Index> kept_order = lexicographic_order(set.points);
  const auto position_in_set = [&](Index corner) -> Index {
    if (corner >= input.size()) return kNoIndex;
    const auto place =
        std::lower_bound(kept_order.begin(), kept_order.end(), input[corner],
                         [&](Index i, const Point& p) { return lexicographically_less(set.points[i], p); });
    return *place;  // every input point equals a kept one
  };
  Triangulation result{static_cast<Index>(set.points.size()), triangles};
  for (Triangle& triangle : result.triangles) {
    for (Index& corner : triangle) corner = position_in_set(corner);
  }
  return result;
}

}  // namespace mwt
