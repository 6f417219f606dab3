#include "geometry/utf8.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(Utf8, CharactersHaveTheirLengths) {
  EXPECT_EQ(utf8_length("a", 0), 1u);
  EXPECT_EQ(utf8_length("x\xc3\xa9", 1), 2u);
  EXPECT_EQ(utf8_length("\xe2\x88\x92", 0), 3u);
  EXPECT_EQ(utf8_length("\xf0\x9f\x98\x80", 0), 4u);
}

TEST(Utf8, OtherBytesAreNone) {
  for (const char* text : {"\xff", "\x80", "\xc3", "\xc3x", "\xc0\xaf", "\xe0\x80\xaf", "\xe2\x88", "\xf0\x80\x80\xaf",
                           "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80"}) {
    EXPECT_EQ(utf8_length(text, 0), 0u) << text;
  }
}

}  // namespace
}  // namespace mwt
