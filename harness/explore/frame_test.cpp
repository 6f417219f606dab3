#include "harness/explore/frame.h"

#include <gtest/gtest.h>

namespace mwt {
namespace {

TEST(Frame, IsReadAsItWasWritten) {
  const std::vector<Point> points = {{0.1, -1e300}, {5e-324, 3}};
  const std::string text = encoded({R"({"job":"solve"})", bytes_of(points)});
  const std::optional<Frame> frame = decoded(text);
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->json.substr(0, 15), R"({"job":"solve"})");
  EXPECT_EQ(points_in(frame->bytes), points);
  EXPECT_EQ((text.size() - frame->bytes.size()) % 8, 0U) << "the page reads doubles in place";
}

TEST(Frame, IsNothingIfItsLengthsAreWrong) {
  const std::string text = encoded({"{}", "12345678"});
  EXPECT_FALSE(decoded(""));
  EXPECT_FALSE(decoded(text.substr(0, 7)));
  EXPECT_FALSE(decoded(text.substr(0, text.size() - 1)));
  EXPECT_FALSE(decoded(text + "x"));
  EXPECT_FALSE(decoded(std::string(8, '\xff')));
  EXPECT_FALSE(points_in("123456789"));
}

}  // namespace
}  // namespace mwt
