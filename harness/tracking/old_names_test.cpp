#include "harness/tracking/old_names.h"

#include <gtest/gtest.h>

#include "base/parameters.h"
#include "harness/run/catalogue.h"

namespace mwt {
namespace {

TEST(OldNames, BecomeThePresentOnes) {
  EXPECT_EQ(present_name("yardstick_time_s"), "delaunay_time_s");
  EXPECT_EQ(present_name("greedy_report"), "greedy_naive");
  EXPECT_EQ(present_name("flip_report"), "flip_naive");
  EXPECT_EQ(present_name("report_example"), "report_example");
}

TEST(OldNames, ParametersOfPatchGetTheirPresentCanonicalForm) {
  const Catalogue catalogue = Catalogue::built_in();
  const AlgorithmInfo& patch = catalogue.algorithm("patch");
  const std::string present = Parameters(patch.name, patch.parameters, {}).canonical();
  EXPECT_EQ(present_params("patch", "k=6 long_k=0 passes=0 start=greedy walls=on"), present);
  EXPECT_EQ(present_params("patch", present), present);
  EXPECT_EQ(present_params("flip", "walls=on"), "walls=on") << "no parameter of it was renamed";
  EXPECT_EQ(present_params("patch", ""), "");
}

}  // namespace
}  // namespace mwt
