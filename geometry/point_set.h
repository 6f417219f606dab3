// An instance: the distinct points that algorithms see, and how they relate to what the user gave.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// At least 3 distinct points, not all collinear, in input order.
struct PointSet {
  std::vector<Point> points;         ///< distinct; of equal ones (-0 = 0) the first is kept
  std::vector<Index> input_indices;  ///< for each of `points`, its position in the input
  Index input_count = 0;

  [[nodiscard]] Index duplicates() const { return input_count - static_cast<Index>(points.size()); }
};

/// Removes duplicates and checks what every algorithm relies on. `source` names the input in messages.
/// Throws InputError: fewer than 3 distinct points, all collinear, not finite, or magnitude above 1e300 (sums of
/// lengths would overflow). O(n log n).
[[nodiscard]] PointSet make_point_set(const std::vector<Point>& input, const std::string& source);

/// The SHA-256 of the distinct points in input order: of their little-endian coordinates x0 y0 x1 y1 ... The same on
/// every platform.
[[nodiscard]] std::array<unsigned char, 32> content_hash(Points points);

/// The first 128 bits of the content hash, as 32 hexadecimal digits.
[[nodiscard]] std::string instance_id(Points points);

/// Corners of a triangulation of set.points as positions in the input, and back.
[[nodiscard]] std::vector<Triangle> to_input_indices(const PointSet& set, const std::vector<Triangle>& triangles);
/// A corner that is no kept input point becomes kNoIndex, which the checker reports as out of range.
/// Corners at duplicates go to the kept point.
[[nodiscard]] Triangulation from_input_indices(const PointSet& set, const std::vector<Point>& input,
                                               const std::vector<Triangle>& triangles);

}  // namespace mwt
