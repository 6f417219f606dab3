#include "harness/io/points/point_file.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "geometry/testing/shapes.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

const std::vector<Point> kThreePoints{{1, 2}, {-0.5, 4e10}, {3, 0.25}};

std::vector<Point> read_as(const std::string& name, const std::string& content) {
  const TestFolder folder;
  return read_points(folder.file(name, content));
}

// The error without the folder's name: "points.txt:3: ...".
std::string error(const std::string& name, const std::string& content) {
  const TestFolder folder;
  const std::string path = folder.file(name, content);
  const std::string message = message_of<InputError>([&] { static_cast<void>(read_points(path)); });
  EXPECT_TRUE(message.starts_with(path)) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  return message.empty() ? "" : message.substr(path.size() - name.size());
}

TEST(PointFileText, ReadsAllSeparators) {
  EXPECT_EQ(read_as("p.txt", "1 2\n-0.5 4e10\n3 .25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.xy", "1\t2\n -0.5   4e10 \n+3 0.25"), kThreePoints);
  EXPECT_EQ(read_as("p.csv", "1,2\n-0.5,4e10\n3,0.25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.CSV", "1, 2\n-0.5 ,4E+10\n3 , 0.25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.txt", "1;2\n-0.5; 4e10\n3;0.25\n"), kThreePoints);
}

TEST(PointFileText, SkipsCommentsBlankLinesAndHeaders) {
  EXPECT_EQ(read_as("p.csv", "# made by hand\n\nx,y\n1,2\n\n-0.5,4e10 # far\n  # inside\n3,0.25\n\n"), kThreePoints);
  EXPECT_EQ(read_as("p.txt", "easting northing\n1 2\n-0.5 4e10\n3 0.25\n"), kThreePoints);
}

TEST(PointFileText, TakesForeignLineEndsAndByteOrderMarks) {
  EXPECT_EQ(read_as("p.csv", "\xEF\xBB\xBFx,y\r\n1,2\r\n-0.5,4e10\r\n3,0.25\r\n"), kThreePoints);
  EXPECT_EQ(read_as("p.csv",
                    "\xEF\xBB\xBF"
                    "1,2\r\n-0.5,4e10\r\n3,0.25"),
            kThreePoints);
}

TEST(PointFileText, LeavesOutIdColumns) {
  EXPECT_EQ(read_as("p.csv", "id,x,y\n7,1,2\n3,-0.5,4e10\n5,3,0.25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.csv", "\"Name\",\"Y\",\"X\"\nA,2,1\nB,4e10,-0.5\nC,0.25,3\n"), kThreePoints);
  EXPECT_EQ(read_as("p.txt", "0 1 2\n1 -0.5 4e10\n2 3 0.25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.txt", "1 1 2\n2 -0.5 4e10\n3 3 0.25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.csv", "index,easting,northing\n0,1,2\n1,-0.5,4e10\n2,3,0.25\n"), kThreePoints);
}

TEST(PointFileText, NamesThePlaceOfEveryMistake) {
  EXPECT_EQ(error("p.txt", "1 2\n3 four\n"), "p.txt:2: 'four' is not a number; write one such as 1.5 or 2e-3");
  EXPECT_EQ(error("p.txt", "1 two\n"), "p.txt:1: 'two' is not a number; write one such as 1.5 or 2e-3");
  EXPECT_EQ(error("p.csv", "x,y\n1,2\n\n# c\n3,nan\n"),
            "p.csv:5: 'nan' is not a finite double; leave the row out or scale the data down");
  EXPECT_EQ(error("p.csv", "-inf,2\n"),
            "p.csv:1: '-inf' is not a finite double; leave the row out or scale the data down");
  EXPECT_EQ(error("p.csv", "1,1e400\n"),
            "p.csv:1: '1e400' is not a finite double; leave the row out or scale the data down");
  EXPECT_EQ(error("p.csv", "1,2\n3,\n"), "p.csv:2: column 2 is empty; write a number");
  EXPECT_EQ(error("p.csv", "1,2\n3\n"), "p.csv:2: 1 column where the first row has 2; give every row the same columns");
  EXPECT_EQ(error("p.csv", "x,y\n1,2,3\n"),
            "p.csv:2: 3 columns where the header has 2; give every row the same columns");
  EXPECT_EQ(error("p.txt", "1\n2\n"),
            "p.txt:1: 1 column(s); write x y, or id x y, or a header that names the columns x and y");
  EXPECT_EQ(error("p.csv", "1,5;2,5\n"), "p.csv:1: both commas and semicolons; write x,y with decimal points");
  EXPECT_EQ(error("p.csv", "1 2,3\n"), "p.csv:1: '1 2' is not a number; write one such as 1.5 or 2e-3");
  EXPECT_EQ(error("p.txt", std::string("1 2\n3 \x01zero\n")),
            "p.txt:2: '?zero' is not a number; write one such as 1.5 or 2e-3");
}

