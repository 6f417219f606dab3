#include "harness/explore/server/explore_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

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

}  // namespace
}  // namespace mwt
