// Reading and writing point files.
//
//   .txt .xy .csv .tsv  a point per line, "x y", "x,y", "x;y" or separated by tabs. `#` starts a comment, quotes around
//                   cells are taken off. The first line may be a header: every cell begins with a letter. If it names x
//                   and y ("x", "x [m]", "POINT_X"), these columns are read, in whatever order, and all others ignored;
//                   if it names one of them only, it is refused. Without such names there are two columns, or three of
//                   which the first is an id: integers counting up by one. Or the caller names the columns.
//   .tsp            TSPLIB: the NODE_COORD_SECTION, or without one the DISPLAY_DATA_SECTION, of points in the plane, in
//                   the order of the file. The coordinates are read as they stand, whatever EDGE_WEIGHT_TYPE is: GEO
//                   degrees, too, become plain x and y. Nodes may have names without blanks.
//   .json .geojson  {"points": [{"x": 1, "y": 2}, ...]} or {"points": [[1, 2], ...]}, or the list alone; {"points_x":
//                   [1, ...], "points_y": [2, ...]} or "x" and "y", as in the CG:SHOP challenges; GeoJSON of points.
//                   Other keys are ignored.
//   .wkt            POINT and MULTIPOINT of well-known text, any number of them.
//   .off .ply .node the vertices of a mesh, all of one z: Geomview's OFF, Stanford's PLY (text and binary), Triangle's
//                   vertices.
//   .npy            NumPy: an array of floats or integers, n rows of two.
//   no ending, -    (`-` is standard input or output) text on writing; on reading, whatever of these but .node it looks
//                   like, as in files with the endings in the first line.
//
// Files compressed by gzip, bzip2, xz or zstd are read as what is in them (harness/io/compression.h).
// Text is UTF-8, or UTF-16 with a byte order mark; lines end with LF, CRLF or CR (harness/io/text/text_file.h).
// Endings count in either case; any other is an error.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// Which columns of a table are x and y: names in its header, in either case, or places from 1.
struct ColumnNames {
  std::string x;
  std::string y;
};

/// From "lon,lat" or "3,4". Throws InputError.
[[nodiscard]] ColumnNames parse_column_names(const std::string& text);

/// All points in the order of the file, duplicates included; coordinates are the doubles nearest to the decimals.
/// O(size of the file): about 10^7 points in a second or two.
/// Throws InputError "file:line: what; remedy": unreadable file, a word or a missing column where a number should be,
/// NaN, infinity, a number beyond the doubles, a file without points, a broken format.
/// `columns` are for tables of text; other formats ignore them.
[[nodiscard]] std::vector<Point> read_points(const std::string& path, const std::optional<ColumnNames>& columns = {});

/// Throws InputError unless the ending is that of a format in which points are written.
void require_writable_points(const std::string& path);

/// Writes points so that read_points() returns exactly the same ones: shortest round-trip decimals. The file appears
/// complete or not at all (geometry/output_file.h). Throws InputError: cannot be written, unknown ending.
void write_points(const std::string& path, Points points);

}  // namespace mwt