TEST(PointFileText, ThreeColumnsThatDoNotCountAreAnError) {
  EXPECT_EQ(
      error("p.txt", "0 1 2\n2 3 4\n"),
      "p.txt:2: 3 columns, but the first does not count up (2 after 0), so it is no id; write x y, or a header that "
      "names x and y");
  EXPECT_EQ(error("p.txt", "0.5 1 2\n1.5 3 4\n"),
            "p.txt:1: 3 columns, but '0.5' is no integer id; write x y, or a header that names x and y");
}

TEST(PointFileText, TheFirstPointIsNeverTakenForAHeader) {
  const auto first_line = [](const std::string& row) { return error("p.csv", row + "\n1,2\n3,4\n4,1\n"); };
  for (const char* row :
       {"\xE2\x88\x92"
        "1,\xE2\x88\x92"
        "1",
        "NA,NA", "0.5f,1.5f", "59.3 deg,18 deg", "0x1p3,0x1p4", "0.1D+01,0.2D+01", "(0,0)", "-,-", ".,."}) {
    EXPECT_TRUE(first_line(row).starts_with("p.csv:1: '")) << row;
  }
  EXPECT_EQ(error("p.txt", ". .\n1 0\n0 1\n3 3\n"), "p.txt:1: '.' is not a number; write one such as 1.5 or 2e-3");
}

TEST(PointFileText, AHeaderThatNamesOneCoordinateOnlyIsAnError) {
  const std::string remedy = "; call both coordinates by their names";
  EXPECT_EQ(error("p.csv", "id,x\n1,10\n2,20\n3,5\n"), "p.csv:1: the header names x but not y" + remedy);
  EXPECT_EQ(error("p.csv", "x,z\n1,10\n2,20\n3,5\n"), "p.csv:1: the header names x but not y" + remedy);
  EXPECT_EQ(error("p.csv", "# c\nname,y\n1,10\n"), "p.csv:2: the header names y but not x" + remedy);
  EXPECT_EQ(error("p.csv", "id,x,z\n1,10,5\n2,20,5\n"), "p.csv:1: the header names x but not y" + remedy);
  EXPECT_EQ(error("p.csv", "x,x,y\n1,2,3\n"), "p.csv:1: two columns are called 'x'; keep one name");
  EXPECT_EQ(error("p.csv", "x1 [x],x2 [x],y\n1,2,3\n"),
            "p.csv:1: columns 'x1 [x]' and 'x2 [x]' could both be x; call the coordinates x and y");
  EXPECT_EQ(error("p.csv", "x.y,x\n1,2\n"), "p.csv:1: the header names x but not y" + remedy);
}

TEST(PointFileText, AHeaderThatNamesNeitherCoordinateMustLeaveNoDoubt) {
  const std::string remedy = "p.csv:1: the header does not name the columns of the coordinates; call them x and y";
  EXPECT_EQ(error("p.csv", "id,easting\n1,10\n2,20\n"), remedy);
  EXPECT_EQ(error("p.csv", "easting,northing,height\n1,10,5\n2,20,5\n"), remedy);
  EXPECT_EQ(error("p.csv", "easting,name,northing\n1,10,5\n2,20,5\n"), remedy);
}

TEST(PointFileText, ColumnsAreObeyedInAnyOrder) {
  const std::vector<Point> swapped{{2, 1}, {4e10, -0.5}, {0.25, 3}};
  EXPECT_EQ(read_as("p.csv", "\xEF\xBB\xBF\xEF\xBB\xBFy,x\n1,2\n-0.5,4e10\n3,0.25\n"), swapped);
  EXPECT_EQ(read_as("p.csv", "y [m],x [m]\n1,2\n-0.5,4e10\n3,0.25\n"), swapped);
  EXPECT_EQ(read_as("p.csv", ",POINT_Y,POINT_X\na,1,2\nb,-0.5,4e10\nc,3,0.25\n"), swapped);
  EXPECT_EQ(read_as("p.csv", "old x,x,y\n9,1,2\n9,-0.5,4e10\n9,3,0.25\n"), kThreePoints);
}

