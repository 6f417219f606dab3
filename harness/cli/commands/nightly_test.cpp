// What ./nightly makes of the outcomes of its steps: the script itself, with stubs for the programs that it calls.
#include <gtest/gtest.h>

#include <filesystem>

#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

// Stands for mwt: the comparison's outcome and exit code, and those of the study, are in files.
constexpr const char* kProgram = R"sh(#!/bin/sh
case "$1" in
  run) mkdir -p "$4"; exit "$(cat run_code)" ;;
  compare)
    [ "$(cat compare_code)" -le 1 ] || exit "$(cat compare_code)"
    while [ "$1" != --verdict ]; do shift; done
    printf '{\n "outcome": "%s",\n "suspected": {\n  "outcome": "other",\n' "$(cat outcome)" >"$2"
    printf '  "base_commit": "%s",\n  "new_commit": "%s",\n }}' $(cat commits) >>"$2"
    echo "text of the comparison"
    exit "$(cat compare_code)" ;;
  history) echo "nothing has changed" ;;
esac
)sh";

// Stands for the dashboard: its options, for the tests to read.
constexpr const char* kDashboard = "#!/bin/sh\nprintf '%s\\n' \"$@\" >results/nightly/dashboard.html\n";

class Nightly : public testing::CommandTest {
 protected:
  Nightly() {
    for (const char* folder : {"setup", "plots", "build/release"}) std::filesystem::create_directories(path(folder));
    std::filesystem::copy_file(MWT_SOURCE_DIR "/nightly", path("nightly"));
    write_program("setup/ensure_packages.sh", "#!/bin/sh\n");
    write_program("setup/build.sh", "#!/bin/sh\nexit $(cat build_code)\n");
    write_program("build/release/mwt", kProgram);
    write_program("plots/make_dashboard.py", kDashboard);
    write("build_code", "0");
    write("run_code", "0");
    write("outcome", "not slower");
    write("compare_code", "0");
    write("commits", "aaa bbb");
    write("loadavg", "0.05 0.10 0.10 1/100 1000\n");
  }

  void write_program(const std::string& name, const std::string& text) const {
    write(name, text);
    std::filesystem::permissions(path(name), std::filesystem::perms::owner_all);
  }

  /// A second later than any before: nightly runs are named by the second.
  int nightly_run(const std::string& arguments = "") {
    return shell("sleep 1.1; MWT_NIGHTLY_LOADAVG=loadavg MWT_NIGHTLY_WAIT_S=0 ./nightly " + arguments +
                 " >.out 2>.err");
  }

  [[nodiscard]] std::string accepted() const { return link("accepted"); }
  [[nodiscard]] std::string last() const { return link("last"); }
  [[nodiscard]] std::string verdict() const { return read("results/nightly/verdict.md"); }
  [[nodiscard]] std::string dashboard() const { return read("results/nightly/dashboard.html"); }
  [[nodiscard]] bool has_program(const std::string& name) const { return exists("results/nightly/" + name + "/mwt"); }

 private:
  [[nodiscard]] std::string link(const std::string& name) const {
    return std::filesystem::read_symlink(path("results/nightly/" + name)).string();
  }
};

TEST_F(Nightly, TheFirstNightAndThoseThatAreNotSlowerAreAccepted) {
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  const std::string first = accepted();
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  EXPECT_NE(accepted(), first);
  EXPECT_EQ(accepted(), last());
  EXPECT_FALSE(has_program(first)) << "nobody runs it again";
  EXPECT_NE(verdict().find("compared with " + first), std::string::npos) << verdict();
  EXPECT_NE(verdict().find("text of the comparison"), std::string::npos);
  EXPECT_NE(dashboard().find("--state\nAccepted"), std::string::npos) << dashboard();
}

