// A hunt's state as a text file.
#pragma once

#include <string>
#include <vector>

#include "harness/hunt/climber.h"

namespace mwt {

/// Replaces the file's content at once. Exact: what is read equals what was written. InputError as OutputFile.
void write_hunt_state(const std::string& path, const std::string& identity, const std::vector<ClimberState>& climbers);

/// The climbers of a state file. InputError: unreadable, of another hunt (its first line is not `identity`), damaged.
[[nodiscard]] std::vector<ClimberState> read_hunt_state(const std::string& path, const std::string& identity);

}  // namespace mwt
