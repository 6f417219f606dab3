// Points from the content of a file that the page has opened.
#pragma once

#include <string>
#include <vector>

#include "geometry/point.h"

namespace mwt {

/// The points of a file of that name with that content; its ending is the format. Goes through a temporary file,
/// removed in the end. Throws as read_points(), naming the file as given.
[[nodiscard]] std::vector<Point> read_content(const std::string& name, const std::string& content);

}  // namespace mwt
