#include "harness/statistics/holm.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace mwt {
namespace {

TEST(Holm, KnownAnswers) {
  // R: p.adjust(c(0.01, 0.02, 0.03, 0.04, 0.05), "holm")
  const std::vector<double> adjusted = holm_adjusted(std::vector<double>{0.01, 0.02, 0.03, 0.04, 0.05});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.05);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.08);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.09);
  EXPECT_DOUBLE_EQ(adjusted[3], 0.09) << "2 * 0.04 is less than that of a smaller p-value";
  EXPECT_DOUBLE_EQ(adjusted[4], 0.09);
}

TEST(Holm, KeepsTheOrderOfItsArguments) {
  const std::vector<double> adjusted = holm_adjusted(std::vector<double>{0.9, 0.001, 0.5});
  EXPECT_DOUBLE_EQ(adjusted[1], 0.003);
  EXPECT_DOUBLE_EQ(adjusted[2], 1);
  EXPECT_DOUBLE_EQ(adjusted[0], 1);
}

TEST(Holm, RefusesWhatIsNoProbability) {
  EXPECT_THROW((void)holm_adjusted(std::vector<double>{1.1}), std::invalid_argument);
  EXPECT_TRUE(holm_adjusted({}).empty());
}

}  // namespace
}  // namespace mwt
