#include "harness/run/machine/event_counts.h"

#include <gtest/gtest.h>

#include <cstdint>

namespace mwt {
namespace {

EventCounts counts_of_loop(std::uint32_t steps) {
  EventCounter counter;
  volatile std::uint32_t sum = 0;
  for (std::uint32_t i = 0; i < steps; ++i) sum = sum + i;
  return counter.stop();
}

// Where the machine counts nothing, as most virtual machines, nothing is what there is to see.
TEST(EventCounts, CountsGrowWithTheWorkWhereTheMachineCounts) {
  const EventCounts few = counts_of_loop(10'000), many = counts_of_loop(1'000'000);
  EXPECT_EQ(few.instructions.has_value(), many.instructions.has_value());
  if (!many.instructions) GTEST_SKIP() << "no hardware counters here";
  EXPECT_GT(*many.instructions, 1'000'000u);
  EXPECT_GT(*many.instructions, 50 * *few.instructions);
  const EventCounts again = counts_of_loop(1'000'000);
  EXPECT_NEAR(static_cast<double>(*again.instructions) / static_cast<double>(*many.instructions), 1, 0.001);
}

}  // namespace
}  // namespace mwt
