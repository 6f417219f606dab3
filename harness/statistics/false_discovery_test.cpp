#include "harness/statistics/false_discovery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generators/random.h"

namespace mwt {
namespace {

// The example of the paper, section 3.2: 15 p-values, of which the procedure rejects the four smallest at 5%.
TEST(BenjaminiHochberg, ExampleOfThePaper) {
  const std::vector<double> p = {0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                                 0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000};
  const std::vector<double> adjusted = benjamini_hochberg(p);
  for (std::size_t i = 0; i < p.size(); ++i) EXPECT_EQ(adjusted[i] <= 0.05, i < 4) << i;
  EXPECT_DOUBLE_EQ(adjusted[0], 0.0015);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.0030);
  EXPECT_DOUBLE_EQ(adjusted[3], 0.035625);
  EXPECT_DOUBLE_EQ(adjusted[14], 1);
}

TEST(BenjaminiHochberg, KeepsTheOrderOfItsArguments) {
  // R: p.adjust(c(0.04, 0.01, 0.03), "BH")
  const std::vector<double> adjusted = benjamini_hochberg(std::vector<double>{0.04, 0.01, 0.03});
  EXPECT_DOUBLE_EQ(adjusted[0], 0.04);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.03);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.04);
}

TEST(BenjaminiHochberg, OneTestIsLeftAsItIs) {
  EXPECT_EQ(benjamini_hochberg(std::vector<double>{0.03}), std::vector<double>{0.03});
  EXPECT_TRUE(benjamini_hochberg({}).empty());
}

TEST(BenjaminiHochberg, RefusesWhatIsNoProbability) {
  EXPECT_THROW((void)benjamini_hochberg(std::vector<double>{-0.1}), std::invalid_argument);
  EXPECT_THROW((void)benjamini_hochberg(std::vector<double>{std::nan("")}), std::invalid_argument);
}

// Where no test has anything to find, some test is rejected in at most a share q of the experiments.
TEST(BenjaminiHochberg, HoldsItsPromiseWithoutAnyEffect) {
  RandomEngine engine = make_engine("false_discovery_test", 1);
  int alarms = 0;
  for (int experiment = 0; experiment < 2000; ++experiment) {
    std::vector<double> p(40);
    for (double& value : p) value = uniform_unit(engine);
    const std::vector<double> adjusted = benjamini_hochberg(p);
    alarms += *std::min_element(adjusted.begin(), adjusted.end()) <= 0.05;
  }
  EXPECT_NEAR(alarms / 2000.0, 0.05, 0.02);
}

}  // namespace
}  // namespace mwt
