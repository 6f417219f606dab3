#include "harness/io/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace mwt {
namespace {

// COLUMNS as the test wants it, and standard output somewhere else for a while.
class Terminal : public ::testing::Test {
 protected:
  Terminal() {
    if (const char* columns = std::getenv("COLUMNS")) before_ = columns;
    unsetenv("COLUMNS");
  }
  ~Terminal() override { before_.empty() ? unsetenv("COLUMNS") : setenv("COLUMNS", before_.c_str(), 1); }

  static std::optional<std::size_t> width_on(int descriptor) {
    std::fflush(stdout);
    const int saved = dup(STDOUT_FILENO);
    dup2(descriptor, STDOUT_FILENO);
    const auto width = output_width();
    dup2(saved, STDOUT_FILENO);
    close(saved);
    return width;
  }

 private:
  std::string before_;
};

TEST_F(Terminal, FilesHaveNoWidth) {
  const int file = open("/dev/null", O_WRONLY);
  EXPECT_EQ(width_on(file), std::nullopt);
  close(file);
}

TEST_F(Terminal, TellsItsWidth) {
  const int controller = posix_openpt(O_RDWR | O_NOCTTY);
  if (controller < 0 || grantpt(controller) != 0 || unlockpt(controller) != 0) GTEST_SKIP() << "no terminals here";
  const int terminal = open(ptsname(controller), O_RDWR | O_NOCTTY);
  ASSERT_GE(terminal, 0);
  winsize size{};
  EXPECT_EQ(width_on(terminal), 80U) << "a terminal of unknown width";
  size.ws_col = 100;
  ASSERT_EQ(ioctl(terminal, TIOCSWINSZ, &size), 0);
  EXPECT_EQ(width_on(terminal), 100U);
  setenv("COLUMNS", "66", 1);
  EXPECT_EQ(width_on(terminal), 66U);
  close(terminal);
  close(controller);
}

TEST_F(Terminal, ColumnsCountIfTheyAreANumber) {
  for (const auto& [text, width] : {std::pair("120", 120U), {"020", 20U}}) {
    setenv("COLUMNS", text, 1);
    EXPECT_EQ(output_width(), width) << text;
  }
  const int file = open("/dev/null", O_WRONLY);
  for (const char* text : {"", "x", "-5", "5", "99999999999999999999"}) {
    setenv("COLUMNS", text, 1);
    EXPECT_EQ(width_on(file), std::nullopt) << text;
  }
  close(file);
}

}  // namespace
}  // namespace mwt
