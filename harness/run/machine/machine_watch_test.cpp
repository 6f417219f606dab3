#include "harness/run/machine/machine_watch.h"

#include <gtest/gtest.h>

#include <string>

#include "harness/records/environment.h"

namespace mwt {
namespace {

TEST(MachineWatch, WarningsAreSentencesWithoutEnd) {
  const MachineWatch watch;
  for (const std::string& warning : watch.warnings()) EXPECT_TRUE(warning.ends_with("meanwhile")) << warning;
}

bool warns_of(const EnvironmentRecord& environment, const std::string& what) {
  for (const std::string& warning : timing_warnings(environment)) {
    if (warning.find(what) != std::string::npos) return true;
  }
  return false;
}

TEST(TimingWarnings, EveryDoubtfulStateIsNamed) {
  EnvironmentRecord quiet;
  quiet.logical_cpus = 4;
  quiet.governor = "performance";
  quiet.turbo = "off";
  quiet.load_1min = 0.1;
  quiet.swap_used_bytes = 0;
  EXPECT_TRUE(timing_warnings(quiet).empty());
  EnvironmentRecord doubtful = quiet;
  doubtful.governor = "powersave";
  doubtful.turbo = "on";
  doubtful.load_1min = 3.5;
  doubtful.swap_used_bytes = 4096;
  doubtful.jobs = 2;
  for (const char* what : {"powersave", "turbo", "busy", "swap", "side by side"}) {
    EXPECT_TRUE(warns_of(doubtful, what)) << what;
    EXPECT_FALSE(warns_of(quiet, what)) << what;
  }
}

}  // namespace
}  // namespace mwt
