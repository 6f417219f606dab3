#include "harness/report/drawing.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

std::filesystem::path script_of_plots(const std::string& name) {
  const std::filesystem::path from_sources = std::filesystem::path(source_folder()) / "plots" / name;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(from_sources, ignored)) return from_sources;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "../../plots" / name;
}

}  // namespace

std::string draw_by_script(const std::string& script, const std::string& folder, const std::string& needs) {
  const std::string path = script_of_plots(script).lexically_normal().string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    return "nothing is drawn: " + path + " is missing; run plots/" + script + " " + folder +
           " from the project's sources";
  std::string program = path, argument = folder;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ);
  int status = 0;
  if (error == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "nothing is drawn: " + path + " failed" + (error != 0 ? std::string(": ") + std::strerror(error) : "") +
         "; it needs " + needs + "; then: " + path + " " + folder;
}

}  // namespace mwt
