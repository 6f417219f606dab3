// Algorithms that start from a triangulation can be given one as a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "geometry/point_set.h"

namespace mwt {

/// The file that the parameter `start` names: its value when it is declared as text and the value is not one of the
/// declared choices.
[[nodiscard]] std::optional<std::string> start_file_of(const AlgorithmInfo& algorithm, const Parameters& parameters);

/// Reads a triangulation of `set` whose corners are positions in `input`, and checks it.
/// Throws InputError: unreadable file, or not a triangulation of the points (naming the broken rule).
[[nodiscard]] Triangulation read_start(const std::string& path, const PointSet& set, const std::vector<Point>& input);

}  // namespace mwt
