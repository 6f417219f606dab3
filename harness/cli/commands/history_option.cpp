#include "harness/cli/commands/history_option.h"

#include <filesystem>

#include "base/error.h"

namespace mwt {

void make_folder_of(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw InputError(folder.string() + ": cannot make this folder: " + error.message());
}

}  // namespace mwt
