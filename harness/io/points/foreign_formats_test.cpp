// One example of each format of other programs, and what damage does to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <random>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "harness/io/points/point_file.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

const std::vector<Point> kFourPoints{{1, 2}, {-0.5, 4.25}, {3, 0.25}, {7, 8}};

template <class Number>
std::string bytes_of(Number value, bool is_big_endian = false) {
  std::string bytes(sizeof(Number), '\0');
  std::memcpy(bytes.data(), &value, sizeof(Number));
  if (is_big_endian) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

std::string npy(const std::string& descr, const std::string& shape, const std::string& data, bool by_column = false) {
  std::string header =
      "{'descr': '" + descr + "', 'fortran_order': " + (by_column ? "True" : "False") + ", 'shape': " + shape + ", }";
  header.resize(117, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + bytes_of(static_cast<std::uint16_t>(header.size())) + header + data;
}

std::string npy_of_doubles(bool by_column = false, bool is_big_endian = false) {
  std::string data;
  if (by_column) {
    for (const Point& p : kFourPoints) data += bytes_of(p.x, is_big_endian);
    for (const Point& p : kFourPoints) data += bytes_of(p.y, is_big_endian);
  } else {
    for (const Point& p : kFourPoints) data += bytes_of(p.x, is_big_endian) + bytes_of(p.y, is_big_endian);
  }
  return npy(is_big_endian ? ">f8" : "<f8", "(4, 2)", data, by_column);
}

std::string binary_ply() {
  std::string content =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty uchar red\nproperty double "
      "y\nproperty "
      "float z\nend_header\n";
  for (const Point& p : kFourPoints)
    content += bytes_of(static_cast<float>(p.x)) + "r" + bytes_of(p.y) + bytes_of(1.5F);
  return content;
}

struct Example {
  std::string name;
  std::string content;
};

std::vector<Example> examples() {
  return {
      {"pairs.json", "[[1, 2], [-0.5, 4.25], [3, 0.25], [7, 8]]"},
      {"list.json", R"({"name": "a", "points": [[1, 2], [-0.5, 4.25], [3, 25e-2], [7, 8]], "edges": [[0, 1]]})"},
      {"objects.json",
       R"([{"x": 1, "y": 2}, {"y": 4.25, "x": -0.5}, {"x": 3, "y": 0.25, "z": [1]}, {"x": 7, "y": 8}])"},
      {"cgshop2020.json",
       R"({"type": "Instance", "name": "a", "points": [{"i": 0, "x": 1.0, "y": 2.0}, {"i": 1, "x": -0.5, "y": 4.25},
          {"i": 2, "x": 3.0, "y": 0.25}, {"i": 3, "x": 7.0, "y": 8.0}]})"},
      {"cgshop2022.json",
       R"({"type": "Instance_CGSHOP2022", "n": 4, "m": 1, "x": [1, -0.5, 3, 7], "y": [2, 4.25, 0.25, 8], "edge_i": [0], "edge_j": [1]})"},
      {"cgshop2025.json",
       R"({"content_type": "CG_SHOP_2025_Instance", "num_points": 4, "points_x": [1, -0.5, 3, 7], "points_y": [2, 4.25, 0.25, 8],
          "region_boundary": [0, 1, 2], "num_constraints": 0, "additional_constraints": []})"},
      {"features.geojson",
       R"({"type": "FeatureCollection", "features": [
          {"type": "Feature", "properties": {"coordinates": 3}, "geometry": {"type": "Point", "coordinates": [1, 2]}},
          {"type": "Feature", "geometry": {"type": "MultiPoint", "coordinates": [[-0.5, 4.25], [3, 0.25]]}},
          {"type": "Feature", "geometry": {"type": "GeometryCollection", "geometries": [{"coordinates": [7, 8], "type": "Point"}]}}]})"},
      {"multi.wkt", "SRID=4326;MULTIPOINT ((1 2), (-0.5 4.25), (3 0.25), (7 8))\n"},
      {"plain.wkt", "multipoint(1 2,-0.5 4.25,3 .25)\nPOINT EMPTY\nPOINT (7 8)\n"},
      {"mesh.off", "OFF\n# made by hand\n4 1 0\n1 2 0\n-0.5 4.25 0\n3 0.25 0\n7 8 0\n3 0 1 2\n"},
      {"counts.off", "OFF 4 0 0\n1 2 9\n-0.5 4.25 9\n3 0.25 9\n7 8 9\n"},
      {"mesh.ply",
       "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float y\nproperty float x\nelement face "
       "1\nproperty list uchar int "
       "vertex_indices\nend_header\n2 1\n4.25 -0.5\n0.25 3\n8 7\n3 0 1 2\n"},
      {"binary.ply", binary_ply()},
      {"mesh.node", "# Triangle\n4 2 1 1\n1 1 2 0.5 1\n2 -0.5 4.25 0.5 1\n3 3 0.25 0.5 0\n4 7 8 0.5 1\n"},
      {"doubles.npy", npy_of_doubles()},
      {"columns.npy", npy_of_doubles(true)},
      {"big_endian.npy", npy_of_doubles(false, true)},
      {"tabs.tsv", "x\ty\n1\t2\n-0.5\t4.25\n3\t0.25\n7\t8\n"},
      {"quoted.csv", "\"name\",\"x\",\"y\"\n\"a, b\",1,2\n\"c\",-0.5,4.25\nd,3,0.25\n\"\",\"7\",\"8\"\n"},
      {"pipes.csv", "sep=|\n1|2\n-0.5|4.25\n3|0.25\n7|8\n"},
      {"published.tsp",
       "name: a\ntype: TSP\nedge_weight_type: EXPLICIT\ndisplay_data_type: TWOD_DISPLAY\ndisplay_data_section\n1 1 "
       "2\n2 -0.5 "
       "4.25\n3 3 0.25\n4 7 8"},
  };
}

