#include "harness/study/instance_files.h"

#include <fmt/core.h>
#include <glob.h>

#include <filesystem>
#include <set>

#include "base/error.h"

namespace mwt {

namespace {

// What glob() found, given back in the end.
class GlobResult {
 public:
  explicit GlobResult(const std::string& pattern) { glob(pattern.c_str(), GLOB_ERR, nullptr, &result_); }
  ~GlobResult() { globfree(&result_); }
  GlobResult(const GlobResult&) = delete;
  GlobResult& operator=(const GlobResult&) = delete;

  [[nodiscard]] std::vector<std::string> paths() const {
    return {result_.gl_pathv, result_.gl_pathv + result_.gl_pathc};
  }

 private:
  glob_t result_{};
};

// The folder's own name is no pattern.
std::string escaped(const std::string& path) {
  std::string text;
  for (const char c : path) {
    if (c == '*' || c == '?' || c == '[' || c == '\\') text += '\\';
    text += c;
  }
  return text;
}

}  // namespace

std::vector<std::string> matching_files(const InstanceFiles& files) {
  namespace fs = std::filesystem;
  const fs::path folder(files.folder);
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(files.place + ": no folder " + folder.string() + "; name that of the files with --instances");
  }
  std::set<std::string> found;
  for (const std::string& pattern : files.patterns) {
    const std::vector<std::string> paths = GlobResult(escaped(folder.string()) + '/' + pattern).paths();
    if (paths.empty()) {
      throw InputError(fmt::format("{}: no file matches '{}' in {}; name another folder with --instances", files.place,
                                   pattern, folder.string()));
    }
    for (const std::string& path : paths) {
      if (fs::is_regular_file(path, error)) found.insert(fs::path(path).lexically_relative(folder).string());
    }
  }
  return {found.begin(), found.end()};
}

}  // namespace mwt