TEST(PointFileText, LinesWithTabsAreSplitAtTabs) {
  const std::string header = "site\tx\ty\n";
  EXPECT_EQ(read_as("p.txt", header + "Route 66\t1\t2\nQuarry\t-0.5\t4e10\n\t3\t0.25\n"), kThreePoints);
  EXPECT_EQ(error("p.txt", header + "Route 66\t\t3.5\nQuarry\t10\t2\nMill\t4\t9\n"),
            "p.txt:2: column 2 (x) is empty; write a number");
}

TEST(PointFileText, ReadsForeignEncodingsAndLineEnds) {
  EXPECT_EQ(read_as("p.txt", "1 2\r-0.5 4e10\r3 0.25\r"), kThreePoints);
  EXPECT_EQ(read_as("p.csv", "# old\rx,y\r1,2\r-0.5,4e10\r3,0.25"), kThreePoints);
  std::string wide = "\xFF\xFE";
  for (const char c : std::string("x;y\r\n1;2\r\n-0.5;4e10\r\n3;0.25\r\n")) (wide += c) += '\0';
  EXPECT_EQ(read_as("p.csv", wide), kThreePoints);
  EXPECT_EQ(read_as("p.csv", "sep=;\r\n\"x\";\"y\"\r\n\"1\";\"2\"\r\n-0.5;4e10\r\n3;0.25\r\n"), kThreePoints);
  EXPECT_EQ(error("p.txt", "\x1F\x8B\x08" + std::string(3, '\0')),
            "p.txt: begins like gzip, but is damaged or cut off");
}

TEST(PointFileText, OtherFormatsAreReadWhateverTheNameOfATextFile) {
  EXPECT_EQ(read_as("p.txt", R"({"points": [{"x": 1, "y": 2}, {"x": -0.5, "y": 4e10}, {"x": 3, "y": 0.25}]})"),
            kThreePoints);
  EXPECT_EQ(read_as("p.csv", "name: three\nnode_coord_section\n1 1 2\n2 -0.5 4e10\n3 3 0.25\n"), kThreePoints);
  EXPECT_EQ(read_as("p.txt", "cross_section x y\n1 1 2\n2 -0.5 4e10\n3 3 0.25\n"), kThreePoints);
}

TEST(PointFileText, AnIdBelowAllIntegersIsNoSuccessor) {
  EXPECT_EQ(
      error("p.txt", "5 0 0\n-9223372036854775808 1 1\n"),
      "p.txt:2: 3 columns, but the first does not count up (-9223372036854775808 after 5), so it is no id; write x "
      "y, or a header that names x and y");
}

TEST(PointFileText, FilesWithoutPoints) {
  const std::string message = "p.txt: no points in it; write one \"x y\" per line";
  EXPECT_EQ(error("p.txt", ""), message);
  EXPECT_EQ(error("p.txt", "# nothing\n\n"), message);
  EXPECT_EQ(error("p.txt", "x y\n"), message);
}

TEST(PointFile, UnusableFiles) {
  const TestFolder folder;
  const auto message = [](const std::string& path) {
    return message_of<InputError>([&] { static_cast<void>(read_points(path)); });
  };
  EXPECT_EQ(message(folder.path("none.txt")), folder.path("none.txt") + ": no such file; check the name");
  EXPECT_EQ(message(folder.path("")), folder.path("") + ": is a folder; name a file in it");
  const std::string unknown =
      "points.dat: unknown ending '.dat'; known: .txt .xy .csv .tsv .tsp .json .geojson .wkt .off .ply .node .npy, and "
      ".gz, "
      ".bz2, .xz, .zst behind them";
  EXPECT_EQ(message("points.dat"), unknown);
  EXPECT_EQ(message_of<InputError>([] { write_points("points.dat", kThreePoints); }), unknown);
  for (const char* name : {"p.npy", "p.txt.gz", "p.geojson", "p.ply"}) {
    EXPECT_EQ(message_of<InputError>([&] { write_points(name, kThreePoints); }),
              std::string(name) + ": points are written as .txt, .xy, .csv, .tsv, .tsp or .json");
  }
}

