// All commands of `mwt`, one file of this folder each. To add one: its file, its declaration here and its line in
// mwt_main.cpp.
#pragma once

#include "harness/cli/command_line.h"

namespace mwt {

[[nodiscard]] Command list_command();
[[nodiscard]] Command generate_command();
[[nodiscard]] Command solve_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command draw_command();
[[nodiscard]] Command convert_command();
[[nodiscard]] Command run_command();
[[nodiscard]] Command merge_command();
[[nodiscard]] Command cluster_command();
[[nodiscard]] Command report_command();
[[nodiscard]] Command archive_command();
[[nodiscard]] Command hunt_command();
[[nodiscard]] Command compare_command();
[[nodiscard]] Command track_command();
[[nodiscard]] Command history_command();
[[nodiscard]] Command explore_command();

/// These describe all commands, themselves included: `commands` has to outlive the command, and may grow until it runs.
[[nodiscard]] Command completion_command(const std::vector<Command>& commands);
[[nodiscard]] Command manual_command(const std::vector<Command>& commands);

}  // namespace mwt
