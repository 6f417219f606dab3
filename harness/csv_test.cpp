#include "harness/csv.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <csignal>

#include "geometry/error.h"
#include "harness/folder_testing.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::TestFolder;
using testing::write_text;

const CsvRow kHeader = {"a", "b"};

TEST(Csv, AnyFieldsSurviveTheRoundTrip) {
  const std::vector<CsvRow> rows = {{"plain", "with, comma"}, {"", "say \"yes\""}, {"two\nlines", "\"\""}, {"", ""}};
  std::string text;
  for (const CsvRow& row : rows) text += csv_line(row);
  EXPECT_EQ(parse_csv(text), rows);
}

TEST(Csv, LinesMayEndLikeWindows) { EXPECT_EQ(parse_csv("a,b\r\n"), std::vector<CsvRow>{kHeader}); }

TEST(Csv, ATornLastLineIsLeftOut) {
  EXPECT_EQ(parse_csv("a,b\n1,2\n3,"), (std::vector<CsvRow>{{"a", "b"}, {"1", "2"}}));
  EXPECT_TRUE(parse_csv("a,b").empty());
}

TEST(CsvFile, KeepsWhatItHadAndRemovesATornLine) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  { CsvFile(path, kHeader).append({"1", "2"}); }
  std::ofstream(path, std::ios::app) << "3,torn";
  {
    CsvFile file(path, kHeader);
    EXPECT_EQ(file.existing_rows(), (std::vector<CsvRow>{{"1", "2"}}));
    file.append({"5", "6"});
  }
  EXPECT_EQ(read_text(path), "a,b\n1,2\n5,6\n");
}

TEST(CsvFile, ATornHeaderIsWrittenAgain) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  write_text(path, "a,");
  { CsvFile(path, kHeader).append({"1", "2"}); }
  EXPECT_EQ(read_text(path), "a,b\n1,2\n");
}

TEST(CsvFile, RefusesOtherColumnsAndChangesNothing) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  write_text(path, "a,c\n1,2\n");
  EXPECT_THROW(CsvFile(path, kHeader), InputError);
  EXPECT_EQ(read_text(path), "a,c\n1,2\n");
}

TEST(CsvFile, NeedsAFileItCanWrite) {
  EXPECT_THROW(CsvFile("/dev/full", kHeader), InputError);
  EXPECT_THROW(CsvFile("/no/such/folder/file.csv", kHeader), InputError);
}

// A limit on the file's size stands for a full disk: the write comes back short.
TEST(CsvFile, ARowThatDoesNotFitIsTakenBack) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit size{12, 12};
    setrlimit(RLIMIT_FSIZE, &size);
    CsvFile file(path, kHeader);
    file.append({"1", "2"});
    try {
      file.append({"too", "long"});
    } catch (const InputError&) {
      _exit(7);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(read_text(path), "a,b\n1,2\n");
}

}  // namespace
}  // namespace mwt
