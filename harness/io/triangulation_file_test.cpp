#include "harness/io/triangulation_file.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/testing/test_folder.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

const std::vector<Triangle> kTriangles{{9, 2, 4}, {5, 0, 7}};
const std::vector<Edge> kEdges{{0, 8}, {2, 5}};

std::vector<Triangle> triangles(const std::string& content) {
  const TestFolder folder;
  return read_triangles(folder.file("t.csv", content));
}

std::vector<Edge> edges(const std::string& content) {
  const TestFolder folder;
  return read_edges(folder.file("e.csv", content));
}

std::string error(const std::string& content) {
  const TestFolder folder;
  const std::string path = folder.file("t.csv", content);
  const std::string message = message_of<InputError>([&] { static_cast<void>(read_triangles(path)); });
  return message.empty() ? "" : message.substr(path.size());
}

TEST(TriangulationFile, ReadsTriangles) {
  EXPECT_EQ(triangles("a,b,c\n9,2,4\n5,0,7\n"), kTriangles);
  EXPECT_EQ(triangles("9 2 4\n5 0 7"), kTriangles);
  EXPECT_EQ(triangles("# ours\r\n\r\n9;2;4\r\n5; 0; 7 # last\r\n"), kTriangles);
}

TEST(TriangulationFile, IgnoresColumnsThatTheHeaderNames) {
  EXPECT_EQ(triangles("a,b,c,perimeter\n9,2,4,1.1308\n5,0,7,1.2523\n"), kTriangles);
  EXPECT_EQ(triangles("id,a,b,c\n0,9,2,4\n1,5,0,7\n"), kTriangles);
  EXPECT_EQ(triangles("i j k quality\n9 2 4 good\n5 0 7 bad\n"), kTriangles);
}

TEST(TriangulationFile, AHeaderThatLeavesDoubtAboutTheCornersIsAnError) {
  const std::string message = ":1: the header does not name the columns of the corners; call them a, b and c";
  EXPECT_EQ(error("id,i,j,k\n1,9,2,4\n"), message);
  EXPECT_EQ(error("a,b,d\n9,2,4\n"), message);
  EXPECT_EQ(error("id,a,b,quality\n1,9,2,4\n"), message);
  EXPECT_EQ(error("a,b,c,a\n9,2,4,1\n"), ":1: two columns are called 'a'; keep one name");
  EXPECT_EQ(triangles("c,a,b\n4,9,2\n7,5,0\n"), kTriangles);
}

TEST(TriangulationFile, ReadsEdgesSmallerEndFirst) {
  EXPECT_EQ(edges("a,b\n0,8\n5,2\n"), kEdges);
  EXPECT_EQ(edges("8 0\n2 5\n"), kEdges);
  EXPECT_EQ(edges("a,b,length\n0,8,1.5\n5,2,2.5\n"), kEdges);
}

TEST(TriangulationFile, NamesThePlaceOfEveryMistake) {
  const std::string remedy = " is not the index of a point; points are numbered 0, 1, 2, ...";
  EXPECT_EQ(error("0,1,2\n3,x,5\n"), ":2: 'x'" + remedy);
  EXPECT_EQ(error("0,1,-2\n"), ":1: '-2'" + remedy);
  EXPECT_EQ(error("0,1,2.0\n"), ":1: '2.0'" + remedy);
  EXPECT_EQ(error("0,1,\n"), ":1: ''" + remedy);
  EXPECT_EQ(error("0,1,99999999999\n"), ":1: '99999999999'" + remedy);
  EXPECT_EQ(error("0,1,4294967295\n"), ":1: '4294967295'" + remedy);
  EXPECT_EQ(error("0,1,2,3\n"),
            ":1: 4 column(s) where there should be 3; name further columns in a header such as a,b,c,perimeter");
  EXPECT_EQ(error("a,b\n0,1\n"),
            ":2: 2 column(s) where there should be 3; name further columns in a header such as a,b,c,perimeter");
  EXPECT_EQ(error("0,1,2\n3,4\n"), ":2: 2 columns where the first row has 3; give every row the same columns");
  EXPECT_EQ(error(""), ": no triangles in it; write one per line, corners by index from 0");
  EXPECT_EQ(error("a,b,c\n"), ": no triangles in it; write one per line, corners by index from 0");
  EXPECT_THROW(static_cast<void>(read_triangles("/no/such/file.csv")), InputError);
  EXPECT_THROW(static_cast<void>(edges("# none\n")), InputError);
}

TEST(TriangulationFile, WritesWhatItReads) {
  const TestFolder folder;
  write_triangles(folder.path("t.csv"), kTriangles);
  write_edges(folder.path("e.csv"), kEdges);
  EXPECT_EQ(TestFolder::content(folder.path("t.csv")), "a,b,c\n9,2,4\n5,0,7\n");
  EXPECT_EQ(TestFolder::content(folder.path("e.csv")), "a,b\n0,8\n2,5\n");
  EXPECT_EQ(read_triangles(folder.path("t.csv")), kTriangles);
  EXPECT_EQ(read_edges(folder.path("e.csv")), kEdges);
  EXPECT_THROW(write_triangles("/dev/full", kTriangles), InputError);
}

}  // namespace
}  // namespace mwt