std::vector<Point> read(const std::string& name, const std::string& content,
                        const std::optional<ColumnNames>& columns = {}) {
  const TestFolder folder;
  return read_points(folder.file(name, content), columns);
}

std::string refusal(const std::string& name, const std::string& content) {
  const TestFolder folder;
  const std::string path = folder.file(name, content);
  const std::string message = message_of<InputError>([&] { static_cast<void>(read_points(path)); });
  return message.starts_with(path) ? message.substr(path.size() - name.size()) : "not about the file: " + message;
}

TEST(ForeignFormats, GiveTheSamePoints) {
  for (const Example& example : examples()) EXPECT_EQ(read(example.name, example.content), kFourPoints) << example.name;
}

TEST(ForeignFormats, AreRecognisedWithoutAnEnding) {
  for (const Example& example : examples()) {
    const std::string ending = example.name.substr(example.name.find('.'));
    if (ending == ".node") continue;  // like a table with another first row
    EXPECT_EQ(read("points", example.content), kFourPoints) << example.name;
  }
}

TEST(ForeignFormats, IntegersAreExact) {
  std::string data;
  for (const int value : {1, -2, 3, 127}) data += bytes_of(static_cast<std::int16_t>(value));
  EXPECT_EQ(read("p.npy", npy("<i2", "(2, 2)", data)), (std::vector<Point>{{1, -2}, {3, 127}}));
  EXPECT_EQ(read("p.npy", npy("|i1", "(1, 2)", "\x80\x7f")), (std::vector<Point>{{-128, 127}}));
  EXPECT_EQ(read("p.npy", npy("|u1", "(1, 2)", "\x80\x7f")), (std::vector<Point>{{128, 127}}));
  EXPECT_EQ(refusal("p.npy", npy("<i8", "(1, 2)", bytes_of(std::int64_t{1}) + bytes_of((std::int64_t{1} << 53) + 1))),
            "p.npy: row 0 has an integer beyond 2^53, which no double has exactly");
}

TEST(ForeignFormats, ColumnsCanBeChosen) {
  const std::string table = "id;lon;lat;height\n9;1;2;0\n8;-0.5;4.25;0\n7;3;0.25;0\n6;7;8;0\n";
  EXPECT_EQ(read("p.csv", table, ColumnNames{"Lon", "lat"}), kFourPoints);
  EXPECT_EQ(read("p.csv", table, ColumnNames{"2", "3"}), kFourPoints);
  EXPECT_EQ(read("p.txt", "5 1 2 a\n5 -0.5 4.25 b\n5 3 0.25 c\n5 7 8 d\n", ColumnNames{"2", "3"}), kFourPoints);
  const auto mistake = [&](const ColumnNames& columns) {
    return message_of<InputError>([&] { static_cast<void>(read("p.csv", table, columns)); });
  };
  EXPECT_NE(mistake({"east", "lat"}).find("no column is called 'east'; there are id, lon, lat, height"),
            std::string::npos);
  EXPECT_NE(mistake({"2", "5"}).find("no column 5; there are 4"), std::string::npos);
  EXPECT_NE(mistake({"lon", "2"}).find("the same column"), std::string::npos);
  for (const char* text : {"", "x", "x,", "x,y,z"})
    EXPECT_THROW(static_cast<void>(parse_column_names(text)), InputError);
}

