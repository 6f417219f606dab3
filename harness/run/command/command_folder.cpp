#include "harness/run/command/command_folder.h"

#include <fmt/core.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "base/error.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

std::string prefix_of(pid_t process) { return fmt::format("mwt-command-{}-", process); }

void remove_folder(const fs::path& folder) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace

CommandFolder::CommandFolder() {
  std::error_code error;
  const fs::path place = fs::temp_directory_path(error);
  std::string name = (place / (prefix_of(getpid()) + "XXXXXX")).string();
  if (error || mkdtemp(name.data()) == nullptr) {
    throw InputError(fmt::format("{}: cannot make a folder for the files of a command here: {}; set TMPDIR",
                                 place.string(), error ? error.message() : std::strerror(errno)));
  }
  path_ = name;
}

CommandFolder::~CommandFolder() { remove_folder(path_); }

void remove_command_folders_of(pid_t process) {
  std::error_code error;
  const std::string prefix = prefix_of(process);
  for (fs::directory_iterator entry(fs::temp_directory_path(error), error), end; !error && entry != end;
       entry.increment(error)) {
    struct stat status {};
    const bool is_own =
        lstat(entry->path().c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid();
    if (is_own && entry->path().filename().string().starts_with(prefix)) remove_folder(entry->path());
  }
}

}  // namespace mwt