// A slow nightly run became the base when its slowdown was not sure, and the good program was deleted.
TEST_F(Nightly, WhatIsNotExcludedIsNotAccepted) {
  ASSERT_EQ(nightly_run(), 0);
  const std::string first = accepted();
  for (const char* outcome : {"unclear", "not compared"}) {
    write("outcome", outcome);
    EXPECT_EQ(nightly_run(), 0) << outcome << read(".err");
    EXPECT_EQ(accepted(), first) << outcome;
    EXPECT_TRUE(has_program(first));
    EXPECT_NE(verdict().find("Not accepted"), std::string::npos) << verdict();
    EXPECT_NE(dashboard().find("--state\nNot accepted"), std::string::npos);
  }
  EXPECT_EQ(nightly_run("--accept"), 0);
  EXPECT_EQ(accepted(), last());
}

TEST_F(Nightly, ARegressionFailsAndIsNotAccepted) {
  ASSERT_EQ(nightly_run(), 0);
  const std::string first = accepted();
  write("outcome", "regression");
  write("compare_code", "1");
  EXPECT_EQ(nightly_run(), 1);
  EXPECT_EQ(accepted(), first);
  EXPECT_TRUE(has_program(first) && has_program(last()));
  EXPECT_NE(read(".err").find("a regression"), std::string::npos);
}

// The verdict and the dashboard of the nightly run before, left as they were, would say that all is well.
TEST_F(Nightly, ANightThatFailsLeavesNoOldVerdict) {
  ASSERT_EQ(nightly_run(), 0);
  const std::string first = accepted();
  for (const auto& [file, code, step] :
       {std::tuple{"build_code", 3, "building"}, std::tuple{"run_code", 2, "the study"},
        std::tuple{"compare_code", 2, "comparing"}}) {
    const std::string before = read(file);
    write(file, std::to_string(code));
    EXPECT_EQ(nightly_run(), code);
    EXPECT_EQ(accepted(), first);
    for (const std::string& text : {verdict(), dashboard(), read(".err")}) {
      EXPECT_NE(text.find(std::string("failed while ")), std::string::npos) << text;
      EXPECT_NE(text.find(step), std::string::npos) << text;
    }
    EXPECT_FALSE(exists("results/nightly/verdict.json"));
    write(file, before);
  }
}

TEST_F(Nightly, FailedRunsAreTheComparisonsMatter) {
  write("run_code", "1");
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  EXPECT_NE(verdict().find("Some of its runs failed"), std::string::npos)
      << "nothing to compare the first nightly run with";
  EXPECT_EQ(nightly_run(), 0) << read(".err");
}

TEST_F(Nightly, ABusyMachineIsSaid) {
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  EXPECT_EQ(verdict().find("busy"), std::string::npos) << verdict();
  write("loadavg", "500.25 400.00 300.00 1/100 1000\n");
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  EXPECT_NE(verdict().find("The machine was busy with other programs when the study began (load 500.25)."),
            std::string::npos)
      << verdict();
  EXPECT_NE(dashboard().find("(load 500.25)"), std::string::npos) << dashboard();
}

TEST_F(Nightly, TheVerdictListsTheCommitsBetween) {
  ASSERT_EQ(shell("git init -q . && git config user.name N && git config user.email n@example.org && "
                  "for i in 1 2 3; do git commit -q --allow-empty -m \"change $i\"; done && "
                  "echo $(git rev-parse HEAD~2) $(git rev-parse HEAD) >commits"),
            0);
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  EXPECT_EQ(verdict().find("Commits between"), std::string::npos) << "there was nothing to compare with";
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  const std::size_t list = verdict().find("## Commits between\n\n- ");
  ASSERT_NE(list, std::string::npos) << verdict();
  EXPECT_LT(verdict().find(" change 3 (N)", list), verdict().find(" change 2 (N)", list));
  EXPECT_EQ(verdict().find(" change 1 (N)"), std::string::npos);
  write("commits", "aaa bbb");
  EXPECT_EQ(nightly_run(), 0) << read(".err");
  EXPECT_NE(verdict().find("- unknown: aaa..bbb are not both in this repository"), std::string::npos) << verdict();
}

TEST_F(Nightly, TwoNightsDoNotRunAtATime) {
  std::filesystem::create_directories(path("results/nightly"));
  EXPECT_EQ(shell("flock results/nightly/lock ./nightly >.out 2>.err"), 2);
  EXPECT_NE(read(".err").find("another nightly run is running here"), std::string::npos);
}

}  // namespace
}  // namespace mwt
