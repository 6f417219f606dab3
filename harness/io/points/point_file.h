// Reading and writing point files; the format follows from the file's ending.
//
//   .txt .xy .csv   a point per line, "x y", "x,y", "x;y" or separated by tabs. `#` starts a comment, quotes around
//                   cells are taken off. The first line may be a header: every cell begins with a letter. If it names x
//                   and y ("x", "x [m]", "POINT_X"), these columns are read, in whatever order, and all others ignored;
//                   if it names one of them only, it is refused. Without such names there are two columns, or three of
//                   which the first is an id: integers counting up by one. JSON and TSPLIB are read here, too.
//   .tsp            TSPLIB: the NODE_COORD_SECTION, or without one the DISPLAY_DATA_SECTION, of points in the plane, in
//                   the order of the file. The coordinates are read as they stand, whatever EDGE_WEIGHT_TYPE is: GEO
//                   degrees, too, become plain x and y. Nodes may have names without blanks.
//   .json           {"points": [{"x": 1, "y": 2}, ...]}, as in the CG:SHOP challenges; other keys are ignored.
//   no ending, -    (`-` is standard input or output) text on writing; on reading, whichever of the three it looks
//                   like.
//
// Text is UTF-8, or UTF-16 with a byte order mark; lines end with LF, CRLF or CR (harness/io/text/text_file.h).
// Endings count in either case; any other is an error.
#pragma once

#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// All points in the order of the file, duplicates included; coordinates are the doubles nearest to the decimals.
/// O(size of the file): about 10^7 points in a second or two.
/// Throws InputError "file:line: what; remedy": unreadable file, a word or a missing column where a number should be,
/// NaN, infinity, a number beyond the doubles, a file without points, a broken format.
[[nodiscard]] std::vector<Point> read_points(const std::string& path);

/// Writes points so that read_points() returns exactly the same ones: shortest round-trip decimals. The file appears
/// complete or not at all (geometry/output_file.h). Throws InputError: cannot be written, unknown ending.
void write_points(const std::string& path, Points points);

}  // namespace mwt
