// Reading and writing triangle lists and edge lists: CSV with the header "a,b,c" or "a,b".
//
// Corners are 0-based positions in the point file. Readers also take blanks or semicolons between columns, `#` comments
// and lists without a header. Further columns, such as a triangle's perimeter, are ignored when a header names them; if
// the header has no columns a, b (and c), the first ones are taken.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// The triangles in the order of the file, corners as given: whether they are valid is for geometry/checker.h to say.
/// `-` is standard input. Throws InputError "file:line: what; remedy": unreadable, not an index, too few columns, too
/// many without a header, no triangle at all. O(size of the file).
[[nodiscard]] std::vector<Triangle> read_triangles(const std::string& path);

/// The edges in the order of the file, each with its smaller end first. Otherwise as above.
[[nodiscard]] std::vector<Edge> read_edges(const std::string& path);

/// The file appears complete or not at all (geometry/output_file.h); `-` is standard output. Throws InputError.
void write_triangles(const std::string& path, std::span<const Triangle> triangles);
void write_edges(const std::string& path, std::span<const Edge> edges);

}  // namespace mwt
