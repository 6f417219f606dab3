// For the tests of commands: runs the program as its users do, in a folder that goes away.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "harness/io/testing/folder_testing.h"

namespace mwt::testing {

/// What a run of the program left behind.
struct CommandResult {
  int exit_code = -1;
  std::string output;
  std::string errors;
};

/// Relative paths, in arguments and below, are in the test's own folder; proved optima are kept there, too.
class CommandTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }
  void write(const std::string& name, const std::string& text) const { write_text(path(name), text); }
  [[nodiscard]] std::string read(const std::string& name) const { return read_text(path(name)); }
  [[nodiscard]] bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }

  /// Runs a line of shell in the folder and returns its exit code.
  [[nodiscard]] int shell(const std::string& line) const {
    return WEXITSTATUS(
        std::system(("cd " + path("") + " && export MWT_CACHE_DIR=optima && { " + line + "; }").c_str()));
  }

  [[nodiscard]] CommandResult mwt(const std::string& arguments) const {
    const int exit_code = shell(MWT_EXECUTABLE " " + arguments + " >.out 2>.err </dev/null");
    return {exit_code, read(".out"), read(".err")};
  }

  /// Expects exit 0; returns what was printed.
  std::string run(const std::string& arguments) const {
    const CommandResult result = mwt(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments << ": " << result.errors;
    return result.output;
  }

  /// Expects exit 2, nothing printed, and exactly one line of error that begins with "mwt: " and has `part` in it.
  void expect_mistake(const std::string& arguments, const std::string& part) const {
    const CommandResult result = mwt(arguments);
    EXPECT_EQ(result.exit_code, 2) << arguments;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_TRUE(result.errors.starts_with("mwt: ")) << result.errors;
    EXPECT_NE(result.errors.find(part), std::string::npos) << arguments << ": " << result.errors;
    EXPECT_EQ(result.output, "") << arguments;
  }

 private:
  TestFolder folder_;
};

}  // namespace mwt::testing
