// Threads that serve connections.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace mwt {

/// Serves each connection in one of its threads and closes it. A connection that fails ends alone.
class ConnectionThreads {
 public:
  using Serve = std::function<void(int socket)>;  ///< what it throws ends this connection

  ConnectionThreads(std::size_t threads, std::size_t max_waiting, Serve serve);
  /// Ends all connections, those that are being served, too.
  ~ConnectionThreads();
  ConnectionThreads(const ConnectionThreads&) = delete;
  ConnectionThreads& operator=(const ConnectionThreads&) = delete;

  /// Takes the connection over. While all threads are busy and so many wait, this waits, too. Thread-safe.
  void add(int socket);

 private:
  void work();
  void serve_and_close(int socket);

  std::size_t max_waiting_;
  Serve serve_;
  std::vector<std::thread> threads_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<int> waiting_;
  std::set<int> served_;
  bool ends_ = false;
};

}  // namespace mwt
