#include "harness/explore/server/connection_threads.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace mwt {
namespace {

std::array<int, 2> connected_pair() {
  std::array<int, 2> ends{};
  EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()), 0);
  return ends;
}

// What arrives at this end up to its end.
std::string received(int socket) {
  std::string text;
  char byte = 0;
  while (recv(socket, &byte, 1, 0) == 1) text += byte;
  close(socket);
  return text;
}

TEST(ConnectionThreads, ServeAndCloseAlsoAfterAFailure) {
  ConnectionThreads threads(1, 1, [](int socket) {
    char byte = 0;
    if (recv(socket, &byte, 1, 0) != 1 || byte == 'x') throw std::runtime_error("fails");
    send(socket, "answer", 6, MSG_NOSIGNAL);
  });
  for (const char* const request : {"a", "x", "b"}) {
    const auto [page, server] = connected_pair();
    send(page, request, 1, 0);
    threads.add(server);
    EXPECT_EQ(received(page), *request == 'x' ? "" : "answer");
  }
}

TEST(ConnectionThreads, EndWithoutWaitingForThoseThatSaySomethingNoMore) {
  const auto [page, server] = connected_pair();
  const auto [other_page, other_server] = connected_pair();
  {
    ConnectionThreads threads(1, 1, [](int socket) {
      char byte = 0;
      while (recv(socket, &byte, 1, 0) == 1) {
      }
    });
    threads.add(server);
    threads.add(other_server);
    usleep(20'000);
  }
  EXPECT_EQ(received(page), "");
  EXPECT_EQ(received(other_page), "");
}

}  // namespace
}  // namespace mwt
