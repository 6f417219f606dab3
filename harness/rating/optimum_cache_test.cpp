#include "harness/rating/optimum_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <limits>

#include "harness/io/testing/folder_testing.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

const OptimumKey kKey{"0123456789abcdef0123456789abcdef", "exact", 1, "a=1 b=x"};
constexpr Interval kProved{70.95859252430001, 70.95859252430003};

class OptimumCacheTest : public ::testing::Test {
 protected:
  [[nodiscard]] OptimumCache cache() { return cache_in(folder_.path("optima")); }
  [[nodiscard]] OptimumCache cache_in(const std::string& folder) {
    return {folder, [this](const std::string& warning) { warnings_.push_back(warning); }};
  }
  [[nodiscard]] std::string only_file() const {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path("optima"))) files.push_back(entry.path());
    EXPECT_EQ(files.size(), 1u);
    return files.empty() ? "" : files.front();
  }

  TestFolder folder_;
  std::vector<std::string> warnings_;
};

TEST_F(OptimumCacheTest, GivesBackExactlyWhatWasStored) {
  EXPECT_FALSE(cache().find(kKey));
  cache().store(kKey, {kProved, 0.25});
  const auto found = cache().find(kKey);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->interval, kProved);
  EXPECT_EQ(found->solve_time_s, 0.25);
  const Interval tiny{std::numeric_limits<double>::min(), std::numeric_limits<double>::min()};
  cache().store(kKey, {tiny, 0});
  EXPECT_EQ(cache().find(kKey)->interval, tiny) << "the last store stands";
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(OptimumCacheTest, EveryPartOfTheKeySeparates) {
  cache().store(kKey, {kProved, 1});
  OptimumKey other = kKey;
  other.instance_id.back() = 'e';
  EXPECT_FALSE(cache().find(other));
  other = kKey;
  other.solver = "exactly";
  EXPECT_FALSE(cache().find(other));
  other = kKey;
  other.version = 2;
  EXPECT_FALSE(cache().find(other));
  other = kKey;
  other.parameters = "a=1";
  EXPECT_FALSE(cache().find(other));
  other.parameters = "a=1 b=x\nlower 1\nupper 1\nsolve_time_s 1";
  EXPECT_FALSE(cache().find(other));
  EXPECT_TRUE(warnings_.empty());
}

TEST_F(OptimumCacheTest, SweepsWhatKilledWritersLeftLongAgo) {
  namespace fs = std::filesystem;
  fs::create_directory(folder_.path("optima"));
  for (const char* name : {".mwt-1-0.tmp", ".mwt-2-0.tmp", "notes.txt"}) {
    testing::write_text(folder_.path(std::string("optima/") + name), "x");
  }
  const auto long_ago = fs::file_time_type::clock::now() - std::chrono::hours(2);
  for (const char* name : {".mwt-1-0.tmp", "notes.txt"})
    fs::last_write_time(folder_.path(std::string("optima/") + name), long_ago);
  cache().store(kKey, {kProved, 1});
  EXPECT_FALSE(fs::exists(folder_.path("optima/.mwt-1-0.tmp")));
  EXPECT_TRUE(fs::exists(folder_.path("optima/.mwt-2-0.tmp"))) << "its writer may be alive";
  EXPECT_TRUE(fs::exists(folder_.path("optima/notes.txt"))) << "not ours";
}

TEST_F(OptimumCacheTest, KeepsNothingButProvedOptima) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Interval interval : {Interval{70, 71}, {0, 0}, {2, 1}, {-1, -1}, {infinity, infinity}, {nan, nan}}) {
    cache().store(kKey, {interval, 1});
    EXPECT_FALSE(cache().find(kKey)) << interval.lower;
  }
}

TEST_F(OptimumCacheTest, ATornFileCountsAsAbsentAndIsReplaced) {
  cache().store(kKey, {kProved, 1});
  const std::string file = only_file();
  const std::string complete = read_text(file);
  OptimumCache reader = cache();
  for (std::size_t kept = 0; kept < complete.size(); ++kept) {
    write_text(file, complete.substr(0, kept));
    EXPECT_FALSE(reader.find(kKey)) << kept;
  }
  EXPECT_EQ(warnings_.size(), 1u) << "told once";
  EXPECT_NE(warnings_.front().find(file), std::string::npos);
  reader.store(kKey, {kProved, 1});
  EXPECT_TRUE(reader.find(kKey));
}

