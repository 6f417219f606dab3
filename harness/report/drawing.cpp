#include "harness/report/drawing.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "harness/io/text/text.h"
#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

std::string script_of_plots(const std::string& name) {
  const std::filesystem::path folder_of_program = std::filesystem::path(own_path()).parent_path();
  const std::filesystem::path installed = folder_of_program.parent_path() / "share" / "mwt" / "plots" / name;
  const std::filesystem::path from_sources = std::filesystem::path(source_folder()) / "plots" / name;
  std::error_code ignored;
  for (const std::filesystem::path& path : {installed, from_sources}) {
    if (std::filesystem::is_regular_file(path, ignored)) return path.string();
  }
  return (folder_of_program / "../../plots" / name).lexically_normal().string();
}

// The exit code, or an errno.
struct Ended {
  int code = 0;
  int error = 0;
};

Ended run_to_end(std::vector<std::string> words) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (const int error = posix_spawn(&child, arguments.front(), nullptr, nullptr, arguments.data(), environ))
    return {1, error};
  int status = 0;
  const bool has_ended = waitpid(child, &status, 0) == child && WIFEXITED(status);
  return {has_ended ? WEXITSTATUS(status) : 1, 0};
}

}  // namespace

std::string own_path() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

std::string draw_by_script(const std::string& script, const std::vector<std::string>& arguments,
                           const std::string& needs) {
  std::vector<std::string> words = {script_of_plots(script)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::string command = joined(words, " ");
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(words.front(), ignored))
    return "nothing is drawn: " + words.front() + " is missing; the project's sources have it in plots/";
  const Ended ended = run_to_end(words);
  if (ended.code == 0) return "";
  return "nothing is drawn: " + words.front() + " failed" +
         (ended.error != 0 ? std::string(": ") + std::strerror(ended.error) : "") + "; it needs " + needs +
         "; then: " + command;
}

}  // namespace mwt
