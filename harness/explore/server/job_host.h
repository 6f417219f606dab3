// Jobs in processes of their own, started by a process that has no threads: a server with threads must not fork.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>

#include "harness/explore/frame.h"

namespace mwt {

/// Where a job sends its answer, frame by frame. Ends the job's process when nobody reads any more.
class JobAnswer {
 public:
  explicit JobAnswer(int socket) : socket_(socket) {}

  void send(const Frame& frame) const;

  /// To be called at least every 50 ms or so: does not return once the reader has gone.
  void require_reader() const;

 private:
  int socket_;
};

/// A process beside this one that forks another one for every job. Linux.
class JobHost {
 public:
  /// What a job's process does with its request. It may start processes (ProcessPool); they end with it.
  using Work = std::function<void(const std::string& request, const JobAnswer& answer)>;

  /// Precondition: the calling process is single-threaded, and the calling thread outlives the host.
  /// A job that takes longer than `limit_s` in all, or more data than `memory_bytes` beyond what it has when it begins,
  /// ends without more of an answer.
  JobHost(const Work& work, unsigned limit_s, std::uint64_t memory_bytes);
  ~JobHost();
  JobHost(const JobHost&) = delete;
  JobHost& operator=(const JobHost&) = delete;

  /// Starts a job and gives it the request. Returns a descriptor that does not block, from which the encoded frames of
  /// the answer can be read up to its end; closing it earlier ends the job. Thread-safe. Throws std::system_error.
  [[nodiscard]] int start(const std::string& request) const;

 private:
  pid_t host_ = -1;
  int control_ = -1;
};

}  // namespace mwt
