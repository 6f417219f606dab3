// Another program: started, limited, waited for, and measured.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/deadline.h"

namespace mwt {

struct ProcessOrder {
  std::vector<std::string> words;  ///< program and arguments; the program is sought in PATH
  std::string folder;              ///< empty: the current one
  std::map<std::string, std::string> environment;
  std::string mark;         ///< the value of kCommandMark in its environment, like no other's (process_guard.h)
  std::string input_file;   ///< its standard input
  std::string output_file;  ///< its standard output goes there
  std::string error_file;
  Deadline kill_at;  ///< then its group is killed
};

struct ProcessEndState {
  bool is_late = false;            ///< killed at kill_at
  std::optional<int> exit_code{};  ///< none if a signal ended it
  int signal = 0;
  double wall_time_s = 0;
  double cpu_time_s = 0;  ///< with the children that it waited for
  std::uint64_t peak_rss_bytes = 0;
};

/// Runs a program to its end, and kills whatever it leaves behind. It and all that it started die with the calling
/// thread. Throws InputError
/// if there is no such program or folder. Thread-safe.
[[nodiscard]] ProcessEndState run_process(const ProcessOrder& order);

}  // namespace mwt
