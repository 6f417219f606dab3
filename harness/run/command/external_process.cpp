#include "harness/run/command/external_process.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "harness/run/command/process_guard.h"
#include "harness/run/machine/orphans.h"

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;

// Arguments and environment as execve() takes them, made before the fork: a child of a program with several threads
// must not allocate.
class ExecText {
 public:
  explicit ExecText(std::vector<std::string> lines) : lines_(std::move(lines)) {
    for (std::string& line : lines_) pointers_.push_back(line.data());
    pointers_.push_back(nullptr);
  }
  ExecText(const ExecText&) = delete;
  ExecText& operator=(const ExecText&) = delete;

  [[nodiscard]] char* const* get() const { return pointers_.data(); }

 private:
  std::vector<std::string> lines_;
  std::vector<char*> pointers_;
};

std::vector<std::string> environment_with(const std::string& mark, const std::map<std::string, std::string>& more) {
  std::vector<std::string> lines = {std::string(kCommandMark) + '=' + mark};
  for (char** line = environ; *line != nullptr; ++line) {
    const std::string text = *line, name = text.substr(0, text.find('='));
    if (name != kCommandMark && !more.contains(name)) lines.push_back(text);
  }
  for (const auto& [name, value] : more) lines.push_back(name + '=' + value);
  return lines;
}

bool is_program(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error) && access(path.c_str(), X_OK) == 0;
}

// A name without '/' is sought in PATH; another one counts from the command's folder.
std::string program_of(const ProcessOrder& order) {
  namespace fs = std::filesystem;
  const std::string& name = order.words.front();
  if (name.find('/') != std::string::npos) {
    const fs::path path = fs::absolute(fs::path(order.folder) / name);
    if (is_program(path)) return path.string();
    throw InputError(path.string() + ": is no program that can be executed");
  }
  const char* const variable = std::getenv("PATH");
  const std::string places = variable == nullptr ? "/usr/bin:/bin" : variable;
  for (std::size_t begin = 0; begin <= places.size();) {
    const std::size_t end = std::min(places.find(':', begin), places.size());
    const fs::path path = fs::path(places.substr(begin, end - begin)) / name;
    if (is_program(path)) return path.string();
    begin = end + 1;
  }
  throw InputError(name + ": no such program in PATH");
}

struct Launch {
  std::string program;
  ExecText words;
  ExecText environment;
  std::string folder;
  std::array<int, 3> streams;
  int exec_error = -1;  // a pipe that closes when the program has begun
  pid_t parent = 0;
};

// Calls only what is safe after a fork.
[[noreturn]] void become(const Launch& launch) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != launch.parent) _exit(127);
  for (int stream = 0; stream < 3; ++stream) dup2(launch.streams[static_cast<std::size_t>(stream)], stream);
  for (const int signal_number : {SIGINT, SIGTERM, SIGUSR1, SIGPIPE}) signal(signal_number, SIG_DFL);
  constexpr rlim_t kMaxFile = rlim_t{1} << 32;  // bytes: nobody's disk is to be full
  const rlimit file_size{kMaxFile, kMaxFile};
  setrlimit(RLIMIT_FSIZE, &file_size);
  if (launch.folder.empty() || chdir(launch.folder.c_str()) == 0)
    execve(launch.program.c_str(), launch.words.get(), launch.environment.get());
  const int error = errno;
  static_cast<void>(!write(launch.exec_error, &error, sizeof error));
  _exit(127);
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close_now(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  [[nodiscard]] int get() const { return number_; }
  void close_now() {
    if (number_ >= 0) close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

Descriptor opened(const std::string& file, int flags) {
  constexpr mode_t kPrivate = 0600;
  const int number = open(file.c_str(), flags | O_CLOEXEC, kPrivate);
  if (number < 0) throw InputError(file + ": cannot be opened: " + std::strerror(errno));
  return Descriptor(number);
}

// Until it has ended, or the deadline kills it. Returns whether it was killed.
bool wait_or_kill(pid_t pid, const Deadline& kill_at) {
  const Descriptor exit_watch(static_cast<int>(syscall(SYS_pidfd_open, pid, 0)));
  if (exit_watch.get() < 0) throw std::system_error(errno, std::generic_category(), "pidfd_open");
  for (;;) {
    int patience = -1;
    if (kill_at) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(*kill_at - Clock::now()).count();
      if (left <= 0) {
        kill(pid, SIGKILL);
        return true;
      }
      patience = static_cast<int>(std::min<std::int64_t>(left, 1'000'000));
    }
    pollfd watched{exit_watch.get(), POLLIN, 0};
    if (poll(&watched, 1, patience) > 0) return false;
  }
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

// Throws InputError if the program did not begin.
void require_begun(int exec_error, const std::string& program, const std::string& folder) {
  int error = 0;
  ssize_t size = 0;
  do size = read(exec_error, &error, sizeof error);
  while (size < 0 && errno == EINTR);
  if (size != sizeof error) return;
  const std::string place = folder.empty() ? "" : " in the folder " + folder;
  throw InputError(program + ": cannot be started" + place + ": " + std::strerror(error));
}

}  // namespace

ProcessEndState run_process(const ProcessOrder& order) {
  const std::string program = program_of(order);
  const Descriptor input = opened(order.input_file, O_RDONLY);
  const Descriptor output = opened(order.output_file, O_WRONLY | O_CREAT | O_TRUNC);
  const Descriptor errors = opened(order.error_file, O_WRONLY | O_CREAT | O_TRUNC);
  std::array<int, 2> pipe_ends{};
  if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const Descriptor begun(pipe_ends[0]);
  Descriptor exec_error(pipe_ends[1]);
  const Launch launch{program,
                      ExecText(order.words),
                      ExecText(environment_with(order.mark, order.environment)),
                      order.folder,
                      {input.get(), output.get(), errors.get()},
                      exec_error.get(),
                      getpid()};
  adopt_orphans();
  ProcessEndState end;
  rusage usage{};
  int status = 0;
  {
    lock_children();
    const ProcessGuard guard(order.mark);
    const AwaitedChild awaited_guard(guard.pid());
    const Clock::time_point begin = Clock::now();
    const pid_t pid = fork();
    if (pid == 0) become(launch);
    const int fork_error = errno;
    const AwaitedChild awaited(pid);
    unlock_children();
    if (pid < 0) throw std::system_error(fork_error, std::generic_category(), "fork");
    exec_error.close_now();
    end.is_late = wait_or_kill(pid, order.kill_at);
    while (wait4(pid, &status, 0, &usage) < 0 && errno == EINTR) {
    }
    end.wall_time_s = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  kill_orphans();
  require_begun(begun.get(), program, order.folder);
  if (WIFEXITED(status)) end.exit_code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
  end.cpu_time_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  end.peak_rss_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return end;
}

}  // namespace mwt
