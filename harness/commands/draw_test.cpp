// Runs `mwt draw` as its users do.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>

#include "harness/test_support.h"

namespace mwt {
namespace {

using testing::read_text;
using testing::write_text;

class Draw : public ::testing::Test {
 protected:
  // A square with its centre, and one side's quadrilateral cut either way.
  void SetUp() override {
    write("p.txt", "0 0\n4 0\n4 4\n0 4\n2 1\n2 3\n");
    write("a.csv", "a,b,c\n0,1,4\n1,2,4\n2,5,4\n2,3,5\n3,0,5\n0,4,5\n");
    write("b.csv", "a,b,c\n0,1,4\n1,2,5\n1,5,4\n2,3,5\n3,0,5\n0,4,5\n");
  }

  int mwt(const std::string& arguments) const {
    const std::string command = "cd " + folder_.path("") + " && " MWT_EXECUTABLE " " + arguments + " >.out 2>.err";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  void write(const std::string& name, const std::string& text) const { write_text(folder_.path(name), text); }
  [[nodiscard]] std::string read(const std::string& name) const { return read_text(folder_.path(name)); }

  // How many segments a layer of the picture has.
  [[nodiscard]] std::ptrdiff_t segments(const std::string& picture, const std::string& layer) const {
    const std::string text = read(picture);
    const std::size_t begin = text.find("class=\"line " + layer);
    if (begin == std::string::npos) return 0;
    const std::size_t path = text.find(" d=\"", begin);
    return std::count(text.begin() + static_cast<std::ptrdiff_t>(path),
                      text.begin() + static_cast<std::ptrdiff_t>(text.find("/>", path)), 'M');
  }

  testing::TemporaryFolder folder_;
};

TEST_F(Draw, OneTriangulation) {
  ASSERT_EQ(mwt("draw p.txt a.csv -o out.svg"), 0) << read(".err");
  EXPECT_EQ(segments("out.svg", "edges"), 11);
  EXPECT_EQ(segments("out.svg", "underlay"), 0);
  EXPECT_EQ(segments("out.svg", "highlight"), 0);
  EXPECT_NE(read(".out").find("a.csv     11"), std::string::npos) << read(".out");
}

TEST_F(Draw, TwoTriangulationsWithTheirDifference) {
  ASSERT_EQ(mwt("draw p.txt a.csv b.csv -o out.svg"), 0) << read(".err");
  EXPECT_EQ(segments("out.svg", "edges"), 11);
  EXPECT_EQ(segments("out.svg", "underlay"), 11);
  EXPECT_EQ(segments("out.svg", "highlight"), 1);
  EXPECT_NE(read(".out").find("only in the first (orange)          1   3.605551"), std::string::npos) << read(".out");
  ASSERT_EQ(mwt("draw p.txt a.csv a.csv -o same.svg"), 0);
  EXPECT_EQ(segments("same.svg", "highlight"), 0);
}

TEST_F(Draw, DuplicatesKeepTheNumbersOfTheFile) {
  write("q.txt", "0 0\n0 0\n4 0\n4 4\n0 4\n");
  write("t.csv", "0,2,3\n0,3,4\n");
  ASSERT_EQ(mwt("draw q.txt t.csv -o out.svg"), 0) << read(".err");
  EXPECT_EQ(segments("out.svg", "edges"), 5);
}

TEST_F(Draw, MistakesLeaveNoPicture) {
  write("bad.csv", "0,1,4\n");
  EXPECT_EQ(mwt("draw p.txt bad.csv -o out.svg"), 2);
  EXPECT_NE(read(".err").find("bad.csv: not a triangulation of these points"), std::string::npos) << read(".err");
  EXPECT_EQ(mwt("draw p.txt a.csv bad.csv -o out.svg"), 2);
  EXPECT_EQ(mwt("draw p.txt a.csv"), 2);
  EXPECT_EQ(mwt("draw p.txt missing.csv -o out.svg"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("out.svg")));
}

}  // namespace
}  // namespace mwt
