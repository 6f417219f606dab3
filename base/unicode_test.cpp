#include "base/unicode.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(Unicode, CharactersHaveTheirSizesAndCodePoints) {
  EXPECT_EQ(first_character("ab")->code_point, U'a');
  EXPECT_EQ(first_character("\xc3\xa9x")->code_point, U'\u00e9');
  EXPECT_EQ(first_character("\xe2\x88\x92")->code_point, U'\u2212');
  EXPECT_EQ(first_character("\xe2\x88\x92")->size, 3u);
  EXPECT_EQ(first_character("\xf0\x9f\x98\x80")->size, 4u);
}

TEST(Unicode, OtherBytesAreNoCharacters) {
  for (const char* text : {"", "\xff", "\x80", "\xc3", "\xc3x", "\xc0\xaf", "\xe0\x80\xaf", "\xe2\x88",
                           "\xf0\x80\x80\xaf", "\xf4\x90\x80\x80", "\xf8\x88\x80\x80\x80", "\xed\xa0\x80"}) {
    EXPECT_FALSE(first_character(text)) << text;
  }
}

TEST(Unicode, WhatIsAppendedReadsBack) {
  for (const char32_t code_point : {U'a', U'\u00e9', U'\u2212', U'\U0001f600'}) {
    std::string text;
    append_character(text, code_point);
    EXPECT_EQ(first_character(text)->code_point, code_point);
    EXPECT_EQ(first_character(text)->size, text.size());
  }
}

TEST(Unicode, NamesAndLetters) {
  EXPECT_EQ(code_point_name(U'\u2212'), "U+2212");
  EXPECT_TRUE(is_letter(U'\u00e9'));
  EXPECT_FALSE(is_letter(U'\u2212'));
}

}  // namespace
}  // namespace mwt
