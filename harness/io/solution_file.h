// Triangulations in the files of other programs: triangles or edges, in several formats, counted from 0 or 1.
#pragma once

#include <string>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// What such a file has: triangles or edges. Corners are positions in the point file, from 0.
struct GivenSolution {
  std::vector<Triangle> triangles;
  std::vector<Edge> edges;
  bool counts_from_one = false;  ///< in the file: its corners are 1 to the number of points
};

/// Reads, by content and ending:
///   - tables of three or two columns, or of columns a, b (and c) (triangulation_file.h);
///   - JSON: {"triangles": [[0, 1, 2], ...]}, {"edges": [[0, 1], ...]}, {"edges": [{"i": 0, "j": 1}, ...]}, or the list
///   alone;
///   - .ele: triangles of the program Triangle.
/// Compressed files, too (compression.h). Corners may be out of range. Throws InputError naming the file, the place and
/// the remedy.
[[nodiscard]] GivenSolution read_solution(const std::string& path, std::size_t point_count);

}  // namespace mwt