TEST(PointFileTsplib, ReadsTheCommonSpellings) {
  EXPECT_EQ(
      read_as("p.tsp",
              "NAME : three\nCOMMENT : a comment: with a colon\nTYPE : TSP\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EUC_2D\n"
              "NODE_COORD_SECTION\n1 1 2\n2 -0.5 4e10\n3 3 0.25\nEOF\n"),
      kThreePoints);
  EXPECT_EQ(read_as("p.tsp",
                    "NAME: three\r\nDIMENSION: 3\r\nEDGE_WEIGHT_TYPE: CEIL_2D\r\nNODE_COORD_SECTION\r\n"
                    "  1\t1.00000e+00 2.00000e+00\r\n  2 -5.0e-01 4.0e+10\r\n  3 3.0 .25\r\n"),
            kThreePoints);
  EXPECT_EQ(read_as("p.TSP", "Dimension 3\nnode_coord_section :\n10 1 2\n5 -0.5 4e10\n7 3 0.25\n-1\nEOF\n\n"),
            kThreePoints);
}

TEST(PointFileTsplib, TakesGeographicCoordinatesAsTheyStand) {
  EXPECT_EQ(
      read_as(
          "p.tsp",
          "EDGE_WEIGHT_TYPE : GEO\nNODE_COORD_SECTION\n1 1 2\n2 -0.5 4e10\n3 3 0.25\nDISPLAY_DATA_SECTION\n1 0 0\n"),
      kThreePoints);
}

TEST(PointFileTsplib, ReadsDisplayCoordinatesIfThereAreNoOthers) {
  const std::string head = "DIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_SECTION\n0 1 2\n";
  EXPECT_EQ(read_as("p.tsp", head + "DISPLAY_DATA_SECTION\n1 1 2\n2 -0.5 4e10\n3 3 0.25\nEOF\n"), kThreePoints);
  EXPECT_EQ(error("p.tsp", head + "DISPLAY_DATA_SECTION\n1 1 2\nEOF\n"),
            "p.tsp: DIMENSION is 3, but DISPLAY_DATA_SECTION has 1 points; correct one of them");
}

TEST(PointFileTsplib, NamesOfNodesDoNotEndTheSection) {
  EXPECT_EQ(read_as("p.tsp", "NODE_COORD_SECTION\n1 1 2\nB -0.5 4e10\n\"c\" 3 0.25\nDEMAND_SECTION\n1 0\n"),
            kThreePoints);
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\nA 0 0\nB 1 one\n"),
            "p.tsp:3: 'one' is not a number; write one such as 1.5 or 2e-3");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0 0\nNew York 1 1\n"),
            "p.tsp:3: 4 column(s); a node is a number, x and y (points in the plane only)");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0 0\nNOISE\n2 0 1\n"),
            "p.tsp:3: 1 column(s); a node is a number, x and y (points in the plane only)");
}

TEST(PointFileTsplib, NamesThePlaceOfEveryMistake) {
  EXPECT_EQ(
      error("p.tsp", "NAME : full\nEDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_SECTION\n0 1\nEOF\n"),
      "p.tsp: no NODE_COORD_SECTION (EDGE_WEIGHT_TYPE 'EXPLICIT'); only instances with coordinates in the plane can "
      "be read");
  EXPECT_EQ(error("p.tsp", ""),
            "p.tsp: no NODE_COORD_SECTION; only instances with coordinates in the plane can be read");
  EXPECT_EQ(error("p.tsp", "DIMENSION : 2\nNODE_COORD_SECTION\n1 0 0\nEOF\n"),
            "p.tsp: DIMENSION is 2, but NODE_COORD_SECTION has 1 points; correct one of them");
  EXPECT_EQ(error("p.tsp", "DIMENSION : many\nNODE_COORD_SECTION\n1 0 0\n"),
            "p.tsp:1: DIMENSION 'many' is not a number of points");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0 0\n2 0 x\n"),
            "p.tsp:3: 'x' is not a number; write one such as 1.5 or 2e-3");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0 1e999\n"),
            "p.tsp:2: '1e999' is not a finite double; scale the data down");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0 0 0\n"),
            "p.tsp:2: 4 column(s); a node is a number, x and y (points in the plane only)");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1.5 0 0\n"), "p.tsp:2: '1.5' is not a node's number");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0 0\nNODE_COORD_SECTION\n1 0 0\n"),
            "p.tsp:3: a second NODE_COORD_SECTION; keep one");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\nEOF\n"), "p.tsp: no points in NODE_COORD_SECTION");
  EXPECT_EQ(error("p.tsp", "DIMENSION : 2\nDIMENSION : 1\nNODE_COORD_SECTION\n1 0 0\n"),
            "p.tsp:2: a second DIMENSION; keep the right one");
  EXPECT_EQ(error("p.tsp", "NODE_COORD_SECTION\n1 0.1D+01 0\n"),
            "p.tsp:2: '0.1D+01' is not a number; write the exponent with e, as in 1e-3");
}

