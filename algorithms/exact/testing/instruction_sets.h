// For tests only: runs vector code with each instruction set that this machine has.
#pragma once

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>

namespace mwt::stage_testing {

/// Calls test() once per instruction set.
template <class Test>
void for_each_instruction_set(const Test& test) {
  for (std::int64_t sets = hwy::SupportedTargets(); sets != 0; sets &= sets - 1) {
    const std::int64_t set = sets & -sets;
    SCOPED_TRACE(hwy::TargetName(set));
    hwy::SetSupportedTargetsForTest(set);
    hwy::GetChosenTarget().DeInit();
    test();
    if (testing::Test::HasFatalFailure()) break;
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().DeInit();
}

}  // namespace mwt::stage_testing
