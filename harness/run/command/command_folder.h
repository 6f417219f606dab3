// The folder of one execution of a command: its points, its answer, what it prints.
#pragma once

#include <string>

namespace mwt {

/// Made in the system's folder for temporary files ($TMPDIR), readable by the user alone; removed with all that is in
/// it. Throws InputError: it cannot be made.
class CommandFolder {
 public:
  CommandFolder();
  ~CommandFolder();
  CommandFolder(const CommandFolder&) = delete;
  CommandFolder& operator=(const CommandFolder&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + '/' + name; }

 private:
  std::string path_;
};

/// Removes the folders that processes of this machine left when they were killed, and kills what runs for them. Time:
/// the folder of temporary files is read once.
void remove_abandoned_command_folders();

}  // namespace mwt
