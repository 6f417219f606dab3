#include "harness/io/text/text_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "base/unicode.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

// Pieces with NUL bytes in them.
template <std::size_t kSize>
std::string bytes(const char (&text)[kSize]) {
  return {text, kSize - 1};
}

std::string mistake_in_file(const std::string& content) {
  return message_of<InputError>([&] { static_cast<void>(as_plain_text(content, "p.txt")); });
}

TEST(TextFile, ByteOrderMarksAreRemoved) {
  EXPECT_EQ(as_plain_text("\xEF\xBB\xBFx y\n", ""), "x y\n");
  EXPECT_EQ(as_plain_text("\xEF\xBB\xBF\xEF\xBB\xBFx y\n", ""), "x y\n");
  EXPECT_EQ(as_plain_text("\xEF\xBB", ""), "\xEF\xBB");
  EXPECT_EQ(as_plain_text("", ""), "");
}

TEST(TextFile, Utf16IsConverted) {
  EXPECT_EQ(as_plain_text(bytes("\xFF\xFE"
                                "1\0 \0\x12\x22"
                                "2\0\r\0\n\0"),
                          ""),
            "1 \xE2\x88\x92"
            "2\r\n");
  EXPECT_EQ(as_plain_text(bytes("\xFE\xFF\0"
                                "1\0 \0"
                                "2"),
                          ""),
            "1 2");
  EXPECT_EQ(as_plain_text(bytes("\xFF\xFE\x3D\xD8\x00\xDE"), ""), "\xF0\x9F\x98\x80");
}

TEST(TextFile, BrokenUtf16IsNamed) {
  const std::string message = "p.txt: begins like UTF-16 but is broken; save it as UTF-8";
  EXPECT_EQ(mistake_in_file(bytes("\xFF\xFE"
                                  "1\0"
                                  "2")),
            message)
      << "half a unit";
  EXPECT_EQ(mistake_in_file(bytes("\xFF\xFE\x3D\xD8"
                                  "1\0")),
            message)
      << "half a character";
  EXPECT_EQ(mistake_in_file(bytes("\xFF\xFE\x00\xDE")), message) << "its other half";
}

TEST(TextFile, NulBytesAreNoText) {
  const std::string remedy =
      ": has a NUL byte, so it is no text, or UTF-16 without a byte order mark; save it as UTF-8";
  EXPECT_EQ(mistake_in_file(bytes("1 2\n3 \0"
                                  "4\n")),
            "p.txt:2" + remedy);
  EXPECT_EQ(mistake_in_file(bytes("1\0 \0"
                                  "2\0")),
            "p.txt:1" + remedy);
  EXPECT_EQ(mistake_in_file(bytes("\xFF\xFE\0\0"
                                  "1\0\0\0")),
            "p.txt:1" + remedy)
      << "UTF-32";
}

TEST(TextFile, ACarriageReturnAloneEndsALine) {
  EXPECT_EQ(as_plain_text("1 2\r3 4\r\n5 6\r", ""), "1 2\n3 4\r\n5 6\n");
}

TEST(TextFile, NamesStandardInput) {
  EXPECT_EQ(message_of<InputError>([] { static_cast<void>(read_text_file("/no/such/file")); }),
            "/no/such/file: no such file; check the name");
}

TEST(Unicode, CharactersSurviveTheRoundTrip) {
  for (const char32_t code_point :
       {U'\0', U'x', U'\x7F', U'\x80', U'\x7FF', U'\x800', U'\xFFFF', U'\x10000', U'\x10FFFF'}) {
    std::string text;
    append_character(text, code_point);
    const auto character = first_character(text + "x");
    ASSERT_TRUE(character.has_value()) << code_point_name(code_point);
    EXPECT_EQ(character->code_point, code_point);
    EXPECT_EQ(character->size, text.size());
    EXPECT_FALSE(first_character(text.substr(0, text.size() - 1)).has_value());
  }
}

TEST(Unicode, InvalidBytesAreNoCharacter) {
  for (const char* text : {"\x80", "\xC0\x80", "\xC1\xBF", "\xE0\x80\x80", "\xED\xA0\x80", "\xF0\x80\x80\x80",
                           "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xC3(", "\xFF"}) {
    EXPECT_FALSE(first_character(text).has_value());
  }
}

TEST(Unicode, LettersAreTold) {
  for (const char32_t letter : {U'a', U'Z', U'\xE4', U'\x3BE', U'\x448', U'\x6771'}) EXPECT_TRUE(is_letter(letter));
  for (const char32_t other : {U'1', U'_', U'-', U'\xD7', U'\xB0', U'\x2212', U'\xFF11'})
    EXPECT_FALSE(is_letter(other));
}

}  // namespace
}  // namespace mwt
