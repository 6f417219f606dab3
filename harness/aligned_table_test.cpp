#include "harness/aligned_table.h"

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

TEST(AlignedTable, RefusesRowsOfAnotherWidth) {
  EXPECT_THROW(AlignedTable({"x"}).add_row({"1", "2"}), std::logic_error);
}

}  // namespace
}  // namespace mwt
