#include "harness/explore/server/connection_threads.h"

#include <sys/socket.h>
#include <unistd.h>

#include <exception>
#include <utility>

namespace mwt {

ConnectionThreads::ConnectionThreads(std::size_t threads, std::size_t max_waiting, Serve serve)
    : max_waiting_(max_waiting), serve_(std::move(serve)) {
  for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

ConnectionThreads::~ConnectionThreads() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    for (const int socket : served_) shutdown(socket, SHUT_RDWR);  // so that nobody waits for them any more
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  for (const int socket : waiting_) close(socket);
}

void ConnectionThreads::add(int socket) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return waiting_.size() < max_waiting_ || ends_; });
  waiting_.push_back(socket);
  lock.unlock();
  changed_.notify_all();
}

void ConnectionThreads::work() {
  for (;;) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !waiting_.empty() || ends_; });
    if (ends_) return;
    const int socket = waiting_.front();
    waiting_.pop_front();
    served_.insert(socket);
    lock.unlock();
    changed_.notify_all();
    serve_and_close(socket);
  }
}

void ConnectionThreads::serve_and_close(int socket) {
  try {
    serve_(socket);
  } catch (const std::exception&) {  // out of memory while its head was read
  }
  shutdown(socket, SHUT_RDWR);
  const std::lock_guard lock(mutex_);
  served_.erase(socket);
  close(socket);
}

}  // namespace mwt