TEST(PointFileJson, ReadsPointsAndIgnoresTheRest) {
  EXPECT_EQ(read_as("p.json", R"({"points": [{"x": 1, "y": 2}, {"x": -0.5, "y": 40000000000}, {"x": 3, "y": 25e-2}]})"),
            kThreePoints);
  EXPECT_EQ(read_as("p.json",
                    R"({"name": "CG:SHOP", "meta": {"points": [1, 2], "x": 3, "list": [[{"x": 1}], null, true]},
                     "points": [{"i": 0, "y": 2, "x": 1, "extra": {"x": 9, "y": [8]}}, {"x": -0.5, "y": 4e10},
                                {"x": 3, "y": 0.25, "name": "c"}],
                     "edges": [{"x": 1}]})"),
            kThreePoints);
}

TEST(PointFileJson, NamesThePlaceOfEveryMistake) {
  const std::string remedy = "; a point is {\"x\": 1, \"y\": 2} or [1, 2]";
  EXPECT_EQ(error("p.json", R"({"points": [{"x": 1, "y": 2}, {"x": 1}]})"), "p.json: points[1] has no y" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [{"y": 1}]})"), "p.json: points[0] has no x" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [{"x": "1", "y": 2}]})"),
            "p.json: points[0] has '1' for a coordinate" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [{"x": null, "y": 2}]})"),
            "p.json: points[0] has null for a coordinate" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [{"x": [1], "y": 2}]})"),
            "p.json: points[0] has an array for a coordinate" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [{"x": {"x": 1}, "y": 2}]})"),
            "p.json: points[0] has an object for a coordinate" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [[1, 2], [1]]})"), "p.json: points[1] has 1 coordinates" + remedy);
  EXPECT_EQ(error("p.json", R"([[1, 2, 3]])"), "p.json: points[0] has 3 coordinates" + remedy);
  EXPECT_EQ(error("p.json", R"([[1, [2]]])"), "p.json: points[0] has an array for a coordinate" + remedy);
  EXPECT_EQ(error("p.json", R"([[1, "2"]])"), "p.json: points[0] has '2' for a coordinate" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [1, 2]})"), "p.json: points[0] is a number" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": []})"), "p.json: the list of points is empty");
  EXPECT_EQ(error("p.json", R"({"points": [{"x": 1, "y": 2, "x": 3}]})"), "p.json: points[0] has x twice" + remedy);
  EXPECT_EQ(error("p.json", R"({"points": [{"x": 1, "y": 2}], "points": []})"),
            "p.json: a second list \"points\"; keep one");
  const std::string expected =
      "; expected {\"points\": [{\"x\": 1, \"y\": 2}, ...]}, {\"points\": [[1, 2], ...]}, [[1, 2], ...], "
      "{\"points_x\": [1, ...], "
      "\"points_y\": [2, ...]} or GeoJSON points";
  EXPECT_EQ(error("p.json", R"({"nodes": []})"), "p.json: no list of points" + expected);
  EXPECT_EQ(error("p.json", R"({"points": 5})"), "p.json: no list of points" + expected);
  EXPECT_EQ(error("p.json", R"({"x": [1, 2]})"), "p.json: a list of x coordinates, but none of y");
  EXPECT_EQ(error("p.json", R"({"x": [1, 2], "y": [1]})"), "p.json: 2 x coordinates, but 1 y coordinates");
  EXPECT_EQ(error("p.json", R"({"points_x": [1, null], "points_y": [1]})"),
            "p.json: points_x[1] is null; a coordinate is a number");
  EXPECT_EQ(error("p.json", "{\n\"points\": [\n{\"x\": NaN, \"y\": 2}]}"),
            "p.json:3: no valid JSON at '\"x\": N'" + expected);
  EXPECT_EQ(error("p.json", "{\"points\": [\n{\"x\": 1e999, \"y\": 2}]}"),
            "p.json:2: '1e999' is not a finite double; scale the data down");
  EXPECT_TRUE(error("p.json", "").starts_with("p.json:1: no valid JSON at")) << error("p.json", "");
  EXPECT_TRUE(error("p.json", "{\"points\": [{\"x\": 1").starts_with("p.json:1: no valid JSON at"));
}

