// Connections whose request has not begun: they wait here, not in a thread each, so that slow ones keep nobody busy.
#pragma once

#include <poll.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <list>
#include <mutex>
#include <thread>
#include <vector>

namespace mwt {

struct ArrivalLimits {
  std::size_t connections = 400;  ///< that wait at a time
  std::size_t head_bytes = std::size_t{16} << 10;
  std::chrono::milliseconds patience{3000};   ///< how long a head may take to arrive
  std::chrono::milliseconds protection{300};  ///< how long it may if there are more connections than that
};

/// Watches connections with one thread and passes each on when the head of its request, up to the blank line, is there.
/// Closes those that are closed at the other end, take too long, or send a longer head without a blank line.
class ArrivingRequests {
 public:
  using Arrived = std::function<void(int socket)>;  ///< takes the connection over; may wait

  ArrivingRequests(const ArrivalLimits& limits, Arrived arrived);
  /// Closes those that still wait.
  ~ArrivingRequests();
  ArrivingRequests(const ArrivingRequests&) = delete;
  ArrivingRequests& operator=(const ArrivingRequests&) = delete;

  /// Takes the connection over. Where so many wait already, first waits until there is room, at the latest until the
  /// oldest has had its protection and is closed. Thread-safe.
  void add(int socket);

 private:
  using Clock = std::chrono::steady_clock;
  struct Waiting {
    int socket;
    Clock::time_point since;
  };
  enum class State { waits, has_arrived, is_hopeless };

  void watch();
  [[nodiscard]] std::vector<int> take_arrived(const std::vector<pollfd>& watched);
  [[nodiscard]] State state_of(int socket, int events);
  void wake() const;

  ArrivalLimits limits_;
  Arrived arrived_;
  int wake_ = -1;  // readable when there is something new to watch
  std::mutex mutex_;
  std::condition_variable has_room_;
  std::list<Waiting> waiting_;  // the oldest first
  std::vector<char> head_;      // as long as one may be; used by the thread alone
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace mwt
