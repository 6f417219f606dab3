#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "harness/paper/paper.h"
#include "harness/run/machine/build_info.h"

namespace mwt {

namespace {

std::filesystem::path drawing_script() {
  const std::filesystem::path from_sources = std::filesystem::path(source_folder()) / "plots" / "draw_paper.py";
  std::error_code ignored;
  if (std::filesystem::is_regular_file(from_sources, ignored)) return from_sources;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path() / "../../plots/draw_paper.py";
}

}  // namespace

std::string draw_paper_figures(const std::string& folder) {
  const std::string script = drawing_script().lexically_normal().string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(script, ignored))
    return "no figures: " + script + " is missing; run plots/draw_paper.py " + folder + " from the project's sources";
  std::string program = script, argument = folder;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ);
  int status = 0;
  if (error == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
  return "no figures: " + script + " failed" + (error != 0 ? std::string(": ") + std::strerror(error) : "") +
         "; it needs python3-pandas, python3-matplotlib and, for PGF, texlive-latex-base and texlive-pictures; then: " +
         script + " " + folder;
}

}  // namespace mwt
