#include "harness/explore/server/arriving_requests.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <ctime>
#include <string>

namespace mwt {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

// Both ends of a connection over the loopback address. Closes the page's.
class LoopbackConnection {
 public:
  LoopbackConnection() {
    const int listening = socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(listening, reinterpret_cast<const sockaddr*>(&address), size);
    listen(listening, 1);
    getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size);
    page_ = socket(AF_INET, SOCK_STREAM, 0);
    connect(page_, reinterpret_cast<const sockaddr*>(&address), size);
    server_ = accept(listening, nullptr, nullptr);
    close(listening);
  }
  ~LoopbackConnection() { close(page_); }
  LoopbackConnection(const LoopbackConnection&) = delete;
  LoopbackConnection& operator=(const LoopbackConnection&) = delete;

  [[nodiscard]] int server() const { return server_; }
  void send(const std::string& text) const { ::send(page_, text.data(), text.size(), MSG_NOSIGNAL); }

  // Whether the server's end is closed within that time.
  [[nodiscard]] bool is_closed_within(milliseconds time) const {
    const timeval patience{time.count() / 1000, time.count() % 1000 * 1000};
    setsockopt(page_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    char byte = 0;
    const ssize_t size = recv(page_, &byte, 1, 0);
    return size == 0 || (size < 0 && errno == ECONNRESET);
  }

 private:
  int page_ = -1;
  int server_ = -1;
};

// What arrives is counted and closed.
struct Arrivals {
  explicit Arrivals(const ArrivalLimits& limits)
      : requests(limits, [this](int socket) {
          close(socket);
          ++count;
        }) {}

  [[nodiscard]] bool become(int wanted) const {
    for (const Clock::time_point end = Clock::now() + milliseconds(2000); Clock::now() < end; usleep(1000)) {
      if (count == wanted) return true;
    }
    return false;
  }

  std::atomic<int> count = 0;
  ArrivingRequests requests;
};

TEST(ArrivingRequests, PassesOnWhatIsCompleteHoweverItComes) {
  Arrivals arrivals({});
  const LoopbackConnection whole, parts;
  arrivals.requests.add(parts.server());
  parts.send("GET / HTTP/1.1\r\nHo");
  arrivals.requests.add(whole.server());
  whole.send("GET / HTTP/1.1\r\n\r\nbody");
  EXPECT_TRUE(arrivals.become(1)) << "the slow one before keeps nobody waiting";
  parts.send("st: a\r\n");
  usleep(20'000);
  parts.send("\r");
  usleep(20'000);
  EXPECT_EQ(arrivals.count, 1);
  parts.send("\n");
  EXPECT_TRUE(arrivals.become(2));
}

TEST(ArrivingRequests, ClosesWhatTakesTooLongOrIsTooLong) {
  ArrivalLimits limits;
  limits.patience = milliseconds(200);
  limits.head_bytes = 1000;
  Arrivals arrivals(limits);
  const LoopbackConnection silent, slow, long_head;
  for (const LoopbackConnection* each : {&silent, &slow, &long_head}) arrivals.requests.add(each->server());
  slow.send("GET / HT");
  long_head.send(std::string(1000, 'a'));
  EXPECT_TRUE(long_head.is_closed_within(milliseconds(150)));
  EXPECT_TRUE(slow.is_closed_within(milliseconds(1000)));
  EXPECT_TRUE(silent.is_closed_within(milliseconds(1000)));
  EXPECT_EQ(arrivals.count, 0);
}

TEST(ArrivingRequests, MakesRoomForNewOnes) {
  ArrivalLimits limits;
  limits.connections = 2;
  limits.protection = milliseconds(50);
  Arrivals arrivals(limits);
  const LoopbackConnection first, second, third;
  for (const LoopbackConnection* each : {&first, &second, &third}) arrivals.requests.add(each->server());
  EXPECT_TRUE(first.is_closed_within(milliseconds(1000)));
  third.send("GET / HTTP/1.1\r\n\r\n");
  EXPECT_TRUE(arrivals.become(1));
  EXPECT_FALSE(second.is_closed_within(milliseconds(20)));
}

TEST(ArrivingRequests, TakesNoTimeWhilePartsWait) {
  Arrivals arrivals({});
  const LoopbackConnection slow;
  arrivals.requests.add(slow.server());
  slow.send("GET /");
  const std::clock_t begin = std::clock();
  usleep(300'000);
  EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC / 10);
}

}  // namespace
}  // namespace mwt