TEST(ForeignFormats, RefusalsNameWhatWasFound) {
  EXPECT_EQ(refusal("p.geojson", R"({"type": "LineString", "coordinates": [[1, 2], [3, 4]]})"),
            "p.geojson: GeoJSON of type 'LineString' is no point; give Point and MultiPoint only");
  EXPECT_EQ(refusal("p.geojson", R"({"type": "MultiPoint", "coordinates": [[1, 2], [3]]})"),
            "p.geojson: point 1 of this GeoJSON is not two numbers: '[3]'");
  EXPECT_EQ(refusal("p.geojson", R"({"type": "Point", "coordinates": [1, 2, 3]})"),
            "p.geojson: point 0 of this GeoJSON is not two numbers: '[1,2,3]'");
  EXPECT_EQ(refusal("p.wkt", "POLYGON ((1 2, 3 4, 5 6, 1 2))"),
            "p.wkt:1: 'POLYGON' where there should be POINT or MULTIPOINT; other geometries are no points");
  EXPECT_EQ(refusal("p.wkt", "POINT Z (1 2 3)"),
            "p.wkt:1: 'Z': points of more than two coordinates; leave out z and m");
  EXPECT_EQ(refusal("p.wkt", "POINT (1 2)\nPOINT (1 2 3)"),
            "p.wkt:2: a point of more than two coordinates; leave out z and m");
  EXPECT_EQ(refusal("p.wkt", "MULTIPOINT (1 2, 3 4"), "p.wkt:1: 'end of file' where there should be ')'");
  EXPECT_EQ(refusal("p.off", "OFF\n2 0 0\n0 0 0\n1 1 3\n"),
            "p.off: vertex 1 has z = 3, others 0: no points of one plane; project them first");
  EXPECT_EQ(refusal("p.off", "OFF\n3 0 0\n0 0 0\n1 1 0\n"), "p.off: ends before vertex 2 of 3");
  EXPECT_EQ(refusal("p.off", "OFF\n1 0 0\n0 0 0\n1 1 0\n"),
            "p.off: 1 line after the vertices, where its header states 0");
  EXPECT_EQ(refusal("p.node", "2 3 0 0\n1 0 0 0\n"),
            "p.node:1: its dimension is not 2; a .node file begins with 'POINTS 2 ATTRIBUTES MARKERS'");
  EXPECT_EQ(refusal("p.node", "1 2 0 0\n1 0 0\n2 1 1\n"), "p.node:3: more than the 1 vertices of the first line");
  EXPECT_EQ(refusal("p.npy", npy("<f8", "(2, 3)", std::string(48, '\0'))),
            "p.npy: this NumPy file its shape is '(2, 3)'; save an array of shape (n, 2)");
  EXPECT_EQ(refusal("p.npy", npy("<c16", "(1, 2)", std::string(32, '\0'))),
            "p.npy: this NumPy file holds numbers of the type '<c16'; save float64, float32 or integers");
  EXPECT_EQ(refusal("p.npy", npy("<f8", "(3, 2)", std::string(40, '\0'))), "p.npy: this NumPy file is cut off");
  EXPECT_EQ(refusal("p.npy", npy("<f8", "(99999999999999999999, 2)", "")),
            "p.npy: this NumPy file its shape is '(99999999999999999999, 2)'; save an array of shape (n, 2)");
  EXPECT_EQ(refusal("p.npy", "1 2\n"), "p.npy: is no NumPy file");
  EXPECT_EQ(refusal("p.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n1\n"),
            "p.ply: its vertices have no x and y");
  EXPECT_EQ(refusal("p.ply", binary_ply().substr(0, 200)), "p.ply: a PLY file that ends before its last vertex");
  EXPECT_EQ(refusal("p.ply", binary_ply() + "x"), "p.ply: a PLY file with more data than its header states");
}

// Points of `read` that kFourPoints lacks, and the other way round.
std::size_t lost_points(const std::vector<Point>& read) {
  return static_cast<std::size_t>(std::count_if(kFourPoints.begin(), kFourPoints.end(), [&](const Point& p) {
    return std::ranges::find(read, p) == read.end();
  }));
}

// A change of one byte is refused, or changes one point at most.
void damage(int trials, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const std::vector<Example> all = examples();
  std::size_t refused = 0, accepted = 0;
  const TestFolder folder;
  for (int trial = 0; trial < trials; ++trial) {
    const Example& example = all[random() % all.size()];
    std::string content = example.content;
    const std::size_t place = random() % content.size();
    static constexpr std::string_view kLikely = "0123456789.,;:-+eE \t\n()[]{}\"'#xyz";
    const bool is_binary = example.name.ends_with(".npy") || example.name == "binary.ply";
    switch (is_binary ? 0 : random() % 3) {
      case 0:
        content[place] = random() % 4 == 0 ? static_cast<char>(random()) : kLikely[random() % kLikely.size()];
        break;
      case 1: content.erase(place, 1); break;
      default: content.insert(place, 1, kLikely[random() % kLikely.size()]);
    }
    const std::string path = folder.file(example.name, content);
    try {
      const std::vector<Point> points = read_points(path);
      ++accepted;
      // The order of columns, and the layout of binary data, are stated in one byte.
      std::vector<Point> turned = points;
      for (Point& p : turned) std::swap(p.x, p.y);
      const bool may_change_all = is_binary && place < example.content.size() - 4 * 17;
      if (!may_change_all) {
        EXPECT_LE(std::min(lost_points(points), lost_points(turned)), 1U) << example.name << '\n' << content;
      }
    } catch (const InputError& refusal) {
      ++refused;
      const std::string message = refusal.what();
      EXPECT_TRUE(message.starts_with(path)) << message;
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    }
  }
  EXPECT_GT(refused, static_cast<std::size_t>(trials) / 10);
  EXPECT_GT(accepted, static_cast<std::size_t>(trials) / 10);
}

TEST(ForeignFormats, DamageIsRefusedOrStaysWhereItIs) { damage(1'000, 7); }
TEST(ForeignFormatsSlow, DamageIsRefusedOrStaysWhereItIs) { damage(20'000, 8); }

}  // namespace
}  // namespace mwt
