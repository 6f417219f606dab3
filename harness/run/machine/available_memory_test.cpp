#include "harness/run/machine/available_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "harness/run/machine/proc_file.h"
#include "harness/run/process_pool.h"

namespace mwt {
namespace {

TEST(AvailableMemory, IsLessThanTheMachineHas) {
  const std::optional<std::uint64_t> available = available_memory_bytes();
  ASSERT_TRUE(available);
  EXPECT_GT(*available, 0U);
  EXPECT_LE(*available, kilobytes_in("/proc/meminfo", "MemTotal:").value() * 1024);
}

// In a process of its own, because a hard limit stays.
TEST(AvailableMemory, IsWhatARunOfAStudyMayTake) {
  constexpr std::uint64_t kLimit = std::uint64_t{1} << 28;
  ProcessPool pool(1);
  std::string answer;
  pool.start([] { return std::to_string(available_memory_bytes().value_or(0)); }, {60, 60, kLimit},
             [&](const ProcessResult& result) { answer = result.output; });
  while (!pool.is_empty()) pool.wait(std::chrono::milliseconds(100));
  ASSERT_FALSE(answer.empty());
  EXPECT_LT(std::stoull(answer), 2 * kLimit);  // what the child frees of its inheritance is added to the limit
  EXPECT_GT(std::stoull(answer), kLimit / 2);
}

}  // namespace
}  // namespace mwt
