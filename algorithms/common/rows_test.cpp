#include "algorithms/common/rows.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace mwt {
namespace {

template <class Value>
std::vector<Value> row_of(const Rows<Value>& rows, std::size_t row) {
  return {rows[row].begin(), rows[row].end()};
}

TEST(Rows, KeepTheOrderOfTheirValues) {
  const std::vector<std::pair<std::size_t, std::string>> calls{{3, "a"}, {0, "b"}, {3, "c"}, {1, "d"}, {3, "a"}};
  const Rows<std::string> rows = file_in_rows<std::string>(5, [&](const auto& file) {
    for (const auto& [row, value] : calls) file(row, value);
  });
  EXPECT_EQ(rows.first, (std::vector<std::uint32_t>{0, 1, 2, 2, 5, 5}));
  EXPECT_EQ(row_of(rows, 0), (std::vector<std::string>{"b"}));
  EXPECT_EQ(row_of(rows, 1), (std::vector<std::string>{"d"}));
  EXPECT_TRUE(rows[2].empty());
  EXPECT_EQ(row_of(rows, 3), (std::vector<std::string>{"a", "c", "a"}));
  EXPECT_TRUE(rows[4].empty()) << "the last row may be empty";
}

TEST(Rows, MayAllBeEmpty) {
  const Rows<int> none = file_in_rows<int>(0, [](const auto&) {});
  EXPECT_EQ(none.first, (std::vector<std::uint32_t>{0}));
  const Rows<int> rows = file_in_rows<int>(2, [](const auto&) {});
  EXPECT_TRUE(rows[0].empty());
  EXPECT_TRUE(rows[1].empty());
  EXPECT_EQ(Rows<int>().first, none.first);
}

TEST(Rows, CanBeChangedInPlace) {
  Rows<int> rows = file_in_rows<int>(2, [](const auto& file) {
    file(1, 7);
    file(0, 5);
  });
  rows[1][0] = 8;
  EXPECT_EQ(rows.values, (std::vector<int>{5, 8}));
}

}  // namespace
}  // namespace mwt
