// Reading and writing triangle lists and edge lists: CSV with the header "a,b,c" or "a,b".
//
// Corners are 0-based positions in the point file. Readers take the same texts as for points
// (harness/io/text/text_table.h), also without a header. Further columns, such as a triangle's perimeter, are ignored
// when a header names them. If the header names none of a, b (and c), the first columns are taken, unless they are
// called id or the like; if it names some of them only, it is refused.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// The triangles in the order of the file, corners as given, valid or not: geometry/checker.h checks them.
/// `-` is standard input. Throws InputError "file:line: what; remedy": unreadable, not an index, too few columns, too
/// many without a header, no triangle at all. O(size of the file).
[[nodiscard]] std::vector<Triangle> read_triangles(const std::string& path);

/// The edges in the order of the file, each with its smaller end first. Otherwise as above.
[[nodiscard]] std::vector<Edge> read_edges(const std::string& path);

/// The same of a text that has been read; `source` names it in messages.
[[nodiscard]] std::vector<Triangle> parse_triangles(const std::string& source, std::string_view text);
[[nodiscard]] std::vector<Edge> parse_edges(const std::string& source, std::string_view text);

/// Throws InputError if the name's ending promises another kind of file, such as .json.
void require_table_name(const std::string& path);

/// The file appears complete or not at all (geometry/output_file.h); `-` is standard output. Throws InputError
/// if it cannot be written, and as require_table_name() does.
void write_triangles(const std::string& path, std::span<const Triangle> triangles);
void write_edges(const std::string& path, std::span<const Edge> edges);

}  // namespace mwt
