#include "harness/start_triangulation.h"

#include <algorithm>

#include "geometry/checker.h"
#include "geometry/error.h"
#include "geometry/triangulation_file.h"

namespace mwt {

std::optional<std::string> start_file_of(const AlgorithmInfo& algorithm, const Parameters& parameters) {
  for (const ParameterInfo& info : algorithm.parameters) {
    if (info.name != "start" || info.type != ParameterType::text) continue;
    const std::string& value = parameters.text(info.name);
    const bool is_named_start = std::find(info.choices.begin(), info.choices.end(), value) != info.choices.end();
    if (!is_named_start) return value;
  }
  return std::nullopt;
}

Triangulation read_start(const std::string& path, const PointSet& set, const std::vector<Point>& input) {
  Triangulation start = from_input_indices(set, input, read_triangles(path));
  if (const auto violation = find_violation(set.points, start)) {
    throw InputError(path + ": not a triangulation of these points: " + violation->message);
  }
  return start;
}

}  // namespace mwt
