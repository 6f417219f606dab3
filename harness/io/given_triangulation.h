// Triangulations that a user gives as a file: corners are positions in the point file, and everything is
// checked.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/point_set.h"
#include "harness/io/solution_file.h"

namespace mwt {

/// The first rule that the triangles, or those that the edges bound, break as a triangulation of `set`; nothing if they
/// are one. Corners are positions in `input`. One line; a corner out of range is named as the solution has it. O(n log
/// n).
[[nodiscard]] std::optional<std::string> broken_rule(const PointSet& set, const std::vector<Point>& input,
                                                     const GivenSolution& solution);

/// Reads a triangulation of `set` whose corners are positions in `input`, and checks it.
/// Throws InputError: unreadable file, or not a triangulation of the points (naming the broken rule).
[[nodiscard]] Triangulation read_triangulation(const std::string& path, const PointSet& set,
                                               const std::vector<Point>& input);

}  // namespace mwt
