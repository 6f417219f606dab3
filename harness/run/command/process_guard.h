// A process that outlives this one if it is killed, and then kills what a command has started.
#pragma once

#include <sys/types.h>

#include <string>

namespace mwt {

/// The environment variable by which the processes of a command are known, also those that have left its group and
/// whose parents have ended.
inline constexpr const char* kCommandMark = "MWT_COMMAND";

/// While it lives, the death of the calling thread, even by SIGKILL, means the death of all processes that have
/// kCommandMark=mark in their environment. Costs a process that sleeps; without the means for it, there is no guard.
class ProcessGuard {
 public:
  explicit ProcessGuard(const std::string& mark);
  ~ProcessGuard();
  ProcessGuard(const ProcessGuard&) = delete;
  ProcessGuard& operator=(const ProcessGuard&) = delete;

  [[nodiscard]] pid_t pid() const { return pid_; }

 private:
  pid_t pid_;
};

/// Kills these processes, and those that they start meanwhile.
void kill_marked(const std::string& mark);

}  // namespace mwt
