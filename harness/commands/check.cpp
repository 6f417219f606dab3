#include <iostream>
#include <memory>

#include "geometry/checker.h"
#include "geometry/point_file.h"
#include "geometry/point_set.h"
#include "geometry/triangulation_file.h"
#include "harness/commands/commands.h"

namespace mwt {

namespace {

struct Options {
  std::string points;
  std::string triangles;
};

// A corner that is no point of the file, said in the file's own numbers: the checker would know the corner only as out
// of range of the distinct points.
std::optional<std::string> corner_out_of_range(const std::vector<Triangle>& triangles, std::size_t point_count) {
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const Index corner : triangles[t]) {
      if (corner < point_count) continue;
      return std::string(name_of(TriangulationRule::indices_in_range)) + ": triangle " + std::to_string(t) +
             " has corner " + std::to_string(corner) + ", but points go from 0 to " + std::to_string(point_count - 1);
    }
  }
  return std::nullopt;
}

std::optional<std::string> broken_rule(const Options& options) {
  const std::vector<Point> input = read_points(options.points);
  const PointSet set = make_point_set(input, options.points);
  const std::vector<Triangle> triangles = read_triangles(options.triangles);
  if (auto complaint = corner_out_of_range(triangles, input.size())) return complaint;
  const auto violation = find_violation(set.points, from_input_indices(set, input, triangles));
  if (!violation) return std::nullopt;
  const bool renumbered = set.duplicates() > 0;
  return violation->message + (renumbered ? " (points numbered without the duplicates)" : "");
}

int check_triangulation(const Options& options) {
  if (const auto complaint = broken_rule(options)) {
    std::cout << "invalid: " << *complaint << '\n';
    return kExitNegative;
  }
  std::cout << "valid\n";
  return kExitOk;
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<Options>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("points", options->points, "point file; - for stdin");
    declared.argument("triangles", options->triangles, "triangle file: three positions in the point file per line");
  };
  return {"check", "Check that triangles are a triangulation of points: exit 0 valid, 1 invalid", declare,
          [options] { return check_triangulation(*options); }};
}

}  // namespace mwt
