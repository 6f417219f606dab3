#include "harness/explore/server/explore_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <set>

#include "harness/explore/testing/explorer_client.h"
#include "harness/run/machine/proc_file.h"

namespace mwt {
namespace {

using testing::answer_to;
using testing::answer_to_job;
using testing::Connection;
using ::testing::HasSubstr;
using testing::job_request;
using testing::status_of;
using testing::TestServer;

JobLimits short_limits() {
  JobLimits limits;
  limits.max_time_s = 1;
  limits.points_time_s = 5;
  limits.memory_bytes = std::uint64_t{1} << 28;
  return limits;
}

std::string get(const TestServer& server, const std::string& path, const std::string& host,
                const std::string& headers = "") {
  return answer_to(server.port(), "GET " + path + " HTTP/1.1\r\nHost: " + host + "\r\n" + headers + "\r\n");
}

const std::vector<Point> kSquare = {{0, 0}, {1, 0}, {1.1, 1}, {0, 1}};

std::string solve_with(const std::string& algorithm) {
  return R"({"job":"solve","algorithms":[{"name":")" + algorithm + R"("}],"optimum":false,"time_limit_s":1})";
}

void expect_alive(const TestServer& server) {
  EXPECT_THAT(answer_to_job(server, solve_with("well"), bytes_of(kSquare)), HasSubstr(R"("status":"ok")"));
}

TEST(ExploreServer, ServesThePageToItsAddressOnly) {
  const TestServer server(short_limits());
  EXPECT_THAT(get(server, server.path(), server.own_host()), HasSubstr("<title>MWT explorer</title>"));
  EXPECT_EQ(status_of(get(server, server.path() + "main.js", server.own_host())), "200");
  EXPECT_EQ(status_of(get(server, server.path() + "../main.js", server.own_host())), "404");
  EXPECT_EQ(status_of(get(server, server.path() + "%2e%2e/%2e%2e/etc/passwd", server.own_host())), "404");
  EXPECT_EQ(status_of(get(server, "/", server.own_host())), "403");
  EXPECT_EQ(status_of(get(server, "/" + std::string(32, '0') + "/", server.own_host())), "403");
}

TEST(ExploreServer, RefusesForeignHostsAndOrigins) {
  const TestServer server(short_limits());
  const std::string own = server.own_host();
  EXPECT_EQ(status_of(get(server, server.path(), "evil.example")), "403");
  EXPECT_EQ(status_of(get(server, server.path(), "127.0.0.1")), "403") << "another port";
  EXPECT_EQ(status_of(get(server, server.path(), own, "Host: evil.example\r\n")), "403");
  EXPECT_EQ(status_of(get(server, server.path(), own, "Origin: http://evil.example\r\n")), "403");
  EXPECT_EQ(status_of(get(server, server.path(), own, "Origin: null\r\n")), "403");
  EXPECT_EQ(status_of(get(server, server.path(), own, "Origin: https://" + own + "\r\n")), "403");
  EXPECT_EQ(status_of(get(server, server.path(), own, "Origin: http://" + own + "\r\n")), "200");
  const std::string request = job_request(server, solve_with("well"), bytes_of(kSquare), "Origin: http://evil\r\n");
  EXPECT_EQ(status_of(answer_to(server.port(), request)), "403");
}

TEST(ExploreServer, TellsWhatItDoesNotUnderstand) {
  const TestServer server(short_limits());
  EXPECT_THAT(answer_to_job(server, "{broken"), HasSubstr("the request is no JSON object"));
  EXPECT_THAT(answer_to_job(server, std::string(100'000, '[')), HasSubstr("the request is no JSON object"));
  EXPECT_THAT(answer_to_job(server, R"({"job":3})"), HasSubstr("no usable 'job'"));
  EXPECT_THAT(answer_to_job(server, R"({"job":"dance"})"), HasSubstr("unknown job 'dance'"));
  EXPECT_THAT(answer_to_job(server, solve_with("well"), "odd"), HasSubstr("no points"));
  EXPECT_THAT(answer_to_job(server, solve_with("none"), bytes_of(kSquare)), HasSubstr("unknown algorithm 'none'"));
  EXPECT_THAT(answer_to_job(server, R"({"job":"generate","family":"uniform","n":1000000000})"),
              HasSubstr("the explorer takes at most 1000000"));
  EXPECT_THAT(answer_to_job(server, R"({"job":"generate","family":"uniform","n":-5})"), HasSubstr("error"));
  EXPECT_THAT(answer_to_job(server, solve_with("well"), bytes_of(std::vector<Point>{{0, 0}, {1e308, 0}, {0, 1e308}})),
              HasSubstr("scale the points down"));
  EXPECT_THAT(answer_to_job(server, solve_with("well"), bytes_of(std::vector<Point>{{0, 0}, {1, 1}})),
              HasSubstr(R"("type":"error")"));
  EXPECT_THAT(answer_to_job(server, R"({"job":"hunt","algorithm":{"name":"well"},"n":100000})"),
              HasSubstr("a hunt is for"));
  EXPECT_THAT(
      answer_to_job(server, R"({"job":"prove","algorithm":{"name":"well"},"time_limit_s":1})", bytes_of(kSquare)),
      HasSubstr("well writes no proofs"));
  EXPECT_THAT(
      answer_to_job(server, R"({"job":"play","algorithm":{"name":"well"}})", bytes_of(std::vector<Point>(9999))),
      HasSubstr("at most 5000 are played"));
  EXPECT_THAT(
      answer_to_job(server, R"({"job":"play","algorithm":{"name":"crashes"},"time_limit_s":1})", bytes_of(kSquare)),
      HasSubstr("crashes: crashed"));
  EXPECT_THAT(answer_to_job(server, R"({"job":"open","name":"../../a.csv"})", "1,2\nx,3\n"), HasSubstr("a.csv:2"));
  expect_alive(server);
}

TEST(ExploreServer, RefusesBodiesItWouldReadWithoutALimit) {
  const TestServer server(short_limits());
  const std::string head = "POST " + server.path() + "job HTTP/1.1\r\nHost: " + server.own_host() + "\r\n";
  const std::string type = "Content-Type: application/octet-stream\r\n";
  EXPECT_EQ(status_of(answer_to(server.port(), head + type + "\r\n")), "400");
  EXPECT_EQ(status_of(answer_to(server.port(), head + type + "Transfer-Encoding: chunked\r\n\r\n")), "400");
  EXPECT_EQ(status_of(answer_to(server.port(), head + type + "Content-Length: 9\r\nContent-Encoding: gzip\r\n\r\n")),
            "400");
  EXPECT_EQ(status_of(answer_to(server.port(), head + "Content-Type: text/plain\r\nContent-Length: 2\r\n\r\n{}")),
            "415");
  EXPECT_EQ(status_of(answer_to(server.port(), head + type + "Content-Length: 99999999999\r\n\r\n")), "413");
  std::string ranges = "Range: bytes=0-1";
  while (ranges.size() < 8000) ranges += ",0-1";
  EXPECT_EQ(status_of(get(server, server.path(), server.own_host(), ranges + "\r\n")), "400");
  EXPECT_NE(status_of(get(server, "/" + std::string(100'000, 'a'), server.own_host())), "200");
  static_cast<void>(answer_to(server.port(), std::string(10, '\0') + "\r\n\r\n"));
  expect_alive(server);
}

TEST(ExploreServer, OutlivesAlgorithmsThatCrashHangOrEatMemory) {
  const TestServer server(short_limits());
  const std::string square = bytes_of(kSquare);
  EXPECT_THAT(answer_to_job(server, solve_with("crashes"), square), HasSubstr(R"("status":"crashed")"));
  EXPECT_THAT(answer_to_job(server, solve_with("leaves"), square), HasSubstr(R"("status":"crashed")"));
  EXPECT_THAT(answer_to_job(server, solve_with("hangs"), square), HasSubstr(R"("status":"timeout")"));
  EXPECT_THAT(answer_to_job(server, solve_with("loops"), square), HasSubstr(R"("status":"timeout")"));
  EXPECT_THAT(answer_to_job(server, solve_with("throws"), square), HasSubstr(R"("status":"error")"));
  EXPECT_THAT(answer_to_job(server, solve_with("invalid"), square), HasSubstr(R"("status":"invalid_output")"));
  EXPECT_THAT(answer_to_job(server, solve_with("declines"), square), HasSubstr(R"("status":"not_applicable")"));
  if (testing::kUsualAllocator) {
    EXPECT_THAT(answer_to_job(server, solve_with("allocates"), square), HasSubstr(R"("status":"out_of_memory")"));
  }
  expect_alive(server);
}

TEST(ExploreServer, ClaimsThatAreDisprovedAreTold) {
  const TestServer server(short_limits());
  EXPECT_THAT(answer_to_job(server, solve_with("claims"), bytes_of(kSquare)), HasSubstr("CONTRADICTION"));
}

TEST(ExploreServer, EndsTheJobsOfPagesThatHaveGone) {
  const TestServer server(short_limits(), 1, 0);
  {
    const Connection page(server.port());
    page.send(job_request(server, solve_with("hangs"), bytes_of(kSquare)));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(status_of(answer_to_job(server, solve_with("well"), bytes_of(kSquare))), "503");
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));  // it would hang for four seconds
  expect_alive(server);
}

TEST(ExploreServer, ThousandRequestsAtOnceAreAnsweredOrRefused) {
  const TestServer server(short_limits());
  std::atomic<int> done = 0, refused = 0;
  std::vector<std::thread> pages;
  for (int i = 0; i < 1000; ++i) {
    pages.emplace_back([&] {
      const std::string answer = answer_to_job(server, solve_with("well"), bytes_of(kSquare));
      if (status_of(answer) == "503") ++refused;
      if (answer.find(R"("type":"end")") != std::string::npos) ++done;
    });
  }
  for (std::thread& page : pages) page.join();
  EXPECT_EQ(done + refused, 1000);
  EXPECT_GE(done, 18);
  expect_alive(server);
  EXPECT_LT(kilobytes_in("/proc/self/status", "VmRSS:").value_or(0), 1'000'000U);
}

TEST(ExploreServer, SlowHeadsKeepNobodyWaiting) {
  const TestServer server(short_limits());
  std::vector<std::unique_ptr<Connection>> slow;
  for (int i = 0; i < 200; ++i) {
    slow.push_back(std::make_unique<Connection>(server.port()));
    ASSERT_TRUE(slow.back()->send("GET / HTTP/1.1\r\nHost: "));
  }
  const auto begin = std::chrono::steady_clock::now();
  expect_alive(server);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

TEST(ExploreServer, KeepsPointsForLinks) {
  const TestServer server(short_limits());
  const std::string bytes = bytes_of(kSquare);
  const std::string head = "POST " + server.path() + "keep HTTP/1.1\r\nHost: " + server.own_host() +
                           "\r\nContent-Type: application/octet-stream\r\nContent-Length: ";
  const std::string answer = answer_to(server.port(), head + std::to_string(bytes.size()) + "\r\n\r\n" + bytes);
  EXPECT_EQ(status_of(answer), "200");
  const std::string name = answer.substr(answer.find("\r\n\r\n") + 4);
  EXPECT_THAT(get(server, server.path() + "kept/" + name, server.own_host()), HasSubstr(bytes));
  EXPECT_EQ(status_of(get(server, server.path() + "kept/other", server.own_host())), "404");
  EXPECT_EQ(status_of(answer_to(server.port(), head + "3\r\n\r\nodd")), "400");
}

TEST(ExploreServer, TakesPointsOfEveryKindOrSaysWhatIsWrong) {
  const TestServer server(short_limits());
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto solved = [&](const std::vector<Point>& points) {
    return answer_to_job(server, solve_with("well"), bytes_of(points));
  };
  EXPECT_THAT(solved({{0, 0}, {1, 0}, {std::nan(""), 1}}), HasSubstr(R"("type":"error")"));
  EXPECT_THAT(solved({{0, 0}, {1, 0}, {kInfinity, 1}}), HasSubstr(R"("type":"error")"));
  EXPECT_THAT(solved({{0, 0}, {1, 1}, {2, 2}}), HasSubstr("on one line"));
  EXPECT_THAT(solved(std::vector<Point>(1000, Point{1, 1})), HasSubstr(R"("type":"error")"));
  EXPECT_THAT(solved({{0, 0}, {1, 0}, {0, 1}, {0, 1}, {-0.0, 0}}), HasSubstr(R"("duplicates":2)"));
  EXPECT_THAT(solved({{0, 0}, {5e-324, 0}, {0, 5e-324}}), HasSubstr(R"("status":"ok")"));
  EXPECT_THAT(solved({}), HasSubstr(R"("type":"error")"));
}

TEST(ExploreServer, BrokenFramesAreTold) {
  const TestServer server(short_limits());
  const std::string head = "POST " + server.path() + "job HTTP/1.1\r\nHost: " + server.own_host() +
                           "\r\nContent-Type: application/octet-stream\r\nContent-Length: ";
  const std::string whole = encoded({solve_with("well"), bytes_of(kSquare)});
  for (const std::string& body : {std::string(), std::string("x"), std::string(8, '\xff'), whole.substr(0, 40),
                                  whole + "more", std::string(1'000'000, '\0')}) {
    EXPECT_THAT(answer_to(server.port(), head + std::to_string(body.size()) + "\r\n\r\n" + body),
                HasSubstr("the request is no frame"));
  }
  // Fewer bytes than the head states: no answer, but the thread is free after a while.
  const Connection short_body(server.port());
  ASSERT_TRUE(short_body.send(head + "100\r\n\r\nabc"));
  expect_alive(server);
}

// The processes whose parent this one is.
std::set<pid_t> children_of(pid_t parent) {
  std::ifstream file("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children");
  return {std::istream_iterator<pid_t>(file), {}};
}

// The only process that a parent has started since; 0 if there is another number of them.
pid_t new_child_of(pid_t parent, const std::set<pid_t>& before = {}) {
  std::vector<pid_t> added;
  std::ranges::set_difference(children_of(parent), before, std::back_inserter(added));
  return added.size() == 1 ? added.front() : 0;
}

// Or is a zombie, whose parent may be anybody.
bool has_ended(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string number, name, state;
  file >> number >> name >> state;
  return !file || state == "Z";
}

TEST(ExploreServer, OutlivesKilledJobsAndWorkers) {
  const std::set<pid_t> before = children_of(getpid());
  const TestServer server(short_limits());
  const pid_t host = new_child_of(getpid(), before);
  ASSERT_NE(host, 0);
  for (const bool kills_worker : {false, true}) {
    const Connection page(server.port());
    page.send(job_request(server, solve_with("hangs"), bytes_of(kSquare)));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const pid_t job = new_child_of(host);
    ASSERT_NE(job, 0);
    const pid_t worker = new_child_of(job);
    ASSERT_NE(worker, 0);
    kill(kills_worker ? worker : job, SIGKILL);
    const std::string answer = page.read();
    if (kills_worker) {
      EXPECT_THAT(answer, HasSubstr(R"("status":"out_of_memory")")) << "what the system kills is taken for that";
    } else {
      EXPECT_THAT(answer, ::testing::Not(HasSubstr(R"("type":"end")")));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_TRUE(has_ended(worker));
    expect_alive(server);
  }
}

TEST(ExploreServer, SaysSoWhenTheProcessOfTheJobsIsKilled) {
  const std::set<pid_t> before = children_of(getpid());
  const TestServer server(short_limits());
  const pid_t host = new_child_of(getpid(), before);
  ASSERT_NE(host, 0);
  kill(host, SIGKILL);
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_THAT(answer_to_job(server, solve_with("well"), bytes_of(kSquare)), HasSubstr("start it again"));
  EXPECT_EQ(status_of(get(server, server.path(), server.own_host())), "200");
}

}  // namespace
}  // namespace mwt
