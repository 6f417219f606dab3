// Runs another program to its end.
#pragma once

#include <string>
#include <vector>

namespace mwt {

/// Runs `arguments` (the program's path first) with standard input empty and both outputs going to the file `log`.
/// Returns its exit code, 128 + the signal's number if one ended it.
/// Throws InputError if the program cannot be started.
[[nodiscard]] int run_program(const std::vector<std::string>& arguments, const std::string& log);

}  // namespace mwt