TEST_F(OptimumCacheTest, AnAlteredOrForeignFileIsNotTrusted) {
  cache().store(kKey, {kProved, 1});
  const std::string file = only_file();
  const std::string complete = read_text(file);
  for (std::size_t i = 0; i < complete.size(); ++i) {
    std::string altered = complete;
    altered[i] = altered[i] == '1' ? '2' : '1';
    write_text(file, altered);
    EXPECT_FALSE(cache().find(kKey)) << altered;
  }
  OptimumKey other = kKey;
  other.version = 2;
  write_text(file, complete);
  cache().store(other, {kProved, 1});
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path("optima"))) {
    if (entry.path() != file)
      std::filesystem::copy_file(entry.path(), file, std::filesystem::copy_options::overwrite_existing);
  }
  EXPECT_FALSE(cache().find(kKey)) << "complete, but of another version";
  write_text(file, complete + complete);
  EXPECT_FALSE(cache().find(kKey));
  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  EXPECT_FALSE(cache().find(kKey));
}

// A fifo in the place of an entry was opened for writing, and waited for a reader.
TEST_F(OptimumCacheTest, WhateverIsInThePlaceOfAnEntryIsReplacedAndNeverWritten) {
  cache().store(kKey, {kProved, 1});
  const std::string file = only_file();
  write_text(folder_.path("precious"), "x");
  const std::vector<std::function<void()>> obstacles = {
      [&] { ASSERT_EQ(mkfifo(file.c_str(), 0600), 0); },
      [&] { std::filesystem::create_directory(file); },
      [&] { std::filesystem::create_symlink("/dev/zero", file); },
      [&] { std::filesystem::create_symlink(folder_.path("precious"), file); },
      [&] { std::filesystem::create_symlink(folder_.path("nowhere"), file); },
      [&] { std::filesystem::resize_file((write_text(file, "x"), file), std::uintmax_t{1} << 33); },
  };
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    std::filesystem::remove(file);
    obstacles[i]();
    OptimumCache in_question = cache();
    EXPECT_FALSE(in_question.find(kKey)) << i;
    in_question.store(kKey, {kProved, 1});
    EXPECT_TRUE(in_question.find(kKey)) << i;
    EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::symlink_status(file))) << i;
  }
  EXPECT_EQ(read_text(folder_.path("precious")), "x");
}

TEST_F(OptimumCacheTest, AFullFolderInThePlaceOfAnEntryStopsNoOthers) {
  cache().store(kKey, {kProved, 1});
  const std::string file = only_file();
  std::filesystem::remove(file);
  std::filesystem::create_directories(file + "/x");
  OptimumCache in_question = cache();
  in_question.store(kKey, {kProved, 1});
  OptimumKey other = kKey;
  other.version = 2;
  in_question.store(other, {kProved, 1});
  EXPECT_TRUE(in_question.find(other));
  EXPECT_EQ(warnings_.size(), 1u);
}

TEST_F(OptimumCacheTest, ThrowsOutWhatATriangulationDisproves) {
  OptimumKey other_version = kKey;
  other_version.version = 2;
  OptimumKey other_solver = kKey;
  other_solver.solver = "subset_dp";
  OptimumKey other_instance = kKey;
  other_instance.instance_id.back() = 'e';
  OptimumCache in_question = cache();
  in_question.store(kKey, {{71, 71}, 1});
  in_question.store(other_version, {{72, 72}, 1});
  in_question.store(other_solver, {kProved, 1});
  in_question.store(other_instance, {{90, 90}, 1});
  EXPECT_TRUE(in_question.discard_disproved(kKey.instance_id, 71).size() == 1u) << "71 allows 71";
  EXPECT_TRUE(in_question.find(kKey));
  EXPECT_EQ(in_question.discard_disproved(kKey.instance_id, kProved.upper), std::vector{in_question.path_of(kKey)});
  EXPECT_FALSE(in_question.find(kKey));
  EXPECT_FALSE(in_question.find(other_version));
  EXPECT_TRUE(in_question.find(other_solver));
  EXPECT_TRUE(in_question.find(other_instance));
}

