// Triangulations that a user gives as a file: corners are positions in the point file, and everything is
// checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/point_set.h"

namespace mwt {

/// The first rule that `triangles`, whose corners are positions in `input`, break as a triangulation of `set`; nothing
/// if they are one. One line; a corner out of range is named as the file has it, with the remedy if the corners seem to
/// be numbered from 1. O(n log n).
[[nodiscard]] std::optional<std::string> broken_rule(const PointSet& set, const std::vector<Point>& input,
                                                     const std::vector<Triangle>& triangles);

/// Reads a triangulation of `set` whose corners are positions in `input`, and checks it.
/// Throws InputError: unreadable file, or not a triangulation of the points (naming the broken rule).
[[nodiscard]] Triangulation read_triangulation(const std::string& path, const PointSet& set,
                                               const std::vector<Point>& input);

}  // namespace mwt
