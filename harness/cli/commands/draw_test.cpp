// Runs `mwt draw` as its users do.
#include <gtest/gtest.h>

#include <algorithm>

#include "harness/cli/testing/commands_testing.h"

namespace mwt {
namespace {

class Draw : public testing::CommandTest {
 protected:
  // A square with its centre, and one side's quadrilateral cut either way.
  void SetUp() override {
    write("p.txt", "0 0\n4 0\n4 4\n0 4\n2 1\n2 3\n");
    write("a.csv", "a,b,c\n0,1,4\n1,2,4\n2,5,4\n2,3,5\n3,0,5\n0,4,5\n");
    write("b.csv", "a,b,c\n0,1,4\n1,2,5\n1,5,4\n2,3,5\n3,0,5\n0,4,5\n");
  }

  // How many segments a layer of the picture has.
  [[nodiscard]] std::ptrdiff_t segments(const std::string& picture, const std::string& layer) const {
    const std::string text = read(picture);
    const std::size_t begin = text.find("class=\"line " + layer);
    if (begin == std::string::npos) return 0;
    const std::size_t path = text.find(" d=\"", begin);
    return std::count(text.begin() + static_cast<std::ptrdiff_t>(path),
                      text.begin() + static_cast<std::ptrdiff_t>(text.find("/>", path)), 'M');
  }
};

TEST_F(Draw, OneTriangulation) {
  const std::string output = run("draw p.txt a.csv -o out.svg");
  EXPECT_EQ(segments("out.svg", "edges"), 11);
  EXPECT_EQ(segments("out.svg", "underlay"), 0);
  EXPECT_EQ(segments("out.svg", "highlight"), 0);
  EXPECT_NE(output.find("a.csv     11"), std::string::npos) << output;
}

TEST_F(Draw, TwoTriangulationsWithTheirDifference) {
  const std::string output = run("draw p.txt a.csv b.csv -o out.svg");
  EXPECT_EQ(segments("out.svg", "edges"), 11);
  EXPECT_EQ(segments("out.svg", "underlay"), 11);
  EXPECT_EQ(segments("out.svg", "highlight"), 1);
  EXPECT_NE(output.find("only in the first (orange)          1   3.605551"), std::string::npos) << output;
  run("draw p.txt a.csv a.csv -o same.svg");
  EXPECT_EQ(segments("same.svg", "highlight"), 0);
}

TEST_F(Draw, DuplicatesKeepTheNumbersOfTheFile) {
  write("q.txt", "0 0\n0 0\n4 0\n4 4\n0 4\n");
  write("t.csv", "0,2,3\n0,3,4\n");
  run("draw q.txt t.csv -o out.svg");
  EXPECT_EQ(segments("out.svg", "edges"), 5);
}

TEST_F(Draw, MistakesLeaveNoPicture) {
  write("bad.csv", "0,1,4\n");
  expect_mistake("draw p.txt bad.csv -o out.svg", "bad.csv: not a triangulation of these points");
  expect_mistake("draw p.txt a.csv bad.csv -o out.svg", "bad.csv: not a triangulation of these points");
  expect_mistake("draw p.txt a.csv", "--output is required");
  expect_mistake("draw p.txt missing.csv -o out.svg", "missing.csv");
  expect_mistake("draw p.txt a.csv -o out.png",
                 "out.png: a picture is written as SVG; give it a name that ends in .svg");
  EXPECT_FALSE(exists("out.svg"));
}

TEST_F(Draw, OverwritesNoInput) {
  for (const char* file : {"p.txt", "a.csv", "./b.csv"}) {
    const std::string before = read(file);
    expect_mistake("draw p.txt a.csv b.csv -o " + std::string(file), "would overwrite the input (");
    EXPECT_EQ(read(file), before);
  }
}

TEST_F(Draw, APictureOnStandardOutputComesAlone) {
  for (const char* output : {"-", "/dev/stdout"}) {
    const std::string picture = run("draw p.txt a.csv -o " + std::string(output));
    EXPECT_TRUE(picture.starts_with("<svg")) << picture;
    EXPECT_TRUE(picture.ends_with("</svg>\n")) << picture;
  }
}

}  // namespace
}  // namespace mwt
