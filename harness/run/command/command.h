// Algorithms that are commands: programs in any language, by the contract in harness/run/COMMANDS.md.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "algorithms/algorithm.h"
#include "harness/run/status.h"

namespace mwt {

struct ExternalCommand {
  std::vector<std::string> words;                  ///< the program and its arguments, with {placeholders}
  std::string folder;                              ///< where it runs; empty: where mwt does
  std::map<std::string, std::string> environment;  ///< besides that of mwt
  std::string points_format = "txt";               ///< ending of the file of points
};

/// What a command did instead of a triangulation, as a run's status.
class CommandFailure : public std::runtime_error {
 public:
  CommandFailure(RunStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}

  [[nodiscard]] RunStatus status() const { return status_; }

 private:
  RunStatus status_;
};

/// The entry of an algorithm that runs the command. Its parameters are `defaults`, all of them texts. The entry's
/// function throws CommandFailure and NotApplicable.
///
/// Throws InputError: no words, an unknown placeholder or format, a name that records cannot hold.
[[nodiscard]] AlgorithmInfo algorithm_of(const std::string& name, const ExternalCommand& command,
                                         const std::map<std::string, std::string>& defaults);

/// What identifies the command besides its words: a hash of the files that these name in its folder, so that records
/// of an edited program are another algorithm's.
[[nodiscard]] std::string content_hash_of(const ExternalCommand& command);

}  // namespace mwt
