// Processes that a program left behind: children of children, whose parents have ended.
#pragma once

#include <sys/types.h>

namespace mwt {

/// From now on, descendants of this process whose parents have ended become its children, instead of the system's, also
/// if they have left their process group. Linux.
void adopt_orphans();

/// While it lives, the process is no orphan: somebody waits for it.
class AwaitedChild {
 public:
  explicit AwaitedChild(pid_t pid);
  ~AwaitedChild();
  AwaitedChild(const AwaitedChild&) = delete;
  AwaitedChild& operator=(const AwaitedChild&) = delete;

 private:
  pid_t pid_;
};

/// Kills all adopted orphans, and those that appear thereby, and waits for their ends. Thread-safe; to be called under
/// no AwaitedChild of the same process. Returns how many there were.
int kill_orphans();

/// Programs with several threads start a child between these two, so that no other thread takes it for an orphan before
/// it is awaited. The child must not come back here: it executes another program.
void lock_children();
void unlock_children();

}  // namespace mwt
