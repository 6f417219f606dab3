#include "harness/explore/server/job_host.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

#include "harness/run/machine/proc_file.h"

namespace mwt {

namespace {

constexpr int kNoReader = 71;  // the exit code of a job that nobody reads; nobody reads it either

struct SocketPair {
  int ours = -1;
  int theirs = -1;
};

SocketPair open_socket_pair(int type) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, type | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw std::system_error(errno, std::generic_category(), "socketpair");
  return {ends[0], ends[1]};
}

// A message of one byte that carries a descriptor.
struct DescriptorMessage {
  DescriptorMessage() {
    part.iov_base = &byte;
    part.iov_len = 1;
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = space.data();
    message.msg_controllen = space.size();
  }

  char byte = 0;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> space{};
  iovec part{};
  msghdr message{};
};

bool send_descriptor(int control, int descriptor) {
  DescriptorMessage sent;
  cmsghdr* const head = CMSG_FIRSTHDR(&sent.message);
  head->cmsg_level = SOL_SOCKET;
  head->cmsg_type = SCM_RIGHTS;
  head->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(head), &descriptor, sizeof(int));
  return sendmsg(control, &sent.message, MSG_NOSIGNAL) == 1;
}

// -1 when the other end is closed.
int receive_descriptor(int control) {
  DescriptorMessage received;
  ssize_t size = 0;
  do {
    size = recvmsg(control, &received.message, MSG_CMSG_CLOEXEC);
  } while (size < 0 && errno == EINTR);
  const cmsghdr* const head = size == 1 ? CMSG_FIRSTHDR(&received.message) : nullptr;
  if (head == nullptr || head->cmsg_type != SCM_RIGHTS) return -1;
  int descriptor = -1;
  std::memcpy(&descriptor, CMSG_DATA(head), sizeof(int));
  return descriptor;
}

bool send_text(int socket, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t size = ::send(socket, text.data() + done, text.size() - done, MSG_NOSIGNAL);
    if (size < 0 && errno != EINTR) return false;
    if (size > 0) done += static_cast<std::size_t>(size);
  }
  return true;
}

std::string received_text(int socket) {
  std::string text;
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t size = recv(socket, block.data(), block.size(), 0);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(size));
  }
}

[[noreturn]] void run_job(const JobHost::Work& work, int socket, unsigned limit_s, std::uint64_t memory_bytes) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const int number : {SIGCHLD, SIGINT, SIGTERM, SIGALRM}) std::signal(number, SIG_DFL);
  alarm(limit_s);
  const std::uint64_t inherited = kilobytes_in("/proc/self/status", "VmData:").value_or(0) * 1024;
  const rlimit data{inherited + memory_bytes, inherited + memory_bytes};
  setrlimit(RLIMIT_DATA, &data);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  try {
    work(received_text(socket), JobAnswer(socket));
  } catch (...) {  // the answer ends without its last frame, which the page reports
    _exit(1);
  }
  _exit(0);
}

[[noreturn]] void host_jobs(const JobHost::Work& work, int control, pid_t parent, unsigned limit_s,
                            std::uint64_t memory_bytes) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(0);
  std::signal(SIGCHLD, SIG_IGN);  // the system collects jobs that have ended
  for (;;) {
    const int socket = receive_descriptor(control);
    if (socket < 0) _exit(0);
    if (fork() == 0) {
      close(control);
      run_job(work, socket, limit_s, memory_bytes);
    }
    close(socket);  // if there was no process, the answer ends here
  }
}

}  // namespace

void JobAnswer::send(const Frame& frame) const {
  if (!send_text(socket_, encoded(frame))) _exit(kNoReader);
}

void JobAnswer::require_reader() const {
  pollfd watched{socket_, 0, 0};
  if (poll(&watched, 1, 0) > 0 && (watched.revents & (POLLHUP | POLLERR)) != 0) _exit(kNoReader);
}

JobHost::JobHost(const Work& work, unsigned limit_s, std::uint64_t memory_bytes) {
  const SocketPair control = open_socket_pair(SOCK_SEQPACKET);
  const pid_t parent = getpid();
  host_ = fork();
  if (host_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (host_ == 0) {
    close(control.ours);
    host_jobs(work, control.theirs, parent, limit_s, memory_bytes);
  }
  close(control.theirs);
  control_ = control.ours;
}

JobHost::~JobHost() {
  kill(host_, SIGKILL);
  waitpid(host_, nullptr, 0);
  close(control_);
}

int JobHost::start(const std::string& request) const {
  const SocketPair answer = open_socket_pair(SOCK_STREAM);
  const bool sent = send_descriptor(control_, answer.theirs);
  close(answer.theirs);
  if (!sent || !send_text(answer.ours, request)) {
    close(answer.ours);
    throw std::system_error(errno, std::generic_category(), "the process of the jobs");
  }
  shutdown(answer.ours, SHUT_WR);
  fcntl(answer.ours, F_SETFL, O_NONBLOCK);
  return answer.ours;
}

}  // namespace mwt
