#include <iostream>
#include <memory>

#include "geometry/point_set.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/input_file.h"
#include "harness/io/points/point_file.h"
#include "harness/io/triangulation_file.h"

namespace mwt {

namespace {

struct CheckArguments {
  std::string points;
  std::string triangles;
};

std::optional<std::string> complaint_about(const CheckArguments& options) {
  require_one_from_standard_input({options.points, options.triangles});
  const std::vector<Point> input = read_points(options.points);
  const PointSet set = make_point_set(input, source_name(options.points));
  return broken_rule(set, input, read_triangles(options.triangles));
}

int check_triangulation(const CheckArguments& options) {
  if (const auto complaint = complaint_about(options)) {
    std::cout << "invalid: " << *complaint << '\n';
    return kExitNegative;
  }
  std::cout << "valid\n";
  return kExitOk;
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("points", options->points, "point file; - for stdin");
    declared.argument("triangles", options->triangles, "triangle file: three positions in the point file per line");
  };
  return {"check", "Check that triangles are a triangulation of points: exit 0 valid, 1 invalid", declare,
          [options] { return check_triangulation(*options); }};
}

}  // namespace mwt
