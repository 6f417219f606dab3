#include "harness/run/machine/orphans.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>
#include <vector>

namespace mwt {

namespace {

std::recursive_mutex children_mutex;

std::set<pid_t>& awaited() {
  static std::set<pid_t> pids;
  return pids;
}

// The kernel lists them by thread.
std::vector<pid_t> children() {
  std::vector<pid_t> found;
  std::error_code error;
  for (std::filesystem::directory_iterator task("/proc/self/task", error), end; !error && task != end;
       task.increment(error)) {
    std::ifstream file(task->path() / "children");
    for (pid_t pid = 0; file >> pid;) found.push_back(pid);
  }
  return found;
}

}  // namespace

void adopt_orphans() { prctl(PR_SET_CHILD_SUBREAPER, 1); }

AwaitedChild::AwaitedChild(pid_t pid) : pid_(pid) {
  const std::lock_guard lock(children_mutex);
  awaited().insert(pid);
}

AwaitedChild::~AwaitedChild() {
  const std::lock_guard lock(children_mutex);
  awaited().erase(pid_);
}

void lock_children() { children_mutex.lock(); }
void unlock_children() { children_mutex.unlock(); }

int kill_orphans() {
  const std::lock_guard lock(children_mutex);
  int killed = 0;
  for (bool is_done = false; !is_done;) {
    is_done = true;
    for (const pid_t pid : children()) {
      if (awaited().contains(pid)) continue;
      kill(pid, SIGKILL);
      waitpid(pid, nullptr, 0);
      ++killed;
      is_done = false;  // its children are orphans now
    }
  }
  return killed;
}

}  // namespace mwt
