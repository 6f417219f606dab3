#include "harness/run/process_pool.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <ctime>
#include <exception>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "harness/io/text/text.h"
#include "harness/run/machine/orphans.h"
#include "harness/run/machine/proc_file.h"

namespace mwt {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kErrorTailSize = 500;
constexpr std::size_t kMaxOutput = std::size_t{1} << 26;
constexpr int kExitWithoutResult = 70;

struct Pipe {
  int read_end = -1;
  int write_end = -1;
};

Pipe open_pipe() {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return {ends[0], ends[1]};
}

// Appends what is there without waiting. At the end of the stream the descriptor is closed and becomes -1, which poll()
// ignores.
void drain(int& descriptor, std::string& text) {
  std::array<char, 1 << 14> block;
  while (descriptor >= 0) {
    const ssize_t size = read(descriptor, block.data(), block.size());
    if (size < 0) return;
    if (size == 0) close(std::exchange(descriptor, -1));
    text.append(block.data(), static_cast<std::size_t>(size));
  }
}

void write_all(int descriptor, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t size = write(descriptor, text.data() + done, text.size() - done);
    if (size < 0 && errno != EINTR) return;
    if (size > 0) done += static_cast<std::size_t>(size);
  }
}

void limit(__rlimit_resource_t resource, std::uint64_t soft, std::uint64_t hard) {
  const rlimit value{soft, hard};
  setrlimit(resource, &value);
}

// Data, not address space: an address space limit would count the parent's mappings and libraries, and sanitizers
// reserve terabytes of it. What the child inherited is added, so that the limit is the work's own.
//
// The CPU limit is not among these: under RLIMIT_CPU the kernel updates a process's CPU clock at scheduler ticks only,
// milliseconds apart, and the clock is what times are taken with. The parent watches the CPU time instead.
void impose(const ProcessLimits& limits) {
  const std::uint64_t inherited = kilobytes_in("/proc/self/status", "VmData:").value_or(0) * 1024;
  limit(RLIMIT_DATA, inherited + limits.memory_bytes, inherited + limits.memory_bytes);
  limit(RLIMIT_CORE, 0, 0);
}

