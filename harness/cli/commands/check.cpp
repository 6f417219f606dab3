#include <iostream>
#include <memory>

#include "geometry/point_set.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/input_file.h"
#include "harness/io/points/point_file.h"
#include "harness/io/solution_file.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

struct CheckArguments {
  std::string points;
  std::string triangles;
  std::optional<std::string> columns;
};

// "" or " (edges; corners counted from 1)".
std::string remark_on(const GivenSolution& solution) {
  std::vector<std::string> remarks;
  if (!solution.edges.empty()) remarks.emplace_back("edges");
  if (solution.counts_from_one) remarks.emplace_back("corners counted from 1");
  return remarks.empty() ? "" : " (" + joined(remarks, "; ") + ")";
}

int check_triangulation(const CheckArguments& options) {
  require_one_from_standard_input({options.points, options.triangles});
  const std::vector<Point> input = read_points(options.points, column_names(options.columns));
  const PointSet set = make_point_set(input, source_name(options.points));
  const GivenSolution solution = read_solution(options.triangles, input.size());
  const std::optional<std::string> rule = broken_rule(set, input, solution);
  std::cout << (rule ? "invalid" : "valid") << remark_on(solution) << (rule ? ": " + *rule : "") << '\n';
  return rule ? kExitNegative : kExitOk;
}

}  // namespace

Command check_command() {
  const auto options = std::make_shared<CheckArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("points", options->points, kFile, "point file; - for stdin");
    declared.argument("triangles", options->triangles, kFile,
                      "triangles or edges: positions in the point file, from 0 or 1, as a table, JSON or .ele");
    declare_columns(declared, options->columns);
  };
  return {"check", "Check that triangles or edges are a triangulation of points: exit 0 valid, 1 invalid", declare,
          [options] { return check_triangulation(*options); }};
}

}  // namespace mwt
