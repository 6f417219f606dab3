#include "harness/io/temporary_folder.h"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>

#include "base/error.h"
#include "base/testing/test_folder.h"

namespace mwt {
namespace {

namespace fs = std::filesystem;

// Sets $TMPDIR while it lives.
class TemporaryPlace {
 public:
  explicit TemporaryPlace(const std::string& place) {
    if (const char* const before = getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", place.c_str(), 1);
  }
  ~TemporaryPlace() { before_.empty() ? unsetenv("TMPDIR") : setenv("TMPDIR", before_.c_str(), 1); }
  TemporaryPlace(const TemporaryPlace&) = delete;
  TemporaryPlace& operator=(const TemporaryPlace&) = delete;

 private:
  std::string before_;
};

TEST(TemporaryFolder, IsTheUsersAloneAndGoesWithAllThatIsInIt) {
  const test::TestFolder place;
  const TemporaryPlace here(place.path(""));
  {
    const TemporaryFolder one("mwt-test"), other("mwt-test");
    EXPECT_NE(one.path(), other.path());
    EXPECT_TRUE(one.path().filename().string().starts_with("mwt-test-"));
    EXPECT_EQ(fs::status(one.path()).permissions(), fs::perms::owner_all);
    fs::create_directory(one.path() / "inner");
    std::ofstream(one.file("inner/file")) << "text";
    EXPECT_TRUE(fs::exists(one.path() / "inner" / "file"));
    EXPECT_EQ(place.file_count(), 2U);
  }
  EXPECT_EQ(place.file_count(), 0U);
}

TEST(TemporaryFolder, SaysWhereNoneCanBeMade) {
  const test::TestFolder folder;
  for (const std::string& place : {folder.path("missing"), folder.file("file", "")}) {
    const TemporaryPlace here(place);
    const std::string message = test::message_of<InputError>([] { const TemporaryFolder made("mwt-test"); });
    EXPECT_NE(message.find("set TMPDIR"), std::string::npos) << message;
  }
}

}  // namespace
}  // namespace mwt