TEST_F(OptimumCacheTest, AnUnusableFolderMeansNoCachingAndOneWarning) {
  write_text(folder_.path("file"), "x");
  OptimumCache unusable = cache_in(folder_.path("file/optima"));
  for (int i = 0; i < 3; ++i) {
    EXPECT_FALSE(unusable.find(kKey));
    unusable.store(kKey, {kProved, 1});
  }
  EXPECT_EQ(warnings_.size(), 1u);
  OptimumCache nowhere = cache_in("");
  nowhere.store(kKey, {kProved, 1});
  EXPECT_FALSE(nowhere.find(kKey));
  EXPECT_EQ(warnings_.size(), 2u);
}

OptimumKey numbered(int i) {
  OptimumKey key = kKey;
  key.version = i;
  return key;
}

// Stores keys `first`, ..., `last` - 1 over and over, in a process of its own.
pid_t start_writer(const std::string& folder, int first, int last, int rounds) {
  const pid_t child = fork();
  if (child != 0) return child;
  OptimumCache cache(folder, [](const std::string&) { _exit(1); });
  for (int round = 0; round < rounds; ++round)
    for (int i = first; i < last; ++i) cache.store(numbered(i), {{i + 1.0, i + 1.0}, 1});
  _exit(0);
}

TEST_F(OptimumCacheTest, WritersSideBySideLoseNothing) {
  constexpr int kKeys = 12;
  std::vector<pid_t> writers;
  for (int i = 0; i < 4; ++i) writers.push_back(start_writer(folder_.path("optima"), i, kKeys - 3 + i, 3));
  OptimumCache reader = cache();
  int running = static_cast<int>(writers.size());
  while (running > 0) {
    for (int i = 0; i < kKeys; ++i) {
      const auto found = reader.find(numbered(i));
      ASSERT_TRUE(!found || found->interval.lower == i + 1.0) << i;
    }
    int status = 0;
    while (running > 0 && waitpid(-1, &status, WNOHANG) > 0) {
      EXPECT_EQ(status, 0);
      --running;
    }
  }
  for (int i = 0; i < kKeys; ++i) EXPECT_TRUE(reader.find(numbered(i))) << i;
  EXPECT_TRUE(warnings_.empty()) << warnings_.front();
}

TEST_F(OptimumCacheTest, KilledWritersLeaveAReadableCache) {
  for (unsigned round = 0; round < 20 || !cache().find(numbered(2)); ++round) {
    ASSERT_LT(round, 300u) << "no writer ever came to write";
    const pid_t writer = start_writer(folder_.path("optima"), 0, 3, 1000000);
    usleep(500 + 700 * round);
    ASSERT_EQ(kill(writer, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(waitpid(writer, &status, 0), writer);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it was to be killed while it wrote";
    for (int i = 0; i < 3; ++i) {
      const auto found = cache().find(numbered(i));
      ASSERT_TRUE(!found || found->interval.lower == i + 1.0) << i;
    }
  }
  EXPECT_TRUE(warnings_.empty()) << "no torn file at any time";
}

// Sets a variable of the environment for as long as it lives; null: unset.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) {
    if (const char* before = std::getenv(name)) before_ = before;
    set(value);
  }
  ~Variable() { set(before_ ? before_->c_str() : nullptr); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  void set(const char* value) { value == nullptr ? unsetenv(name_) : setenv(name_, value, 1); }

  const char* name_;
  std::optional<std::string> before_;
};

TEST(OptimumCacheFolder, FollowsTheEnvironment) {
  const Variable own("MWT_CACHE_DIR", "/a");
  const Variable caches("XDG_CACHE_HOME", "/b");
  const Variable home("HOME", "/c");
  EXPECT_EQ(optimum_cache_folder(), "/a");
  const Variable no_own("MWT_CACHE_DIR", "");
  EXPECT_EQ(optimum_cache_folder(), "/b/mwt/optima");
  const Variable relative("XDG_CACHE_HOME", "b");
  EXPECT_EQ(optimum_cache_folder(), "/c/.cache/mwt/optima");
  const Variable no_home("HOME", nullptr);
  EXPECT_EQ(optimum_cache_folder(), "");
}

}  // namespace
}  // namespace mwt
