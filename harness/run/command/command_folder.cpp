#include "harness/run/command/command_folder.h"

#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>

#include "base/number_text.h"
#include "harness/run/command/process_guard.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

// Temporary files may be on a disk that several machines share.
std::string prefix() {
  std::array<char, 256> host{};
  if (gethostname(host.data(), host.size() - 1) != 0) return "mwt-command-";
  std::string name = host.data();
  std::ranges::replace(name, '/', '_');
  return "mwt-command-" + name + '-';
}

// The process that made a folder of this name, "PREFIX123-XXXXXX"; nothing if it is no such folder.
std::optional<pid_t> maker_of(const std::string& name) {
  const std::string begin = prefix();
  if (!name.starts_with(begin)) return std::nullopt;
  return parse_whole_number<int>(name.substr(begin.size(), name.find('-', begin.size()) - begin.size()));
}

}  // namespace

CommandFolder::CommandFolder() : TemporaryFolder(prefix() + std::to_string(getpid())) {}

void remove_abandoned_command_folders() {
  std::error_code error;
  for (fs::directory_iterator entry(fs::temp_directory_path(error), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::optional<pid_t> maker = maker_of(entry->path().filename().string());
    if (!maker || kill(*maker, 0) == 0 || errno != ESRCH) continue;
    struct stat status {};
    const bool is_own =
        lstat(entry->path().c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid();
    if (!is_own) continue;
    kill_marked(entry->path().string());
    std::error_code ignored;
    fs::remove_all(entry->path(), ignored);
  }
}

}  // namespace mwt
