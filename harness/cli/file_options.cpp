#include "harness/cli/file_options.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

void require_no_input(const OutputOption& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (!is_same_file(output.path, input == "-" ? "/dev/stdin" : input)) continue;
    throw InputError(fmt::format("{} {} would overwrite the input ({}); give another name", output.option, output.path,
                                 source_name(input)));
  }
}

void require_no_other_output(const OutputOption& output, std::span<const OutputOption> earlier) {
  for (const OutputOption& other : earlier) {
    if (is_standard_output(output.path) && is_standard_output(other.path))
      throw InputError(other.option + " and " + output.option + " both go to standard output; give one of them a file");
    if (is_same_file(output.path, other.path))
      throw InputError(
          fmt::format("{} and {} both name {}; give one another name", other.option, output.option, output.path));
  }
}

}  // namespace

void require_usable_outputs(std::span<const OutputOption> outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    require_no_other_output(outputs[i], outputs.first(i));
    if (is_standard_output(outputs[i].path)) continue;
    require_no_input(outputs[i], inputs);
    require_writable(outputs[i].path);
  }
}

void require_one_from_standard_input(const std::vector<std::string>& inputs) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw InputError("two files are - but standard input can be read once; give one of them a name");
}

std::optional<OutputOption> output_to_standard_output(std::span<const OutputOption> outputs) {
  const auto found =
      std::find_if(outputs.begin(), outputs.end(), [](const auto& output) { return is_standard_output(output.path); });
  return found == outputs.end() ? std::nullopt : std::optional(*found);
}

void declare_columns(CommandOptions& declared, std::optional<std::string>& columns) {
  declared.option("--columns", columns, ValueKind{"X,Y"},
                  "in a table, the columns of x and y: names in its header or places from 1, as in lon,lat or 3,4");
}

std::optional<ColumnNames> column_names(const std::optional<std::string>& columns) {
  return columns ? std::optional(parse_column_names(*columns)) : std::nullopt;
}

}  // namespace mwt
