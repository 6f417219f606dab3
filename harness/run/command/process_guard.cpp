#include "harness/run/command/process_guard.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <string_view>

namespace mwt {

namespace {

// What follows runs in a child of a program with several threads: system calls only, and no memory but the stack.

// "/proc/123/environ".
class EnvironmentFile {
 public:
  explicit EnvironmentFile(const char* number) {
    char* end = copy(path_.data(), "/proc/");
    end = copy(end, number);
    *copy(end, "/environ") = '\0';
  }

  // Whether one of its lines, which end in NUL, is `line`. Shells put them into an order of their own.
  [[nodiscard]] bool has(std::string_view line) const {
    const int file = open(path_.data(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return false;
    constexpr std::size_t kOther = ~std::size_t{0};
    std::size_t matched = 0;  // so many letters of this line are those of `line`; kOther: it is another one
    bool is_found = false;
    std::array<char, 4096> part{};
    for (ssize_t size = 0; !is_found && (size = read(file, part.data(), part.size())) > 0;) {
      for (ssize_t i = 0; i < size && !is_found; ++i) {
        const char letter = part[static_cast<std::size_t>(i)];
        is_found = letter == '\0' && matched == line.size();
        const bool goes_on = matched < line.size() && letter == line[matched];
        matched = letter == '\0' ? 0 : goes_on ? matched + 1 : kOther;
      }
    }
    close(file);
    return is_found;
  }

 private:
  static char* copy(char* to, const char* text) {
    while (*text != '\0') *to++ = *text++;
    return to;
  }

  std::array<char, 64> path_{};
};

// As getdents64() writes it.
struct DirectoryEntry {
  std::uint64_t inode;
  std::int64_t offset;
  std::uint16_t size;
  std::uint8_t type;
  char name[1];
};

pid_t number_of(const char* name) {
  pid_t number = 0;
  for (; *name >= '0' && *name <= '9'; ++name) number = number * 10 + (*name - '0');
  return *name == '\0' ? number : 0;
}

// Returns how many there were.
int kill_once(std::string_view mark) {
  const int folder = open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder < 0) return 0;
  int killed = 0;
  alignas(DirectoryEntry) std::array<char, 32768> buffer{};
  for (long size = 0; (size = syscall(SYS_getdents64, folder, buffer.data(), buffer.size())) > 0;) {
    for (long at = 0; at < size;) {
      const auto* const entry = reinterpret_cast<const DirectoryEntry*>(buffer.data() + at);
      at += entry->size;
      const pid_t pid = number_of(entry->name);
      if (pid > 0 && EnvironmentFile(entry->name).has(mark) && kill(pid, SIGKILL) == 0) ++killed;
    }
  }
  close(folder);
  return killed;
}

void kill_all(std::string_view mark) {
  constexpr int kMaxRounds = 100;  // for those that fork faster than they are found
  constexpr timespec kPause{0, 10'000'000};
  for (int round = 0; round < kMaxRounds && kill_once(mark) > 0; ++round) nanosleep(&kPause, nullptr);
}

// Nothing but SIGKILL ends it, and the end of its parent wakes it.
[[noreturn]] void stand_guard(std::string_view mark, pid_t parent) {
  setsid();
  syscall(SYS_close_range, 0U, ~0U, 0U);
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  sigset_t wake;
  sigemptyset(&wake);
  sigaddset(&wake, SIGTERM);
  while (getppid() == parent) sigwaitinfo(&wake, nullptr);
  kill_all(mark);
  _exit(0);
}

std::string line_of(const std::string& mark) { return std::string(kCommandMark) + '=' + mark; }

}  // namespace

ProcessGuard::ProcessGuard(const std::string& mark) {
  const std::string line = line_of(mark);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) stand_guard(line, parent);
}

ProcessGuard::~ProcessGuard() {
  if (pid_ < 0) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void kill_marked(const std::string& mark) { kill_all(line_of(mark)); }

}  // namespace mwt
