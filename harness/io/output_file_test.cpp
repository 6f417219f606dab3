#include "harness/io/output_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>
#include <thread>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "harness/io/input_file.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

mode_t mode_of(const std::string& path) {
  struct stat status {};
  EXPECT_EQ(::stat(path.c_str(), &status), 0);
  return status.st_mode & 07777;
}

TEST(OutputFile, WritesAndReplaces) {
  const TestFolder folder;
  write_file_atomically(folder.path("a.txt"), "first");
  write_file_atomically(folder.path("a.txt"), "second");
  EXPECT_EQ(TestFolder::content(folder.path("a.txt")), "second");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, AppendsInOrderAcrossBuffers) {
  const TestFolder folder;
  const std::string large(3 << 20, 'x');
  write_file_atomically(folder.path("a"), [&](OutputFile& file) {
    file.append("start");
    file.append(large);
    for (int i = 0; i < 200000; ++i) file.append("0123456789");
    file.append("end");
  });
  const std::string content = TestFolder::content(folder.path("a"));
  EXPECT_EQ(content.size(), 5 + large.size() + 2000000 + 3);
  EXPECT_EQ(content.substr(0, 6), "startx");
  EXPECT_EQ(content.substr(content.size() - 5), "89end");
}

TEST(OutputFile, AnExceptionLeavesTheOldFile) {
  const TestFolder folder;
  const std::string path = folder.file("a.txt", "old");
  const auto write = [](OutputFile& file) {
    file.append(std::string(5 << 20, 'x'));
    throw std::runtime_error("interrupted");
  };
  EXPECT_THROW(write_file_atomically(path, write), std::runtime_error);
  EXPECT_EQ(TestFolder::content(path), "old");
  EXPECT_EQ(folder.file_count(), 1U);
}

TEST(OutputFile, WithoutCommitNothingHappens) {
  const TestFolder folder;
  { OutputFile(folder.path("a.txt")).append("lost"); }
  EXPECT_EQ(folder.file_count(), 0U);
}

TEST(OutputFile, ReportsAFullDisk) {
  const std::string message = message_of<InputError>([] { write_file_atomically("/dev/full", "something"); });
  EXPECT_EQ(message, "/dev/full: cannot be written: the disk is full; free some space and run again");
}

TEST(OutputFile, ReportsPlacesThatCannotBeWritten) {
  const TestFolder folder;
  const std::string file = folder.file("file", "");
  const auto message = [](const std::string& path) {
    return message_of<InputError>([&] { write_file_atomically(path, "x"); });
  };
  EXPECT_EQ(message(folder.path("no/such/a.txt")),
            folder.path("no/such/a.txt") + ": cannot be written: its folder does not exist; create that first");
  EXPECT_EQ(message(folder.path("")), folder.path("") + ": cannot be written: it is a folder; name a file in it");
  EXPECT_EQ(message(file + "/a.txt"), file + "/a.txt: cannot be written: its folder is a file; choose another place");
  EXPECT_NE(message("/proc/no_such_file"), "");
  EXPECT_EQ(message(""), "the output file has an empty name; give it one, or - for standard output");
  EXPECT_EQ(folder.file_count(), 1U);
}

// Gives up root's privilege to write everywhere for a while.
class Unprivileged {
 public:
  Unprivileged() {
    constexpr uid_t kNobody = 65534;
    EXPECT_TRUE(!was_root_ || ::seteuid(kNobody) == 0);
  }
  ~Unprivileged() { EXPECT_TRUE(!was_root_ || ::seteuid(0) == 0); }
  Unprivileged(const Unprivileged&) = delete;
  Unprivileged& operator=(const Unprivileged&) = delete;

 private:
  bool was_root_ = ::geteuid() == 0;
};

