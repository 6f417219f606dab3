#include "harness/io/text/text.h"

#include <gtest/gtest.h>

#include "harness/io/testing/folder_testing.h"

namespace mwt {
namespace {

TEST(Text, DurationsTakeTheLargestUnitThatShowsThreeDigits) {
  EXPECT_EQ(readable_duration(1.234e-5), "12.3 us");
  EXPECT_EQ(readable_duration(0.00456), "4.56 ms");
  EXPECT_EQ(readable_duration(12.34), "12.3 s");
  EXPECT_EQ(readable_duration(200), "3:20 min");
  EXPECT_EQ(readable_duration(3605), "60:05 min");
  EXPECT_EQ(readable_duration(6000), "1:40 h");
  EXPECT_EQ(readable_duration(75203.0 * 60), "52 days");
}

TEST(Text, OneLineKeepsEverythingButLineBreaks) {
  EXPECT_EQ(one_line("a\nb\r\nc\n"), "a b  c");
  EXPECT_EQ(one_line(""), "");
  EXPECT_EQ(one_line("\xc3\xa4 ok"), "\xc3\xa4 ok");
  EXPECT_EQ(one_line("a\xff\xc3 b"), "a?? b");
}

TEST(Text, SplitAndJoinAreInverse) {
  EXPECT_EQ(split("a,,b", ','), (std::vector<std::string>{"a", "", "b"}));
  EXPECT_EQ(joined(split("a,,b", ','), ","), "a,,b");
  EXPECT_EQ(joined({}), "");
}

TEST(Text, HashesAreSha256) {
  EXPECT_EQ(short_hash("abc"), "ba7816bf8f01cfea");
  const testing::TestFolder folder;
  testing::write_text(folder.path("file"), "abc");
  EXPECT_EQ(sha256_of_file(folder.path("file")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_of_file(folder.path("missing")), "");
}

TEST(Text, TimeIsIso8601) {
  const std::string now = utc_now();
  ASSERT_EQ(now.size(), 20u);
  EXPECT_EQ(now[10], 'T');
  EXPECT_EQ(now.back(), 'Z');
}

}  // namespace
}  // namespace mwt
