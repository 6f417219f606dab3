#include "harness/io/progress.h"

#include <gtest/gtest.h>

#include <sstream>

namespace mwt {
namespace {

TEST(Progress, PlainOutputEndsWithOneLineOfTheWhole) {
  std::ostringstream out;
  Progress progress(out, false, "runs", 2);
  progress.advance(false, "a");
  progress.advance(true, "b");
  progress.finish();
  EXPECT_TRUE(out.str().starts_with("runs 2/2, 1 failed, took ")) << out.str();
  EXPECT_EQ(out.str().find('\n'), out.str().size() - 1);
}

TEST(Progress, MoreWorkMayTurnUp) {
  std::ostringstream out;
  Progress progress(out, false, "steps", 0);
  progress.expect(1);
  progress.advance(false, "a");
  EXPECT_TRUE(out.str().starts_with("steps 1/1, 0 failed, took ")) << out.str();
  out.str("");
  progress.expect(2);
  progress.advance(false, "b");
  EXPECT_EQ(out.str(), "") << "the end has not come";
  progress.advance(false, "c");
  EXPECT_TRUE(out.str().starts_with("steps 3/3, 0 failed, took ")) << out.str();
}

TEST(Progress, AnnouncementsAreLinesOfTheirOwn) {
  std::ostringstream out;
  Progress progress(out, true, "runs", 2);
  progress.announce("note");
  EXPECT_TRUE(out.str().starts_with("\r\x1b[Knote\n"));
}

TEST(Progress, ATerminalsLineNeverWraps) {
  std::ostringstream out;
  Progress progress(out, true, std::string(200, 'x'), 2);
  progress.announce("");
  const std::string line = out.str().substr(out.str().rfind("\x1b[K") + 3);
  EXPECT_EQ(line, std::string(79, 'x'));
}

}  // namespace
}  // namespace mwt
