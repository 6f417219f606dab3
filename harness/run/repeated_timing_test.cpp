#include "harness/run/repeated_timing.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

#include "base/cpu_clock.h"

namespace mwt {
namespace {

/// Uses the CPU for so long.
void work_for(double seconds) {
  const double end = process_cpu_time_s() + seconds;
  while (process_cpu_time_s() < end) {
  }
}

TEST(RepeatedTiming, LongWorkIsDoneOnce) {
  int calls = 0;
  const RepeatedTiming timing = time_repeatedly([&] { ++calls, work_for(0.011); }, 0.01);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(timing.executions, 1u);
  EXPECT_GE(timing.cpu_time_s, 0.011);
}

TEST(RepeatedTiming, ShortWorkIsDoneUntilItCanBeTimed) {
  std::uint64_t calls = 0;
  const double begin = process_cpu_time_s();
  const RepeatedTiming timing = time_repeatedly([&] { ++calls, work_for(1e-4); }, 0.01);
  EXPECT_GE(process_cpu_time_s() - begin, 0.01);
  EXPECT_GE(timing.executions, 5u);
  EXPECT_EQ(timing.executions + 1, calls) << "the first one, which is cold, does not count";
  EXPECT_GE(timing.cpu_time_s, 1e-4);
}

// The mean over all executions would be above 5 ms.
TEST(RepeatedTiming, OneDisturbedExecutionDoesNotCount) {
  int calls = 0;
  const RepeatedTiming timing = time_repeatedly([&] { work_for(++calls == 10 ? 0.5 : 1e-3); }, 0.1);
  EXPECT_GE(timing.cpu_time_s, 1e-3);
  EXPECT_LT(timing.cpu_time_s, 3e-3);
}

TEST(RepeatedTiming, WorkThatDoesNotUseTheCpuEnds) {
  int calls = 0;
  const auto begin = std::chrono::steady_clock::now();
  static_cast<void>(time_repeatedly([&] { ++calls, usleep(100); }, 0.002));
  EXPECT_GE(calls, 6);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
  calls = 0;
  static_cast<void>(time_repeatedly([&] { ++calls, usleep(21000); }, 0.002));
  EXPECT_EQ(calls, 1);
}

TEST(RepeatedTiming, AsManyExecutionsAsAskedForByZero) {
  int calls = 0;
  static_cast<void>(time_repeatedly([&] { ++calls; }, 0));
  EXPECT_EQ(calls, 1);
}

TEST(RepeatedTiming, WhatIsThrownComesOut) {
  EXPECT_THROW(static_cast<void>(time_repeatedly([] { throw std::runtime_error("no"); }, 0.01)), std::runtime_error);
}

}  // namespace
}  // namespace mwt
