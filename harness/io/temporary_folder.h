// A folder for files that go away with it.
#pragma once

#include <filesystem>
#include <string>

namespace mwt {

/// Made empty in the system's folder for temporary files ($TMPDIR), readable by the user alone; removed with all that
/// is in it. Its name is the prefix and a hyphen followed by six letters and digits.
class TemporaryFolder {
 public:
  /// Throws InputError: it cannot be made.
  explicit TemporaryFolder(const std::string& prefix);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// The path of a file in it, whether or not there is one.
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace mwt
