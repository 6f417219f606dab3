// The parsers behind read_points(), one per format. `source` names the text in messages.
// Each throws InputError "source:line: what; remedy" and returns at least one point otherwise.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// "x y" or "x,y" per line.
[[nodiscard]] std::vector<Point> parse_text_points(const std::string& source, std::string_view text);

/// TSPLIB (G. Reinelt, "TSPLIB - a traveling salesman problem library", ORSA J. Computing 3, 1991).
/// Points of the NODE_COORD_SECTION; without one, those of the DISPLAY_DATA_SECTION.
[[nodiscard]] std::vector<Point> parse_tsplib_points(const std::string& source, std::string_view text);

/// Whether a section of TSPLIB begins before the first line of numbers.
[[nodiscard]] bool looks_like_tsplib(std::string_view text);

/// {"points": [{"x": .., "y": ..}]}.
[[nodiscard]] std::vector<Point> parse_json_points(const std::string& source, std::string_view text);

}  // namespace mwt
