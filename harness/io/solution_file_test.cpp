#include "harness/io/solution_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "harness/io/given_triangulation.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

const std::vector<Triangle> kTwoTriangles{{0, 1, 2}, {0, 2, 3}};
const std::vector<Edge> kFiveEdges{{0, 1}, {1, 2}, {2, 3}, {0, 3}, {0, 2}};

GivenSolution read(const std::string& name, const std::string& content) {
  const TestFolder folder;
  return read_solution(folder.file(name, content), 4);
}

TEST(SolutionFile, ReadsTriangles) {
  for (const auto& [name, content] : {std::pair("t.csv", "a,b,c\n0,1,2\n0,2,3\n"),
                                      {"t.txt", "0 1 2\n0 2 3\n"},
                                      {"t.json", "[[0, 1, 2], [0, 2, 3]]"},
                                      {"t.json", "{\"name\": 3, \"triangles\": [[0, 1, 2], [0, 2, 3]]}"},
                                      {"t.ele", "# Triangle\n2 3 0\n1 0 1 2\n2 0 2 3\n"}}) {
    const GivenSolution solution = read(name, content);
    EXPECT_EQ(solution.triangles, kTwoTriangles) << content;
    EXPECT_FALSE(solution.counts_from_one);
  }
}

TEST(SolutionFile, ReadsEdges) {
  for (const auto& [name, content] : {std::pair("e.csv", "a,b\n0,1\n1,2\n3,2\n0,3\n0,2\n"),
                                      {"e.csv", "a,b,length\n0,1,1\n1,2,1\n3,2,1\n0,3,1\n0,2,1\n"},
                                      {"e.txt", "0 1\n1 2\n3 2\n0 3\n0 2\n"},
                                      {"e.json", "{\"edges\": [[0, 1], [1, 2], [3, 2], [0, 3], [0, 2]]}"},
                                      {"e.json",
                                       "{\"edges\": [{\"i\": 0, \"j\": 1}, {\"i\": 1, \"j\": 2}, {\"i\": 3, \"j\": 2}, "
                                       "{\"j\": 3, \"i\": 0}, {\"i\": 0, \"j\": "
                                       "2}]}"}})
    EXPECT_EQ(read(name, content).edges, kFiveEdges) << content;
}

TEST(SolutionFile, MayCountFromOne) {
  const GivenSolution triangles = read("t.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n");
  EXPECT_TRUE(triangles.counts_from_one);
  EXPECT_EQ(triangles.triangles, kTwoTriangles);
  EXPECT_EQ(read("e.txt", "1 2\n2 3\n3 4\n4 1\n3 1\n").edges, kFiveEdges);
  EXPECT_FALSE(read("t.txt", "1 2 3\n").counts_from_one) << "point 4 is no corner";
}

TEST(SolutionFile, RefusalsNameThePlace) {
  const auto error = [](const std::string& name, const std::string& content) {
    const TestFolder folder;
    const std::string path = folder.file(name, content);
    const std::string message = message_of<InputError>([&] { static_cast<void>(read_solution(path, 4)); });
    return message.substr(path.size() - name.size());
  };
  EXPECT_EQ(error("t.json", "{"), "t.json: no valid JSON");
  EXPECT_EQ(error("t.json", "{\"a\": []}"), "t.json: neither a list nor an object with \"triangles\" or \"edges\"");
  EXPECT_EQ(error("t.json", "[[0, 1, 2], [0]]"),
            "t.json: entry 1 is neither [a, b, c] nor [a, b] nor {\"i\": a, \"j\": b}");
  EXPECT_EQ(error("t.json", "[[0, 1, -2]]"), "t.json: entry 0 has '-2', which is not the index of a point");
  EXPECT_EQ(error("t.json", "[[0, 1, 2], [0, 1]]"), "t.json: has triangles and edges; give one kind");
  EXPECT_EQ(error("t.ele", "2 3 0\n1 0 1 2\n"), "t.ele: 1 triangle where its first line states 2");
  EXPECT_EQ(error("t.ele", "2 6 0\n"), "t.ele:1: does not begin with 'TRIANGLES 3 ATTRIBUTES'");
  EXPECT_EQ(error("t.txt", "0\n"),
            "t.txt:1: 1 column(s) where there should be 3; name further columns in a header such as a,b,c,perimeter");
}

TEST(SolutionFile, OfEdgesIsCheckedByTheTrianglesThatTheyBound) {
  const std::vector<Point> points{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {1, 0}};  // the last repeats the second
  const PointSet set = make_point_set(points, "square");
  const auto rule = [&](const std::vector<Edge>& edges) {
    return broken_rule(set, points, GivenSolution{{}, edges, false}).value_or("");
  };
  EXPECT_EQ(rule(kFiveEdges), "");
  EXPECT_EQ(rule({{0, 4}, {2, 4}, {2, 3}, {0, 3}, {0, 2}}), "");
  EXPECT_TRUE(rule({{0, 1}, {1, 2}, {2, 3}, {0, 3}}).starts_with("the triangles that the edges bound: "));
  EXPECT_EQ(rule({{1, 4}}), "edge 0 ends where it begins, at point 1");
  EXPECT_EQ(rule({{0, 9}}), "indices_in_range: edge 0 has corner 9, but points go from 0 to 4");
}

}  // namespace
}  // namespace mwt
