#include "harness/io/text/text_table.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/testing/test_folder.h"

namespace mwt {
namespace {

using test::message_of;

using Row = std::vector<std::string>;

struct Content {
  std::vector<std::string> header;
  std::vector<Row> rows;
};

Content content_of(std::string_view text) {
  TextTable table("t.csv", text);
  Content content{table.header(), {}};
  while (table.next_row()) content.rows.emplace_back(table.columns().begin(), table.columns().end());
  return content;
}

std::vector<Row> rows(std::string_view text) { return content_of(text).rows; }
std::vector<std::string> header(std::string_view text) { return content_of(text).header; }
std::string mistake(std::string_view text) {
  return message_of<InputError>([&] { static_cast<void>(content_of(text)); });
}

TEST(TextTable, TabsKeepEmptyCells) {
  EXPECT_EQ(rows("site\tx\ty\nRoute 66\t\t3.5\n\t1\t2\nMill\t4\t\n"),
            (std::vector<Row>{{"Route 66", "", "3.5"}, {"", "1", "2"}, {"Mill", "4", ""}}));
  EXPECT_EQ(header("\tx\ty\n0\t1\t2\n"), (Row{"", "x", "y"})) << "an index without a name";
  EXPECT_EQ(rows("1\t\t2\n"), (std::vector<Row>{{"1", "", "2"}}));
}

TEST(TextTable, TabsThatOnlyIndentOrPadAreBlanks) {
  EXPECT_EQ(rows("\t1\t2\n3\t4\t\r\n"), (std::vector<Row>{{"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(rows("1,\t2\n3\t,4\n"), (std::vector<Row>{{"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(rows("x\ty\n1\t2\t# far\n"), (std::vector<Row>{{"1", "2"}}));
}

TEST(TextTable, TabsWinOverCommasWithinCells) {
  EXPECT_EQ(rows("name\tx\ty\nMain St, 5\t1\t2\nA, B; C\t3\t4\n"),
            (std::vector<Row>{{"Main St, 5", "1", "2"}, {"A, B; C", "3", "4"}}));
}

TEST(TextTable, QuotesKeepSeparatorsAndComments) {
  EXPECT_EQ(rows("name,x,y\n\"Main St, #5\",1,2\n\"say \"\"a\"\"\",\"3\",4\n"),
            (std::vector<Row>{{"Main St, #5", "1", "2"}, {"say \"\"a\"\"", "3", "4"}}));
  EXPECT_EQ(rows("\"1\",\"2\" # first\n\"3\" , \" 4 \"\n"), (std::vector<Row>{{"1", "2"}, {"3", "4"}}));
  EXPECT_EQ(rows("\"Route 66\" 1 2\n"), (std::vector<Row>{{"Route 66", "1", "2"}}));
  EXPECT_EQ(rows("name,x\n5\" pipe,1\n"), (std::vector<Row>{{"5\" pipe", "1"}})) << "no quote opens within a cell";
  EXPECT_EQ(rows("x,y # \"a\n1,2\n"), (std::vector<Row>{{"1", "2"}}));
  EXPECT_EQ(mistake("1,\"2\n3,4\"\n"),
            "t.csv:1: a quote is opened and not closed; write every row on one line, or leave the quotes out");
}

TEST(TextTable, SpreadsheetsNameTheirSeparator) {
  EXPECT_EQ(rows("sep=;\nx;y\n1;2\n"), (std::vector<Row>{{"1", "2"}}));
  EXPECT_EQ(rows("SEP=|\n1|2\n"), (std::vector<Row>{{"1", "2"}}));
  EXPECT_EQ(rows("sep=\t\nx\ty\n\t2\n"), (std::vector<Row>{{"", "2"}}));
  EXPECT_EQ(rows("sep=;\n1,5;2\n"), (std::vector<Row>{{"1,5", "2"}})) << "read, and refused as a number";
  EXPECT_EQ(mistake("sep=ab\n1,2\n"), "t.csv:1: 'sep=ab' names no separator; use sep=, or sep=; or leave the line out");
}

TEST(TextTable, AFirstRowWithoutNumbersIsAHeaderOnlyIfItIsMadeOfNames) {
  EXPECT_EQ(header("x,y\n"), (Row{"x", "y"}));
  EXPECT_EQ(header("\"X\",'Y'\n"), (Row{"x", "y"}));
  EXPECT_EQ(header("_x \xC3\xB6stlich\n"), (Row{"_x", "\xC3\xB6stlich"}));
  for (const char* row : {"\xE2\x88\x92"
                          "1,\xE2\x88\x92"
                          "1",
                          "NA,NA", "0.5f,1.5f", "59.3 deg,18 deg", "0x1p3,0x1p4", "0.1D+01,0.2D+01", "(0,0)", "-,-",
                          ".,.", "x,NA", "?,?", "$1,$2", "1'000,2'000", "#N/A,#N/A"}) {
    EXPECT_TRUE(mistake(std::string(row) + "\n1,2\n").starts_with("t.csv:1: '")) << row << ": " << mistake(row);
  }
  EXPECT_EQ(mistake(",,\n1,2\n"), "t.csv:1: the first row is empty; leave it out, or write numbers");
}

TEST(TextTable, NamesHowANumberIsMisspelt) {
  EXPECT_EQ(mistake("\xE2\x88\x92"
                    "1 \xE2\x88\x92"
                    "1\n"),
            "t.csv:1: '\xE2\x88\x92"
            "1' is not a number; its minus sign is U+2212; write -");
  EXPECT_EQ(mistake("NA,NA\n"), "t.csv:1: 'NA' is not a number; the value is missing; leave the row out");
  EXPECT_EQ(mistake("#DIV/0!,1\n"), "t.csv:1: '#DIV/0!' is not a number; the value is missing; leave the row out");
  EXPECT_EQ(mistake("0.5f,1.5f\n"), "t.csv:1: '0.5f' is not a number; write the number alone, without what follows it");
  EXPECT_EQ(mistake("59.3 deg,18 deg\n"),
            "t.csv:1: '59.3 deg' is not a number; write the number alone, without what follows it");
  EXPECT_EQ(mistake("0x1p3 0x1p4\n"), "t.csv:1: '0x1p3' is not a number; write it as a decimal number");
  EXPECT_EQ(mistake("0.1D+01 1.D0\n"), "t.csv:1: '0.1D+01' is not a number; write the exponent with e, as in 1e-3");
  EXPECT_EQ(mistake("(0,0)\n"), "t.csv:1: '(0' is not a number; write numbers without brackets");
  EXPECT_EQ(mistake("1,5\t2,5\n"), "t.csv:1: '1,5' is not a number; write a decimal point instead of the comma");
  EXPECT_EQ(mistake("% x y\n"), "t.csv:1: '%' is not a number; comments begin with #");
  EXPECT_EQ(mistake("1\xC2\xA0"
                    "000,2\xC2\xA0"
                    "000\n"),
            "t.csv:1: '1\xC2\xA0"
            "000' is not a number; it has the character U+00A0; write it without");
  EXPECT_EQ(mistake("\xA0"
                    "1,\xA0"
                    "2\n"),
            "t.csv:1: '?1' is not a number; it has bytes that are no UTF-8; save the file as UTF-8");
  EXPECT_EQ(mistake(". .\n"), "t.csv:1: '.' is not a number; write one such as 1.5 or 2e-3");
}

TEST(TextTable, RowsKeepTheSeparatorOfTheFirst) {
  EXPECT_EQ(mistake("x;y\n1;2\n1,5\n"),
            "t.csv:3: commas between columns where the first row has semicolons; separate all rows alike, and write "
            "decimal points");
  EXPECT_EQ(
      mistake("1 2\n1,5\n"),
      "t.csv:2: commas between columns where the first row has blanks; separate all rows alike, and write decimal "
      "points");
  EXPECT_EQ(rows("x,y\n1 2\n3\t4\n"), (std::vector<Row>{{"1", "2"}, {"3", "4"}}));
}

TEST(TextTable, AMillionColumnsAreCounted) {
  std::string text = "1 2\n";
  for (int i = 0; i < 1000000; ++i) text += "7,";
  text += "7\n";
  EXPECT_EQ(mistake("1,2\n" + text.substr(4)),
            "t.csv:2: 1000001 columns where the first row has 2; give every row the same columns");
}

}  // namespace
}  // namespace mwt
