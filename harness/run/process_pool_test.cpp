#include "harness/run/process_pool.h"

#include <gtest/gtest.h>

#include <map>

#include "harness/run/testing/algorithms_testing.h"

namespace mwt {
namespace {

using namespace std::chrono_literals;
constexpr ProcessLimits kGenerous{20, 20, std::uint64_t{1} << 30};

ProcessResult run(const ProcessPool::Work& work, const ProcessLimits& limits = kGenerous) {
  ProcessPool pool(1);
  ProcessResult result;
  pool.start(work, limits, [&](const ProcessResult& ended) { result = ended; });
  while (!pool.is_empty()) pool.wait(1s);
  return result;
}

TEST(ProcessPool, BringsBackTheResult) {
  const ProcessResult result = run([] { return std::string(300000, 'x'); });
  EXPECT_EQ(result.end, ProcessEnd::finished);
  EXPECT_EQ(result.output, std::string(300000, 'x'));
}

TEST(ProcessPool, NothingTheChildDoesChangesTheParent) {
  int value = 1;
  run([&] {
    value = 2;
    std::puts("this goes nowhere");
    return std::string("done");
  });
  EXPECT_EQ(value, 1);
}

TEST(ProcessPool, ACrashIsToldBySignal) {
  const ProcessResult result = run([]() -> std::string {
    std::signal(SIGSEGV, SIG_DFL);
    std::raise(SIGSEGV);
    return "not reached";
  });
  EXPECT_EQ(result.end, ProcessEnd::crashed);
  EXPECT_NE(result.how.find("signal 11"), std::string::npos) << result.how;
}

TEST(ProcessPool, AnEndWithoutResultIsACrashWithItsLastWords) {
  const ProcessResult result = run([]() -> std::string {
    std::fputs(std::string(5000, '.').append("last words\n").c_str(), stderr);
    std::fflush(stderr);
    _exit(0);
  });
  EXPECT_EQ(result.end, ProcessEnd::crashed);
  EXPECT_TRUE(result.error_tail.ends_with("last words"));
  EXPECT_LE(result.error_tail.size(), 500u);
}

TEST(ProcessPool, AnExceptionIsACrashThatSaysWhat) {
  const ProcessResult result = run([]() -> std::string { throw std::runtime_error("lost"); });
  EXPECT_EQ(result.end, ProcessEnd::crashed);
  EXPECT_EQ(result.error_tail, "lost");
}

TEST(ProcessPool, KillsTheWholeGroupAtTheWallLimit) {
  const auto begin = std::chrono::steady_clock::now();
  const ProcessResult result = run(
      []() -> std::string {
        if (fork() == 0) pause();  // a grandchild that keeps the pipes open
        pause();
        return "not reached";
      },
      {0.2, 20, std::uint64_t{1} << 30});
  EXPECT_EQ(result.end, ProcessEnd::stopped_at_limit);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

TEST(ProcessPool, AChildThatClosesItsPipesIsStillWatched) {
  const ProcessResult result = run(
      []() -> std::string {
        for (int descriptor = 0; descriptor < 64; ++descriptor) close(descriptor);
        pause();
        return "not reached";
      },
      {0.2, 20, std::uint64_t{1} << 30});
  EXPECT_EQ(result.end, ProcessEnd::stopped_at_limit);
}

TEST(ProcessPool, StopsAtTheCpuLimit) {
  const ProcessResult result = run(
      []() -> std::string {
        volatile std::uint64_t count = 0;
        while (count < std::uint64_t(-1)) count = count + 1;
        return "not reached";
      },
      {20, 1, std::uint64_t{1} << 30});
  EXPECT_EQ(result.end, ProcessEnd::stopped_at_limit);
}

// A limit of CPU time set in the child itself would let its CPU clock stand still between scheduler ticks.
TEST(ProcessPool, TheCpuClockOfAChildDoesNotTick) {
  const ProcessResult result = run([] {
    const auto cpu_time = [] {
      timespec time{};
      clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
      return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    };
    int steps = 0;
    const auto begin = cpu_time();
    for (auto last = begin; last < begin + 20ms;) {
      const auto next = cpu_time();
      if (next != last) ++steps;
      last = next;
    }
    return std::to_string(steps);
  });
  EXPECT_GT(std::stoi(result.output), 200) << "of 20 ms: one that ticks makes 2 to 20 steps";
}

TEST(ProcessPool, AKillByOthersIsToldApart) {
  const ProcessResult result = run([]() -> std::string {
    kill(getpid(), SIGKILL);
    return "not reached";
  });
  EXPECT_EQ(result.end, ProcessEnd::killed);
}

TEST(ProcessPool, MemoryBeyondTheLimitIsRefused) {
  if (!testing::kUsualAllocator) GTEST_SKIP() << "a refusal ends the process";
  const ProcessResult result = run(
      [] {
        try {
          const std::vector<char> block(std::size_t{1} << 28, 'x');
          return std::string("had it all: ") + block[1];
        } catch (const std::bad_alloc&) {
          return std::string("refused");
        }
      },
      {20, 20, std::uint64_t{1} << 26});
  EXPECT_EQ(result.output, "refused");
}

TEST(ProcessPool, RunsSideBySideAndStartsMoreFromWhenDone) {
  ProcessPool pool(2);
  std::map<std::string, int> seen;
  const auto begin = std::chrono::steady_clock::now();
  const auto nap = [](const std::string& name) {
    return [name] {
      usleep(200000);
      return name;
    };
  };
  pool.start(nap("a"), kGenerous, [&](const ProcessResult& a) {
    ++seen[a.output];
    pool.start([] { return std::string("c"); }, kGenerous, [&](const ProcessResult& c) { ++seen[c.output]; });
  });
  pool.start(nap("b"), kGenerous, [&](const ProcessResult& b) { ++seen[b.output]; });
  EXPECT_TRUE(pool.is_full());
  while (!pool.is_empty()) pool.wait(1s);
  EXPECT_EQ(seen, (std::map<std::string, int>{{"a", 1}, {"b", 1}, {"c", 1}}));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 5s);
}

}  // namespace
}  // namespace mwt
