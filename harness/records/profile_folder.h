// Where the instructions of counted runs are: the folder profiles/ within a study's results.
#pragma once

#include <string>
#include <vector>

#include "harness/records/records.h"
#include "harness/run/callgrind/profile.h"

namespace mwt {

/// Makes the folder for profiles. Throws InputError: it cannot be made.
void prepare_profile_folder(const std::string& results_folder);

/// Precondition: prepare_profile_folder(). Throws InputError: it cannot be written.
void write_profile(const std::string& results_folder, const std::string& run_id, const FunctionCounts& functions);

/// Empty if the run has none, or an unreadable one.
[[nodiscard]] FunctionCounts read_profile(const std::string& results_folder, const std::string& run_id);

/// Copies the profiles of these runs from the first of the results folders that has them. Throws InputError: a copy
/// cannot be written.
void copy_profiles(const std::vector<std::string>& from, const std::string& to, const std::vector<RunRecord>& runs);

}  // namespace mwt