// The CPU time of a child so far; 0 if it cannot be read, because the child has ended.
double cpu_time_of(pid_t child) {
  clockid_t clock{};
  std::timespec time{};
  if (clock_getcpuclockid(child, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Clock::duration duration_of(double seconds) {
  return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

[[noreturn]] void run_in_child(const ProcessPool::Work& work, const ProcessLimits& limits, int result, int errors,
                               pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(kExitWithoutResult);
  for (const int signal_number : {SIGINT, SIGTERM, SIGUSR1, SIGPIPE}) std::signal(signal_number, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  impose(limits);
  try {
    write_all(result, work());
    _exit(0);
  } catch (const std::exception& failure) {
    write_all(errors, failure.what());
  } catch (...) {
    write_all(errors, "an exception of unknown type");
  }
  _exit(kExitWithoutResult);
}

}  // namespace

struct ProcessPool::Child {
  pid_t pid = 0;
  std::unique_ptr<AwaitedChild> awaited;
  int exit_watch = -1;  // readable when the process has ended
  int output_pipe = -1;
  int error_pipe = -1;
  Clock::time_point kill_at;
  Clock::time_point check_cpu_at;
  double cpu_s = 0;
  bool stopped = false;
  std::string output;
  std::string errors;
  WhenDone when_done;

  void read_pipes() {
    drain(output_pipe, output);
    drain(error_pipe, errors);
    if (errors.size() > kErrorTailSize) errors.erase(0, errors.size() - kErrorTailSize);
    if (output.size() > kMaxOutput) stop();
  }

  // Sets when it can have used so much more CPU time at the earliest, on all CPUs at once.
  void check_cpu_after(double cpu_left_s) {
    constexpr double kShortestPause = 0.01;
    static const double cpus = static_cast<double>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
    check_cpu_at = Clock::now() + duration_of(std::max(kShortestPause, cpu_left_s / cpus));
  }

  void enforce_limits() {
    const Clock::time_point now = Clock::now();
    if (now >= kill_at) return stop();
    if (now < check_cpu_at) return;
    const double cpu_left_s = cpu_s - cpu_time_of(pid);
    if (cpu_left_s <= 0) return stop();
    check_cpu_after(cpu_left_s);
  }

  void stop() {
    stopped = true;
    kill(-pid, SIGKILL);
    kill(pid, SIGKILL);  // in case it has not made its group yet
  }

  void close_all() {
    for (int* descriptor : {&exit_watch, &output_pipe, &error_pipe}) {
      if (*descriptor >= 0) close(std::exchange(*descriptor, -1));
    }
  }

  // The process has ended: takes in the rest of it.
  ProcessResult collect() {
    kill(-pid, SIGKILL);  // whatever it left behind in its group
    int status = 0;
    while (waitpid(pid, &status, 0) < 0 && errno == EINTR) {
    }
    awaited.reset();
    kill_orphans();  // and what has left the group
    read_pipes();
    close_all();
    return result_for(status);
  }

  [[nodiscard]] ProcessResult result_for(int wait_status) const {
    ProcessResult result{ProcessEnd::crashed, output, one_line(errors), ""};
    if (WIFSIGNALED(wait_status)) {
      const int number = WTERMSIG(wait_status);
      result.how = fmt::format("signal {} ({})", number, strsignal(number));
      if (number == SIGKILL) result.end = ProcessEnd::killed;
      if (stopped || number == SIGXCPU) result.end = ProcessEnd::stopped_at_limit;  // SIGXCPU: by a shell's ulimit -t
    } else if (WEXITSTATUS(wait_status) == 0 && !output.empty()) {
      result.end = ProcessEnd::finished;
    } else {
      result.how = fmt::format("exit code {} without a result", WEXITSTATUS(wait_status));
    }
    return result;
  }
};

ProcessPool::ProcessPool(int capacity) : capacity_(capacity) { adopt_orphans(); }

ProcessPool::~ProcessPool() {
  for (Child& child : children_) {
    child.stop();
    waitpid(child.pid, nullptr, 0);
    child.awaited.reset();
    child.close_all();
  }
  kill_orphans();
}

void ProcessPool::start(const Work& work, const ProcessLimits& limits, WhenDone when_done) {
  const Pipe output = open_pipe();
  const Pipe errors = open_pipe();
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (pid == 0) run_in_child(work, limits, output.write_end, errors.write_end, parent);
  setpgid(pid, pid);
  close(output.write_end);
  close(errors.write_end);
  Child child;
  child.pid = pid;
  child.awaited = std::make_unique<AwaitedChild>(pid);
  child.exit_watch = static_cast<int>(syscall(SYS_pidfd_open, pid, 0));
  child.output_pipe = output.read_end;
  child.error_pipe = errors.read_end;
  child.kill_at = Clock::now() + duration_of(limits.wall_s);
  child.cpu_s = limits.cpu_s;
  child.check_cpu_after(limits.cpu_s);
  child.when_done = std::move(when_done);
  if (child.exit_watch < 0) throw std::system_error(errno, std::generic_category(), "pidfd_open");
  children_.push_back(std::move(child));
}

void ProcessPool::wait(std::chrono::milliseconds patience) {
  Clock::time_point wake_at = Clock::now() + patience;
  std::vector<pollfd> watched;
  for (const Child& child : children_) {
    if (!child.stopped) wake_at = std::min({wake_at, child.kill_at, child.check_cpu_at});
    for (const int descriptor : {child.exit_watch, child.output_pipe, child.error_pipe}) {
      watched.push_back({descriptor, POLLIN, 0});
    }
  }
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(wake_at - Clock::now());
  poll(watched.data(), watched.size(), static_cast<int>(std::max<std::int64_t>(0, left.count())));
  std::list<Child> ended;
  std::size_t position = 0;
  for (auto child = children_.begin(); child != children_.end(); position += 3) {
    const auto current = child++;
    current->read_pipes();
    const bool has_ended = (watched[position].revents & POLLIN) != 0;
    if (has_ended) {
      ended.splice(ended.end(), children_, current);
    } else if (!current->stopped) {
      current->enforce_limits();
    }
  }
  for (Child& child : ended) child.when_done(child.collect());  // which may start others
}

}  // namespace mwt
