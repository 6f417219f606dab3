#include "algorithms/stop_reason.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(StopReason, EveryNameComesBack) {
  for (const char* name : {"precision", "size", "memory", "deadline"}) {
    ASSERT_TRUE(stop_reason_of(name)) << name;
    EXPECT_EQ(name_of(*stop_reason_of(name)), name);
  }
  EXPECT_FALSE(stop_reason_of("boredom"));
  EXPECT_FALSE(stop_reason_of(""));
}

TEST(StopReason, OnlyTheDeadlineSpeaksOfATimeLimit) {
  EXPECT_EQ(phrase_of(StopReason::deadline), "at the time limit");
  for (const StopReason reason : {StopReason::precision, StopReason::size, StopReason::memory}) {
    EXPECT_EQ(phrase_of(reason).find("time"), std::string_view::npos) << name_of(reason);
  }
}

TEST(StopReason, OfTwoPartsIsTheOneThatDependsMoreOnTheMachine) {
  EXPECT_EQ(combined({}, {}), std::nullopt);
  EXPECT_EQ(combined(StopReason::size, {}), StopReason::size);
  EXPECT_EQ(combined({}, StopReason::precision), StopReason::precision);
  EXPECT_EQ(combined(StopReason::deadline, StopReason::memory), StopReason::deadline);
  EXPECT_EQ(combined(StopReason::size, StopReason::memory), StopReason::memory);
}

}  // namespace
}  // namespace mwt
