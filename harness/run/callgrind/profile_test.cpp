#include "harness/run/callgrind/profile.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace mwt {
namespace {

// As callgrind 3.19 writes it: names are given once and then numbered; the line after "calls=" holds what the called
// function cost, which its own lines hold already; "'2" is the second level of a recursion.
constexpr const char* kOutput = R"(# callgrind format
version: 1
creator: callgrind-3.19.0
positions: line
events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw Bc Bcm Bi Bim
summary: 1000 1 1 1 1 1 1 1 1 1 1 1 1

ob=(1) /usr/bin/mwt
fl=(1) ???
fn=(1) mwt::(anonymous namespace)::LmtKernel::find_pair(unsigned int)
0 600 10 10 1 2 3 1 1 1 100 5 10 2
+3 100 0 0 0 1
cob=(2) /usr/lib/libm.so.6
cfn=(2) mwt::weight(std::span<mwt::Point const, 18446744073709551615ul>, mwt::Triangulation const&)
calls=3 0
0 999 9 9

fn=(2)
0 200
fn=(3) mwt::(anonymous namespace)::LmtKernel::find_pair(unsigned int)'2
* 50

totals: 950
)";

TEST(CallgrindProfile, SumsCostsAndGivesEachFunctionItsOwn) {
  const CallgrindProfile profile = parse_callgrind(kOutput);
  EXPECT_EQ(profile.counts.instructions, 950u);
  EXPECT_EQ(profile.counts.l1_misses, 7u);
  EXPECT_EQ(profile.counts.ll_misses, 3u);
  EXPECT_EQ(profile.counts.branch_misses, 7u);
  ASSERT_EQ(profile.functions.size(), 2u);
  EXPECT_EQ(profile.functions.at("mwt::(anonymous namespace)::LmtKernel::find_pair(unsigned int)"), 750u);
}

TEST(CallgrindProfile, RefusesWhatIsNone) {
  EXPECT_THROW((void)parse_callgrind(""), std::invalid_argument);
  EXPECT_THROW((void)parse_callgrind("events: Ir\nfn=(1) f\n"), std::invalid_argument) << "nothing was counted";
  EXPECT_THROW((void)parse_callgrind("events: Ir\nfn=(1) f\n0 many\n"), std::invalid_argument);
}

TEST(CallgrindProfile, ShortNames) {
  EXPECT_EQ(short_function_name("mwt::(anonymous namespace)::LmtKernel::find_pair(unsigned int) const"),
            "LmtKernel::find_pair");
  EXPECT_EQ(short_function_name("mwt::weight(std::span<mwt::Point const, 18446744073709551615ul>, mwt::T const&)"),
            "weight");
  EXPECT_EQ(short_function_name("void std::__introsort_loop<int*, long>(int*, int*, long)"), "std::__introsort_loop");
  EXPECT_EQ(short_function_name("_int_malloc"), "_int_malloc");
  EXPECT_EQ(short_function_name("mwt::PatchPolygon::grow(unsigned int) [clone .isra.0]"), "PatchPolygon::grow");
  EXPECT_EQ(short_function_name("operator new(unsigned long)"), "operator new(unsigned long)");
}

TEST(CallgrindProfile, NamesTheFunctionThatChangedMost) {
  const FunctionCounts before = {{"a", 1000}, {"b", 100}, {"c", 50}};
  const auto more = most_changed(before, {{"a", 1000}, {"b", 114}, {"c", 40}});
  ASSERT_TRUE(more);
  EXPECT_EQ(more->text(), "b +14.0%");
  const auto fewer = most_changed(before, {{"a", 1000}, {"b", 114}, {"c", 10}});
  ASSERT_TRUE(fewer);
  EXPECT_EQ(fewer->text(), "c -80.0%");
  EXPECT_EQ(most_changed(before, {{"a", 1000}, {"b", 100}, {"c", 50}, {"d", 9}})->text(), "d (new)");
  EXPECT_EQ(most_changed(before, {{"a", 1000}, {"b", 100}})->text(), "c (gone)");
  EXPECT_FALSE(most_changed(before, before));
  EXPECT_FALSE(most_changed(before, {}));
}

TEST(CallgrindProfile, CsvKeepsWhatIsWorthAThousandth) {
  const FunctionCounts functions = {{"f(int, int)", 100'000}, {"small", 60}, {"smaller", 30}};
  const FunctionCounts kept = functions_of_csv(to_csv(functions));
  EXPECT_EQ(kept, (FunctionCounts{{"f(int, int)", 100'000}, {"(other functions)", 90}}));
  EXPECT_THROW((void)functions_of_csv("function,instructions\na,b\n"), std::invalid_argument);
}

}  // namespace
}  // namespace mwt
