#include "base/parameters.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/error.h"
#include "base/testing/test_folder.h"

namespace mwt {
namespace {

using test::message_of;

const std::vector<ParameterInfo> kDeclared{
    {"k", ParameterType::integer, "6", "neighbours", {}},
    {"ratio", ParameterType::real, "0.5", "share", {}},
    {"name", ParameterType::text, "", "any text", {}},
    {"start", ParameterType::choice, "greedy", "where to start", {"greedy", "delaunay"}},
};

Parameters given(const std::map<std::string, std::string>& values) { return {"flip_naive", kDeclared, values}; }

std::string error(const std::map<std::string, std::string>& values) {
  return message_of<InputError>([&] { given(values); });
}

TEST(Parameters, HaveTheirDefaults) {
  const Parameters parameters = given({});
  EXPECT_EQ(parameters.integer("k"), 6);
  EXPECT_EQ(parameters.real("ratio"), 0.5);
  EXPECT_EQ(parameters.text("name"), "");
  EXPECT_EQ(parameters.text("start"), "greedy");
  EXPECT_EQ(parameters.all().size(), 4U);
}

TEST(Parameters, AreOverridden) {
  const Parameters parameters = given({{"k", "-12"}, {"ratio", "1e-3"}, {"start", "delaunay"}, {"name", "a b"}});
  EXPECT_EQ(parameters.integer("k"), -12);
  EXPECT_EQ(parameters.real("ratio"), 0.001);
  EXPECT_EQ(parameters.text("start"), "delaunay");
  EXPECT_EQ(parameters.text("name"), "a b");
}

TEST(Parameters, NameThemselvesCanonically) {
  EXPECT_EQ(given({{"start", "delaunay"}, {"name", "x"}}).canonical(), "k=6 name=x ratio=0.5 start=delaunay");
  EXPECT_EQ(Parameters().canonical(), "");
}

TEST(Parameters, EqualNumbersAreOneConfiguration) {
  EXPECT_EQ(given({{"k", "08"}, {"ratio", "+.250"}}).canonical(), given({{"k", "8"}, {"ratio", "0.25"}}).canonical());
  EXPECT_EQ(given({{"k", "006"}, {"ratio", ".5"}}).canonical(), given({}).canonical());
}

TEST(Parameters, RejectWhatIsNotDeclared) {
  EXPECT_EQ(error({{"q", "1"}}), "flip_naive: unknown parameter 'q'; it has k, ratio, name, start");
  EXPECT_EQ(message_of<InputError>([] {
              Parameters("delaunay", {}, {{"q", "1"}});
            }),
            "delaunay: unknown parameter 'q'; it has none");
}

TEST(Parameters, RejectValuesOfTheWrongType) {
  for (const char* value : {"x", "1.5", "1 ", "0x10"}) {
    EXPECT_EQ(error({{"k", value}}), "flip_naive: parameter k=" + std::string(value) + " is not a whole number");
  }
  EXPECT_EQ(error({{"k", ""}}), "flip_naive: parameter k= is empty; give a whole number");
  EXPECT_EQ(error({{"k", "99999999999999999999"}}),
            "flip_naive: parameter k=99999999999999999999 is above 9223372036854775807; give a whole number");
  for (const char* value : {"x", "nan", "1,5"}) {
    EXPECT_EQ(error({{"ratio", value}}), "flip_naive: parameter ratio=" + std::string(value) + " is not a number");
  }
  for (const char* value : {"inf", "1e999"}) {
    EXPECT_EQ(error({{"ratio", value}}),
              "flip_naive: parameter ratio=" + std::string(value) + " is above 1.7976931348623157e+308; give a number");
  }
  EXPECT_EQ(error({{"start", "sweep"}}), "flip_naive: parameter start=sweep is not one of greedy, delaunay");
}

TEST(Parameters, AskingForTheWrongNameIsAProgrammingError) {
  EXPECT_THROW(static_cast<void>(given({}).integer("no")), std::out_of_range);
  EXPECT_THROW(static_cast<void>(given({}).text("no")), std::out_of_range);
  EXPECT_THROW(static_cast<void>(given({}).integer("start")), InputError);
}

TEST(Parameters, BlanksInAValueDoNotSeparate) {
  const std::string value = "my  file=%20\t\xff \xc3\xa9.csv";
  EXPECT_EQ(canonical_parameter("start", value), "start=my%20%20file=%2520%09%FF%20\xc3\xa9.csv");
  const std::map<std::string, std::string> values = {{"k", "6"}, {"start", value}};
  EXPECT_EQ(parse_canonical("k=6 " + canonical_parameter("start", value)), values);
  EXPECT_EQ(parse_canonical("a=%zz b= c"), (std::map<std::string, std::string>{{"a", "%zz"}, {"b", ""}}));
}

TEST(Parameters, AnUndeclaredNameIsToldAsAMistakeOfTheCode) {
  const Parameters parameters("owner", {{"sigma", ParameterType::real, "1", ""}}, {});
  try {
    static_cast<void>(parameters.real("sgima"));
    ADD_FAILURE();
  } catch (const std::out_of_range& failure) {
    EXPECT_EQ(std::string(failure.what()),
              "the code of 'owner' reads a parameter 'sgima' that its entry does not declare; it declares sigma");
  }
}

}  // namespace
}  // namespace mwt
