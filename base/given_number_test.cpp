#include "base/given_number.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

#include <cstdint>
#include "base/error.h"
#include "base/testing/test_folder.h"

namespace mwt {
namespace {

using test::message_of;

constexpr NumberRange<std::uint64_t> kSeeds{0, std::numeric_limits<std::uint64_t>::max()};

template <class Number>
std::string mistake(std::string_view text, NumberRange<Number> range) {
  return message_of<InputError>(
      [&] { static_cast<void>(given_number("--k '" + std::string(text) + "'", text, range)); });
}

TEST(GivenNumber, LeadingZerosAreDecimal) {
  EXPECT_EQ(given_number<std::uint32_t>("", "0100", {3, 1000}), 100U);
  EXPECT_EQ(given_number("", "08", kSeeds), 8U);
  EXPECT_EQ(given_number<int>("", "+007", {1, 8}), 7);
  EXPECT_EQ(given_number<double>("", "00.50", {0, 1}), 0.5);
}

TEST(GivenNumber, TakesTheWholeRange) {
  EXPECT_EQ(given_number("", "18446744073709551615", kSeeds), kSeeds.most);
  EXPECT_EQ(given_number("", "0", kSeeds), 0U);
  EXPECT_EQ(given_number<std::int64_t>("", "-9223372036854775808", {std::numeric_limits<std::int64_t>::min(), 0}),
            std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(given_number<double>("", "1e9", {1e-9, 1e9}), 1e9);
}

TEST(GivenNumber, NothingWrapsAround) {
  const std::string range = "; give a whole number from 0 to 18446744073709551615";
  EXPECT_EQ(mistake("-1", kSeeds), "--k '-1' is below 0" + range);
  EXPECT_EQ(mistake("18446744073709551616", kSeeds),
            "--k '18446744073709551616' is above 18446744073709551615" + range);
  EXPECT_EQ(mistake("-99999999999999999999", kSeeds), "--k '-99999999999999999999' is below 0" + range);
  EXPECT_EQ(mistake<std::uint32_t>("4294967296", {1, 8}),
            "--k '4294967296' is above 8; give a whole number from 1 to 8");
  EXPECT_EQ(mistake<int>("0", {1, 8}), "--k '0' is below 1; give a whole number from 1 to 8");
}

TEST(GivenNumber, NamesWhatIsNoNumber) {
  const std::string range = "; give a whole number from 0 to 18446744073709551615";
  EXPECT_EQ(mistake("", kSeeds), "--k '' is empty" + range);
  for (const char* text : {"x", "1.5", "1e3", "0x10", " 1", "1 ", "1,000", "nan", "inf", "--1", "+", "-"}) {
    EXPECT_EQ(mistake(text, kSeeds), std::string("--k '") + text + "' is not a whole number" + range);
  }
}

TEST(GivenNumber, NanAndInfinityAreInNoRange) {
  const NumberRange<double> seconds{0.5, 8};
  const std::string range = "; give a number from 0.5 to 8";
  EXPECT_EQ(mistake("nan", seconds), "--k 'nan' is not a number" + range);
  EXPECT_EQ(mistake("-nan", seconds), "--k '-nan' is not a number" + range);
  EXPECT_EQ(mistake("inf", seconds), "--k 'inf' is above 8" + range);
  EXPECT_EQ(mistake("-inf", seconds), "--k '-inf' is below 0.5" + range);
  EXPECT_EQ(mistake("1e999", seconds), "--k '1e999' is above 8" + range);
  EXPECT_EQ(mistake("0.4", seconds), "--k '0.4' is below 0.5" + range);
  EXPECT_EQ(mistake("1.5s", seconds), "--k '1.5s' is not a number" + range);
}

TEST(GivenNumber, AllNumbersOfATypeNeedNoEndsInTheMessage) {
  constexpr NumberRange<double> kReals{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max()};
  EXPECT_EQ(mistake("x", kReals), "--k 'x' is not a number");
  EXPECT_EQ(mistake("", kReals), "--k '' is empty; give a number");
  EXPECT_EQ(mistake("inf", kReals), "--k 'inf' is above 1.7976931348623157e+308; give a number");
}

}  // namespace
}  // namespace mwt
