#include "harness/explore/server/arriving_requests.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace mwt {

ArrivingRequests::ArrivingRequests(const ArrivalLimits& limits, Arrived arrived)
    : limits_(limits),
      arrived_(std::move(arrived)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)),
      head_(limits.head_bytes) {
  if (wake_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  thread_ = std::thread([this] { watch(); });
}

ArrivingRequests::~ArrivingRequests() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  has_room_.notify_all();
  wake();
  thread_.join();
  for (const Waiting& each : waiting_) close(each.socket);
  close(wake_);
}

void ArrivingRequests::wake() const {
  const std::uint64_t one = 1;
  static_cast<void>(write(wake_, &one, sizeof one));  // fails only if it is readable anyway
}

void ArrivingRequests::add(int socket) {
  std::unique_lock lock(mutex_);
  while (waiting_.size() >= limits_.connections && !ends_) {
    const Clock::time_point end = waiting_.front().since + limits_.protection;
    if (Clock::now() >= end) {
      close(waiting_.front().socket);
      waiting_.pop_front();
    } else {
      has_room_.wait_until(lock, end);
    }
  }
  waiting_.push_back({socket, Clock::now()});
  lock.unlock();
  wake();
}

void ArrivingRequests::watch() {
  for (;;) {
    std::vector<pollfd> watched = {{wake_, POLLIN, 0}};
    Clock::time_point end = Clock::now() + std::chrono::hours(1);
    {
      const std::lock_guard lock(mutex_);
      if (ends_) return;
      if (!waiting_.empty()) end = waiting_.front().since + limits_.patience;
      for (const Waiting& each : waiting_) watched.push_back({each.socket, POLLIN | POLLRDHUP, 0});
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    poll(watched.data(), watched.size(), static_cast<int>(std::max<std::int64_t>(0, left.count())));
    std::uint64_t ignored = 0;
    static_cast<void>(read(wake_, &ignored, sizeof ignored));
    for (const int socket : take_arrived(watched)) arrived_(socket);
  }
}

// Connections that were closed since poll(), and others in the place of their descriptors, are looked at no more than
// once too often.
std::vector<int> ArrivingRequests::take_arrived(const std::vector<pollfd>& watched) {
  std::vector<int> arrived;
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  std::size_t position = 1;
  for (auto each = waiting_.begin(); each != waiting_.end();) {
    while (position < watched.size() && watched[position].fd != each->socket) ++position;
    const int events = position < watched.size() ? watched[position].revents : 0;
    State state = events == 0 ? State::waits : state_of(each->socket, events);
    if (state == State::waits && now >= each->since + limits_.patience) state = State::is_hopeless;
    if (state == State::waits) {
      ++each;
      continue;
    }
    if (state == State::has_arrived) {
      arrived.push_back(each->socket);
    } else {
      close(each->socket);
    }
    each = waiting_.erase(each);
  }
  has_room_.notify_all();
  return arrived;
}

// Leaves what it reads where it is. A connection with a part of its head is looked at again when there is more.
ArrivingRequests::State ArrivingRequests::state_of(int socket, int events) {
  const ssize_t size = recv(socket, head_.data(), head_.size(), MSG_PEEK | MSG_DONTWAIT);
  if (size < 0) return errno == EAGAIN || errno == EINTR ? State::waits : State::is_hopeless;
  const std::string_view head(head_.data(), static_cast<std::size_t>(size));
  const bool has_arrived = head.find("\r\n\r\n") != std::string_view::npos;
  const bool is_hopeless = head.size() == head_.size() || (events & (POLLRDHUP | POLLHUP | POLLERR)) != 0;
  if (!has_arrived && is_hopeless) return State::is_hopeless;
  const int enough = has_arrived ? 1 : static_cast<int>(size) + 1;
  setsockopt(socket, SOL_SOCKET, SO_RCVLOWAT, &enough, sizeof enough);
  return has_arrived ? State::has_arrived : State::waits;
}

}  // namespace mwt
