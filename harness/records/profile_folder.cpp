#include "harness/records/profile_folder.h"

#include <exception>
#include <filesystem>
#include <utility>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

fs::path profiles_in(const std::string& results_folder) { return fs::path(results_folder) / "profiles"; }

std::string profile_file(const std::string& results_folder, const std::string& run_id) {
  return (profiles_in(results_folder) / (run_id + ".csv")).string();
}

}  // namespace

void prepare_profile_folder(const std::string& results_folder) {
  const fs::path folder = profiles_in(results_folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error))
    throw InputError(folder.string() +
                     ": cannot make this folder for profiles: " + (error ? error.message() : "a file is in its place"));
}

void write_profile(const std::string& results_folder, const std::string& run_id, const FunctionCounts& functions) {
  write_file_atomically(profile_file(results_folder, run_id), to_csv(functions));
}

FunctionCounts read_profile(const std::string& results_folder, const std::string& run_id) {
  const std::string file = profile_file(results_folder, run_id);
  std::error_code error;
  if (run_id.empty() || !fs::is_regular_file(file, error)) return {};
  try {
    return functions_of_csv(read_file(file));
  } catch (const std::exception&) {
    return {};
  }
}

void copy_profiles(const std::vector<std::string>& from, const std::string& to, const std::vector<RunRecord>& runs) {
  bool is_prepared = false;
  for (const RunRecord& run : runs) {
    if (!run.callgrind_instructions) continue;
    for (const std::string& folder : from) {
      const FunctionCounts functions = read_profile(folder, run.run_id);
      if (functions.empty()) continue;
      if (!std::exchange(is_prepared, true)) prepare_profile_folder(to);
      write_profile(to, run.run_id, functions);
      break;
    }
  }
}

}  // namespace mwt
