#include "generators/arguments.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace mwt {
namespace {

template <class Call>
std::string message_of(Call call) {
  try {
    call();
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Arguments, sizes_out_of_range_name_the_nearest) {
  EXPECT_EQ(message_of([] { require_size("f", 3, 3, 9); }), "");
  EXPECT_EQ(message_of([] { require_size("f", 9, 3, 9); }), "");
  EXPECT_EQ(message_of([] { require_size("f", 2, 3, 9); }),
            "f: has no instance of n=2 points; the nearest legal n is 3");
  EXPECT_EQ(message_of([] { require_size("f", 12, 3, 9); }),
            "f: has no instance of n=12 points; the nearest legal n is 9");
}

TEST(Arguments, parameters_out_of_range_name_the_range) {
  const std::vector<ParameterInfo> declared = {{"width", ParameterType::real, "0.5", ""},
                                               {"count", ParameterType::integer, "3", ""}};
  const Parameters defaults("f", declared, {});
  EXPECT_EQ(real_within("f", defaults, "width", 0, .5), .5);
  EXPECT_EQ(integer_within("f", defaults, "count", 3, 4), 3);
  EXPECT_EQ(message_of([&] { (void)real_within("f", defaults, "width", 1, 1e300); }),
            "f: parameter width=0.5 is not between 1 and 1e+300");
  EXPECT_EQ(message_of([&] { (void)integer_within("f", defaults, "count", -1, 2); }),
            "f: parameter count=3 is not between -1 and 2");
}

}  // namespace
}  // namespace mwt
