// The files that a command reads, and writes besides its report: checked before any work is done.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "harness/cli/command_line.h"
#include "harness/io/points/point_file.h"

namespace mwt {

/// An option that names a file to write, such as {"--svg", "out.svg"}.
struct OutputOption {
  std::string option;
  std::string path;
};

/// Throws InputError: an output is one of the inputs, two outputs are the same file or both standard output, or one
/// cannot be written. Changes nothing.
void require_usable_outputs(std::span<const OutputOption> outputs, const std::vector<std::string>& inputs);

/// Throws InputError if two inputs are "-": standard input can be read once.
void require_one_from_standard_input(const std::vector<std::string>& inputs);

/// Declares --columns, for tables of points.
void declare_columns(CommandOptions& declared, std::optional<std::string>& columns);
[[nodiscard]] std::optional<ColumnNames> column_names(const std::optional<std::string>& columns);

/// The one that goes to standard output, if any.
[[nodiscard]] std::optional<OutputOption> output_to_standard_output(std::span<const OutputOption> outputs);

}  // namespace mwt