TEST(OutputFile, RespectsWriteProtection) {
  const TestFolder folder;
  const std::string path = folder.file("a.txt", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  ASSERT_EQ(::chmod(folder.path("").c_str(), 0555), 0);
  const Unprivileged unprivileged;
  EXPECT_EQ(message_of<InputError>([&] { write_file_atomically(path, "new"); }),
            path + ": cannot be written: no permission; choose another place");
  EXPECT_EQ(message_of<InputError>([&] { write_file_atomically(folder.path("b.txt"), "new"); }),
            folder.path("b.txt") + ": cannot be written: no permission; choose another place");
  EXPECT_EQ(TestFolder::content(path), "old");
}

TEST(InputFile, RespectsReadProtection) {
  const TestFolder folder;
  const std::string path = folder.file("a.txt", "secret");
  ASSERT_EQ(::chmod(folder.path("").c_str(), 0755), 0);
  ASSERT_EQ(::chmod(path.c_str(), 0), 0);
  const Unprivileged unprivileged;
  EXPECT_EQ(message_of<InputError>([&] { static_cast<void>(read_file(path)); }),
            path + ": no permission to read it; change its mode or choose another file");
}

TEST(OutputFile, NewFilesFollowTheUmaskAndReplacedOnesKeepTheirMode) {
  const TestFolder folder;
  const mode_t old_mask = ::umask(027);
  write_file_atomically(folder.path("new"), "x");
  ::umask(old_mask);
  EXPECT_EQ(mode_of(folder.path("new")), 0640U);
  ASSERT_EQ(::chmod(folder.path("new").c_str(), 0604), 0);
  write_file_atomically(folder.path("new"), "y");
  EXPECT_EQ(mode_of(folder.path("new")), 0604U);
}

TEST(OutputFile, FollowsSymbolicLinks) {
  const TestFolder folder;
  const std::string target = folder.file("target", "old");
  std::filesystem::create_symlink(target, folder.path("link"));
  write_file_atomically(folder.path("link"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link")));
  EXPECT_EQ(TestFolder::content(target), "new");
}

TEST(OutputFile, WritesIntoDevicesAndFifosDirectly) {
  write_file_atomically("/dev/null", "gone");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));

  const TestFolder folder;
  const std::string fifo = folder.path("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  std::thread writer([&] { write_file_atomically(fifo, "through the pipe"); });
  EXPECT_EQ(read_file(fifo), "through the pipe");
  writer.join();
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));
}

TEST(OutputFile, DashIsStandardOutput) {
  testing::internal::CaptureStdout();
  write_file_atomically("-", "to the screen");
  write_file_atomically("/dev/stdout", ", twice");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "to the screen, twice");
}

// Standard output replaced by the full device for one write.
TEST(OutputFile, ReportsAFullStandardOutput) {
  const int saved = ::dup(STDOUT_FILENO);
  const int full = ::open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  ::fflush(stdout);
  ::dup2(full, STDOUT_FILENO);
  const std::string message = message_of<InputError>([] { write_file_atomically("-", "x"); });
  ::dup2(saved, STDOUT_FILENO);
  ::close(saved);
  ::close(full);
  EXPECT_EQ(message, "standard output: cannot be written: the disk is full; free some space and run again");
}

TEST(InputFile, ReportsWhatCannotBeRead) {
  const TestFolder folder;
  const auto message = [](const std::string& path) {
    return message_of<InputError>([&] { static_cast<void>(read_file(path)); });
  };
  EXPECT_EQ(message(folder.path("none.txt")), folder.path("none.txt") + ": no such file; check the name");
  EXPECT_EQ(message(folder.path("")), folder.path("") + ": is a folder; name a file in it");
  EXPECT_NE(message(folder.file("file", "") + "/a"), "");
  EXPECT_EQ(message("/dev/null"), "");
}

TEST(InputFile, ReadsEmptyAndLargeFiles) {
  const TestFolder folder;
  EXPECT_EQ(read_file(folder.file("empty", "")), "");
  const std::string large(5 << 20, 'y');
  EXPECT_EQ(read_file(folder.file("large", large)), large);
  EXPECT_EQ(read_file("/dev/null"), "");
}

}  // namespace
}  // namespace mwt
