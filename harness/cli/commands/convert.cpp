#include <iostream>
#include <memory>

#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/points/point_file.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

struct ConvertArguments {
  std::string input;
  std::string output;
  std::optional<std::string> columns;
};

int convert(const ConvertArguments& options) {
  require_writable_points(options.output);
  const OutputOption output{"the output", options.output};
  require_usable_outputs({&output, 1}, {options.input});
  const std::vector<Point> points = read_points(options.input, column_names(options.columns));
  write_points(options.output, points);
  std::cerr << counted(points.size(), "point") << '\n';
  return kExitOk;
}

}  // namespace

Command convert_command() {
  const auto options = std::make_shared<ConvertArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("input", options->input, kFile, "point file of any known format, also compressed; - for stdin");
    declared.argument("output", options->output, kFile,
                      "point file by its ending (.txt .xy .csv .tsv .tsp .json); - for stdout");
    declare_columns(declared, options->columns);
  };
  return {"convert", "Read the points of other programs and write them as text, CSV, TSPLIB or JSON", declare,
          [options] { return convert(*options); }};
}

}  // namespace mwt
