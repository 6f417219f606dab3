// The parsers behind read_points(), one per format. `source` names the text in messages.
// Each throws InputError "source:line: what; remedy" and returns at least one point otherwise.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "harness/io/points/point_file.h"

namespace mwt {

/// "x y" or "x,y" per line, or the columns of these names.
[[nodiscard]] std::vector<Point> parse_text_points(const std::string& source, std::string_view text,
                                                   const std::optional<ColumnNames>& names = {});

/// TSPLIB (G. Reinelt, "TSPLIB - a traveling salesman problem library", ORSA J. Computing 3, 1991).
/// Points of the NODE_COORD_SECTION; without one, those of the DISPLAY_DATA_SECTION.
[[nodiscard]] std::vector<Point> parse_tsplib_points(const std::string& source, std::string_view text);

/// Whether a section of TSPLIB begins before the first line of numbers.
[[nodiscard]] bool looks_like_tsplib(std::string_view text);

/// Lists of points or of coordinates, and GeoJSON: point_file.h names the forms.
[[nodiscard]] std::vector<Point> parse_json_points(const std::string& source, std::string_view text);

/// POINT and MULTIPOINT of well-known text.
[[nodiscard]] std::vector<Point> parse_wkt_points(const std::string& source, std::string_view text);
[[nodiscard]] bool looks_like_wkt(std::string_view text);

/// Vertices of meshes: OFF, PLY (also binary: `content` as it is in the file), and Triangle's .node files. InputError
/// also if their z coordinates differ.
[[nodiscard]] std::vector<Point> parse_off_points(const std::string& source, std::string_view text);
[[nodiscard]] std::vector<Point> parse_ply_points(const std::string& source, std::string_view content);
[[nodiscard]] std::vector<Point> parse_node_points(const std::string& source, std::string_view text);

/// NumPy's .npy, an array of shape (n, 2): `content` as it is in the file.
[[nodiscard]] std::vector<Point> parse_npy_points(const std::string& source, std::string_view content);
[[nodiscard]] bool looks_like_npy(std::string_view content);

}  // namespace mwt
