#include "harness/io/text/aligned_table.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(AlignedTable, AlignsNumbersRightAndNamesLeft) {
  AlignedTable table({"name", "n", "note"}, {2});
  EXPECT_TRUE(table.is_empty());
  table.add_row({"a", "1000", "x"});
  table.add_row({"longer", "5", ""});
  EXPECT_EQ(table.text(),
            "name       n  note\n"
            "a       1000  x\n"
            "longer     5\n");
}

TEST(AlignedTable, CountsCharactersNotBytes) {
  AlignedTable table({"x", "y"});
  table.add_row({"\xc3\xa4\xc3\xb6", "1"});
  table.add_row({"ab", "1"});
  EXPECT_EQ(table.text(), "x   y\n\xc3\xa4\xc3\xb6  1\nab  1\n");
}

TEST(AlignedTable, FitsAWidthByWrappingTexts) {
  AlignedTable table({"name", "n", "what it is"}, {2});
  table.add_row({"greedy k=-1", "1000", "keeps the shortest edges of a well-known order"});
  table.add_row({"exact", "5", "proves"});
  EXPECT_EQ(table.text_within(40),
            "name            n  what it is\n"
            "greedy k=-1  1000  keeps the shortest\n"
            "                   edges of a well-known\n"
            "                   order\n"
            "exact           5  proves\n");
  EXPECT_EQ(table.text_within(24),
            "name         n  what it\n"
            "                is\n"
            "greedy    1000  keeps\n"
            "k=-1            the\n"
            "                shortest\n"
            "                edges of\n"
            "                a well-\n"
            "                known\n"
            "                order\n"
            "exact        5  proves\n");
  EXPECT_EQ(table.text_within(1000), table.text());
  EXPECT_EQ(table.text_within(std::nullopt), table.text());
}

TEST(AlignedTable, BreaksWordsWhereNothingElseHelps) {
  AlignedTable table({"a", "n"});
  table.add_row({"\xc3\xa4\xc3\xb6-triangulation", "12345"});
  EXPECT_EQ(table.text_within(12),
            "a          n\n"
            "\xc3\xa4\xc3\xb6-tr  12345\n"
            "iangu\n"
            "latio\n"
            "n\n");
}

TEST(AlignedTable, RefusesRowsOfAnotherWidth) {
  EXPECT_THROW(AlignedTable({"x"}).add_row({"1", "2"}), std::logic_error);
}

}  // namespace
}  // namespace mwt