TEST(PointFileJson, DeepNestingIsNoDanger) {
  constexpr int kDepth = 1000000;
  const std::string nested = std::string(kDepth, '[') + std::string(kDepth, ']');
  EXPECT_EQ(read_as("p.json", "{\"more\": " + nested + ", \"points\": [{\"x\": 1, \"y\": 2}]}").size(), 1U);
  EXPECT_TRUE(error("p.json", std::string(kDepth, '[')).starts_with("p.json: points[0] has an array for a coordinate"));
  EXPECT_TRUE(error("p.json", "{\"a\": " + std::string(kDepth, '[')).starts_with("p.json:1: no valid JSON at"));
}

TEST(PointFile, EveryFormatGivesBackTheSameDoubles) {
  std::mt19937_64 random(3);
  std::vector<Point> points{{0, -0.0}, {5e-324, 1.7976931348623157e308}, {0.1, 1.0 / 3}};
  while (points.size() < 2000) {
    const Point p{std::bit_cast<double>(random()), std::bit_cast<double>(random())};
    if (std::isfinite(p.x) && std::isfinite(p.y)) points.push_back(p);
  }
  const TestFolder folder;
  for (const char* name : {"p.txt", "p.xy", "p.csv", "p.tsp", "p.json", "p"}) {
    write_points(folder.path(name), points);
    const std::vector<Point> back = read_points(folder.path(name));
    ASSERT_EQ(back.size(), points.size()) << name;
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(back[i], points[i]) << name << ' ' << i;
    }
  }
}

TEST(PointFile, WritesWhatPeopleExpect) {
  const TestFolder folder;
  const auto written = [&](const std::string& name) {
    write_points(folder.path(name), kThreePoints);
    return TestFolder::content(folder.path(name));
  };
  EXPECT_EQ(written("p.txt"), "1 2\n-0.5 4e+10\n3 0.25\n");
  EXPECT_EQ(written("p.csv"), "x,y\n1,2\n-0.5,4e+10\n3,0.25\n");
  EXPECT_EQ(
      written("p.tsp"),
      "NAME : p\nTYPE : TSP\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n1 1 2\n2 -0.5 4e+10\n3 3 "
      "0.25\nEOF\n");
  EXPECT_EQ(written("p.json"),
            "{\"points\": [\n{\"x\": 1, \"y\": 2},\n{\"x\": -0.5, \"y\": 4e+10},\n{\"x\": 3, \"y\": 0.25}\n]}\n");
}

TEST(PointFile, AWriteThatFailsLeavesTheOldFile) {
  const TestFolder folder;
  EXPECT_EQ(message_of<InputError>([&] { write_points(folder.path("no/p.csv"), kThreePoints); }),
            folder.path("no/p.csv") + ": cannot be written: its folder does not exist; create that first");
  EXPECT_THROW(write_points("/dev/full", kThreePoints), InputError);
}

TEST(PointFile, StandardStreamsAreRecognisedByContent) {
  const TestFolder folder;
  EXPECT_EQ(read_points(folder.file("text", "1 2\n-0.5 4e10\n3 0.25\n")), kThreePoints);
  EXPECT_EQ(read_points(folder.file("json", " {\"points\": [{\"x\": 1, \"y\": 2}]}")).size(), 1U);
  EXPECT_EQ(read_points(folder.file("tsplib", "NAME: a\nNODE_COORD_SECTION\n1 1 2\n")).size(), 1U);
  EXPECT_EQ(read_points(folder.file("lower", "name: a\nnode_coord_section\n1 1 2\n")).size(), 1U);
  testing::internal::CaptureStdout();
  write_points("-", kThreePoints);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "1 2\n-0.5 4e+10\n3 0.25\n");
}

TEST(PointFile, DashIsStandardInput) {
  const TestFolder folder;
  const std::string path = folder.file("p.txt", "1 2\n3 four\n");
  FILE* const input = std::freopen(path.c_str(), "r", stdin);
  ASSERT_NE(input, nullptr);
  EXPECT_EQ(message_of<InputError>([] { static_cast<void>(read_points("-")); }),
            "standard input:2: 'four' is not a number; write one such as 1.5 or 2e-3");
}

}  // namespace
}  // namespace mwt
