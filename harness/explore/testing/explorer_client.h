// For tests: a server on test algorithms, and a client that can send anything.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include "harness/explore/jobs.h"
#include "harness/explore/server/explore_server.h"
#include "harness/run/testing/algorithms_testing.h"

namespace mwt::testing {

/// The server, served by a thread of its own. The host is first: it forks while the process has one thread.
class TestServer {
 public:
  explicit TestServer(const JobLimits& limits, int parallel_jobs = 2, int waiting_jobs = 16)
      : catalogue_(test_catalogue()),
        limits_(limits),
        host_([this](const std::string& request,
                     const JobAnswer& answer) { do_job(catalogue_, limits_, request, answer); },
              limits_.job_time_s(), limits_.job_memory_bytes()),
        server_(host_, options(parallel_jobs, waiting_jobs)),
        thread_([this] { server_.serve(); }) {}
  ~TestServer() {
    server_.stop();
    thread_.join();
  }
  TestServer(const TestServer&) = delete;
  TestServer& operator=(const TestServer&) = delete;

  [[nodiscard]] int port() const { return std::stoi(server_.address().substr(std::strlen("http://127.0.0.1:"))); }
  /// "/TOKEN/"
  [[nodiscard]] std::string path() const {
    const std::string address = server_.address();
    return address.substr(address.find('/', std::strlen("http://")));
  }
  [[nodiscard]] std::string own_host() const { return "127.0.0.1:" + std::to_string(port()); }

 private:
  static ExploreOptions options(int parallel_jobs, int waiting_jobs) {
    ExploreOptions options;
    options.parallel_jobs = parallel_jobs;
    options.waiting_jobs = waiting_jobs;
    options.catalogue = "{}";
    return options;
  }

  Catalogue catalogue_;
  JobLimits limits_;
  JobHost host_;
  ExploreServer server_;
  std::thread thread_;
};

/// A connection to the loopback address.
class Connection {
 public:
  explicit Connection(int port) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_open_ = connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    const timeval patience{60, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~Connection() { close(socket_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool send(const std::string& text) const {
    return is_open_ && ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(text.size());
  }

  /// All up to the end.
  [[nodiscard]] std::string read() const {
    std::string text;
    std::array<char, 1 << 16> block;
    for (;;) {
      const ssize_t size = recv(socket_, block.data(), block.size(), 0);
      if (size <= 0) return text;
      text.append(block.data(), static_cast<std::size_t>(size));
    }
  }

 private:
  int socket_;
  bool is_open_ = false;
};

/// What the server answers to these bytes.
inline std::string answer_to(int port, const std::string& request) {
  const Connection connection(port);
  connection.send(request);
  return connection.read();
}

/// "200", "403"; empty without an answer.
inline std::string status_of(const std::string& answer) { return answer.size() < 12 ? "" : answer.substr(9, 3); }

/// A request for a job as the page sends it.
inline std::string job_request(const TestServer& server, const std::string& json, const std::string& bytes = "",
                               const std::string& headers = "") {
  const std::string body = encoded({json, bytes});
  return "POST " + server.path() + "job HTTP/1.1\r\nHost: " + server.own_host() +
         "\r\nContent-Type: application/octet-stream\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" +
         headers + "\r\n" + body;
}

/// What a job answers, undivided: enough to look for texts in it.
inline std::string answer_to_job(const TestServer& server, const std::string& json, const std::string& bytes = "") {
  return answer_to(server.port(), job_request(server, json, bytes));
}

}  // namespace mwt::testing
