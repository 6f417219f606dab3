#include "harness/io/text/csv.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>

#include "base/error.h"
#include "harness/io/testing/folder_testing.h"

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
  const std::vector<CsvRow> whole = {{"a", "b"}, {"1", "2"}};
  for (const char* rest : {"3", "\"3", "3,\"4", "3,4,5"}) {
    EXPECT_EQ(parse_csv(std::string("a,b\n1,2\n") + rest), whole) << rest;
    EXPECT_EQ(warning_about_last_line("file.csv", std::string("a,b\n1,2\n") + rest), "") << rest;
  }
  EXPECT_TRUE(parse_csv("a,b").empty());
}

// An editor that saves no final line end made a run disappear without a word.
TEST(Csv, ALastLineWithoutItsEndCountsButForWhatMayBeCut) {
  EXPECT_EQ(parse_csv("a,b\n1,2\n3,45"), (std::vector<CsvRow>{{"a", "b"}, {"1", "2"}, {"3", ""}}));
  EXPECT_TRUE(
      warning_about_last_line("file.csv", "a,b\n1,2\n3,45").starts_with("file.csv: its last line has no line end"));
  EXPECT_EQ(warning_about_last_line("file.csv", "a,b\n1,2\n"), "");
}

TEST(Csv, AByteOrderMarkIsNoPartOfTheFirstColumn) {
  EXPECT_EQ(parse_csv("\xef\xbb\xbf"
                      "a,b\n"),
            std::vector<CsvRow>{kHeader});
}

TEST(CsvFile, KeepsWhatItHadAndRemovesATornLine) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  { CsvFile(path, kHeader).append({"1", "2"}); }
  std::ofstream(path, std::ios::app) << "torn";
  {
    CsvFile file(path, kHeader);
    EXPECT_EQ(file.existing_rows(), (std::vector<CsvRow>{{"1", "2"}}));
    file.begin();
    EXPECT_EQ(read_text(path), "a,b\n1,2\ntorn") << "nothing was appended yet";
    file.append({"5", "6"});
  }
  EXPECT_EQ(read_text(path), "a,b\n1,2\n5,6\n");
}

TEST(CsvFile, CompletesARowThatAnEditorLeftWithoutItsEnd) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  write_text(path,
             "\xef\xbb\xbf"
             "a,b\r\n1,2\r\n3,4");
  CsvFile file(path, kHeader);
  EXPECT_EQ(file.existing_rows(), (std::vector<CsvRow>{{"1", "2"}, {"3", ""}}));
  EXPECT_EQ(file.warnings().size(), 1u);
  file.append({"5", "6"});
  EXPECT_EQ(parse_csv(read_text(path)), (std::vector<CsvRow>{kHeader, {"1", "2"}, {"3", ""}, {"5", "6"}}));
}

TEST(CsvFile, AllRowsMayBeReplacedAtOnce) {
  const TestFolder folder;
  const std::string path = folder.path("file.csv");
  CsvFile file(path, kHeader);
  file.append({"1", "2"});
  file.append({"3", "4"});
  file.replace_all({{"1", "x"}, {"3", "y"}});
  EXPECT_EQ(read_text(path), "a,b\n1,x\n3,y\n");
  file.append({"5", "6"});
  EXPECT_EQ(read_text(path), "a,b\n1,x\n3,y\n5,6\n");
  EXPECT_EQ(folder.file_count(), 1u);
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
  for (const char* text : {"a,c\n1,2\n", "a\n1\n", "a,b,c\n1,2,3\n", "a;b\n1;2\n", "a letter to a friend"}) {
    write_text(path, text);
    EXPECT_THROW(CsvFile(path, kHeader), InputError) << text;
    EXPECT_EQ(read_text(path), text);
  }
}

TEST(CsvFile, NamesTheColumnThatDiffersAndTheSchemaVersion) {
  const auto complaint = [](const std::vector<CsvRow>& rows) {
    return mwt::test::message_of<InputError>([&] { require_header("f.csv", rows, {"schema_version", "a", "b"}); });
  };
  EXPECT_EQ(complaint({{"schema_version", "a", "b"}}), "");
  EXPECT_TRUE(
      complaint({{"schema_version", "x", "b"}, {"2", "", ""}})
          .starts_with("f.csv: its columns are not those of this mwt (its rows are of schema version 2): column 2 is "
                       "'x' where 'a' should be; "));
  EXPECT_NE(complaint({{"schema_version", "a"}}).find("column 3 is missing where 'b' should be"), std::string::npos);
  EXPECT_NE(complaint({}).find("column 1 is missing"), std::string::npos);
}

TEST(CsvFile, WaitsForNoFifo) {
  const TestFolder folder;
  ASSERT_EQ(mkfifo(folder.path("fifo").c_str(), 0600), 0);
  EXPECT_THROW(CsvFile(folder.path("fifo"), kHeader), InputError);
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
