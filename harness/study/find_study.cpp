#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "harness/io/text/text.h"
#include "harness/run/machine/build_info.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

// Where the project's studies are: those that are installed with this program; else those beside the sources that it
// was built from; else, if these have been moved together with their build directory, at the same place relative to the
// program.
fs::path studies_folder() {
  std::error_code ignored;
  const fs::path folder_of_program = fs::read_symlink("/proc/self/exe", ignored).parent_path();
  const fs::path installed = folder_of_program.parent_path() / "share" / "mwt" / "harness" / "studies";
  const fs::path from_sources = fs::path(source_folder()) / "harness" / "studies";
  for (const fs::path& folder : {installed, from_sources}) {
    if (fs::is_directory(folder, ignored)) return folder;
  }
  return folder_of_program / "../../harness/studies";
}

}  // namespace

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  std::error_code missing;
  for (const fs::directory_entry& entry : fs::directory_iterator(studies_folder(), missing)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_study_file(const std::string& name_or_path) {
  const bool is_path = name_or_path.find('/') != std::string::npos || name_or_path.ends_with(".toml");
  if (is_path) return name_or_path;
  const std::vector<std::string> names = study_names();
  if (std::find(names.begin(), names.end(), name_or_path) != names.end()) {
    return (studies_folder() / (name_or_path + ".toml")).string();
  }
  throw InputError(
      fmt::format("unknown study '{}'; known: {}; or give the path of a .toml file", name_or_path, joined(names)));
}

}  // namespace mwt
