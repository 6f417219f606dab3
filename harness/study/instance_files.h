// The point files that a study runs on.
#pragma once

#include <string>
#include <vector>

namespace mwt {

/// Which point files: patterns within a folder.
struct InstanceFiles {
  std::string folder;                 ///< as the study file or the user gives it
  std::vector<std::string> patterns;  ///< as the shell's: "*.tsp", "small/[ab]*.txt"; relative to the folder
  std::string place;                  ///< "FILE:LINE" for messages
};

/// The paths, relative to the folder, of all files that match a pattern, sorted, each once.
/// Throws InputError: no such folder, or a pattern that nothing matches.
[[nodiscard]] std::vector<std::string> matching_files(const InstanceFiles& files);

}  // namespace mwt
