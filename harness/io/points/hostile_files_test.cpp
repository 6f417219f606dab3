// Files made to exhaust the stack, the memory or the patience of a reader: one clear line each.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <zstd.h>

#include <thread>

#include "base/error.h"
#include "base/testing/test_folder.h"
#include "harness/io/compression.h"
#include "harness/io/points/point_file.h"
#include "harness/io/solution_file.h"

namespace mwt {
namespace {

using test::message_of;
using test::TestFolder;

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  text.reserve(piece.size() * count);
  for (std::size_t i = 0; i < count; ++i) text += piece;
  return text;
}

class HostileFiles : public ::testing::Test {
 protected:
  // What reading the points says, the folder left out.
  [[nodiscard]] std::string points_error(const std::string& name, const std::string& content) const {
    return without_folder(message_of<InputError>([&] { static_cast<void>(read_points(folder_.file(name, content))); }));
  }
  [[nodiscard]] std::string solution_error(const std::string& name, const std::string& content) const {
    return without_folder(
        message_of<InputError>([&] { static_cast<void>(read_solution(folder_.file(name, content), 3)); }));
  }
  [[nodiscard]] std::string path_error(const std::string& path) const {
    return without_folder(message_of<InputError>([&] { static_cast<void>(read_points(path)); }));
  }

  TestFolder folder_;

 private:
  [[nodiscard]] std::string without_folder(const std::string& message) const {
    const std::string prefix = folder_.path("");
    return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
  }
};

constexpr std::size_t kDeep = 1'000'000;

TEST_F(HostileFiles, DeepListsAreNoPoints) {
  const std::string deep = repeated("[", kDeep) + repeated("]", kDeep);
  EXPECT_EQ(points_error("p.json", deep),
            "p.json: points[0] has an array for a coordinate; a point is {\"x\": 1, \"y\": 2} or [1, 2]");
  EXPECT_EQ(points_error("p.json", repeated("[", kDeep)),
            "p.json: points[0] has an array for a coordinate; a point is {\"x\": 1, \"y\": 2} or [1, 2]");
  EXPECT_TRUE(points_error("p.json", repeated("{\"a\":", kDeep)).starts_with("p.json:1: no valid JSON at "));
  EXPECT_EQ(points_error("p.json", "{\"meta\": " + deep + ", \"points\": [[0, 0], [1, 0], [0, 1]]}"), "");
}

TEST_F(HostileFiles, DeepGeoJsonIsRefused) {
  const std::string deep = repeated("[", kDeep) + repeated("]", kDeep);
  EXPECT_EQ(points_error("p.geojson", "{\"type\": \"MultiPoint\", \"coordinates\": [" + deep + "]}"),
            "p.geojson: point 0 of this GeoJSON is not two numbers: '[a list of 1]'");
  EXPECT_EQ(points_error("p.geojson", "{\"type\": \"MultiPoint\", \"coordinates\": [{\"a\": " + deep + "}]}"),
            "p.geojson: point 0 of this GeoJSON is not two numbers: an object");
  const std::string collections = repeated("{\"type\": \"GeometryCollection\", \"geometries\": [", 100'000) +
                                  "{\"type\": \"Point\", \"coordinates\": [1, 2]}" + repeated("]}", 100'000);
  EXPECT_EQ(points_error("p.geojson", collections), "p.geojson: GeoJSON collections are nested more than 100 deep");
}

TEST_F(HostileFiles, DeepSolutionsAreRefused) {
  const std::string deep = repeated("[", kDeep) + repeated("]", kDeep);
  EXPECT_EQ(solution_error("t.json", "[[0, 1, " + deep + "]]"),
            "t.json: entry 0 has a list of 1, which is not the index of a point");
  EXPECT_EQ(solution_error("t.json", deep), "t.json: entry 0 is neither [a, b, c] nor [a, b] nor {\"i\": a, \"j\": b}");
  EXPECT_EQ(solution_error("t.json", repeated("[", kDeep)), "t.json: no valid JSON");
}

TEST_F(HostileFiles, DeclaredCountsReserveNothing) {
  EXPECT_EQ(points_error("p.ply",
                         "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nproperty float "
                         "y\nend_header\n1 2\n"),
            "p.ply: ends before vertex 1 of 4000000000");
  EXPECT_EQ(points_error("p.ply",
                         "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float "
                         "x\nproperty float y\nend_header\n1234"),
            "p.ply: a PLY file that ends before its last vertex");
  EXPECT_EQ(points_error("p.off", "OFF\n4000000000 0 0\n0 0 0\n"), "p.off: ends before vertex 1 of 4000000000");
  EXPECT_NE(points_error("p.node", "4000000000 2 0 0\n1 0 0\n"), "");
  EXPECT_NE(points_error("p.tsp", "NAME: p\nDIMENSION: 4000000000\nNODE_COORD_SECTION\n1 0 0\n2 1 1\nEOF\n"), "");
  EXPECT_NE(solution_error("t.ele", "4000000000 3 0\n1 0 1 2\n"), "");
  EXPECT_NE(solution_error("t.ele", "1 3 0\n1 4294967296 1 2\n"), "") << "no index wraps around";
  std::string header = "{'descr': '<f8', 'fortran_order': False, 'shape': (1152921504606846977, 2), }\n";
  header.insert(0, 1, static_cast<char>(header.size()));
  header.insert(1, 1, '\0');
  EXPECT_EQ(points_error("p.npy", std::string("\x93NUMPY\x01\0", 8) + header + std::string(32, '\0')),
            "p.npy: this NumPy file is cut off");
}

TEST_F(HostileFiles, CompressedNothingDoesNotFillTheMemory) {
  const std::string nothing(std::size_t{300} << 20, ' ');
  std::string bomb(ZSTD_compressBound(nothing.size()), '\0');
  bomb.resize(ZSTD_compress(bomb.data(), bomb.size(), nothing.data(), nothing.size(), 1));
  ASSERT_LT(bomb.size(), 100'000U);
  EXPECT_EQ(points_error("p.txt.zst", bomb), "p.txt.zst: decompresses to more than 256 MB; decompress it yourself");
}

TEST_F(HostileFiles, DevicesAreRefusedAndPipesRead) {
  EXPECT_EQ(path_error("/dev/zero"), "/dev/zero: is a device; give a file, or - for standard input");
  EXPECT_EQ(path_error("/dev/urandom"), "/dev/urandom: is a device; give a file, or - for standard input");
  EXPECT_NE(path_error("/dev/null"), "");
  EXPECT_EQ(path_error(folder_.path("none.txt")), "none.txt: no such file; check the name");
  EXPECT_NE(path_error(folder_.path("")).find("is a folder"), std::string::npos);
  const std::string pipe = folder_.path("pipe.txt");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << "0 0\n1 0\n0 1\n"; });
  EXPECT_EQ(read_points(pipe).size(), 3U);
  writer.join();
}

TEST_F(HostileFiles, MarksAndLineEndsAreNoContent) {
  const std::vector<Point> expected{{0, 0}, {1, 0}, {0, 1}};
  const std::string utf16_little = std::string(
      "\xFF\xFE"
      "0\0 \0"
      "0\0\n\0"
      "1\0 \0"
      "0\0\n\0"
      "0\0 \0"
      "1\0",
      24);
  for (const std::string& content : {std::string("0 0\r\n1 0\r\n0 1\r\n"), std::string("0 0\r1 0\r0 1\r"),
                                     std::string("\xEF\xBB\xBF"
                                                 "0 0\n1 0\n0 1"),
                                     utf16_little})
    EXPECT_EQ(read_points(folder_.file("p.txt", content)), expected);
  for (const char* empty : {"", "\n\n", "\xEF\xBB\xBF", "# nothing\n", "\xFF\xFE"}) {
    for (const char* name : {"p.txt", "p.csv", "p.json", "p.tsp", "p.wkt", "p.off", "p.ply", "p.node", "p.npy"})
      EXPECT_TRUE(points_error(name, empty).starts_with(name)) << name << ": " << points_error(name, empty);
  }
  for (const char* number : {"nan", "inf", "-Infinity", "1e999", "NaN"})
    EXPECT_TRUE(points_error("p.txt", std::string("0 0\n1 ") + number + "\n0 1\n").starts_with("p.txt:2: ")) << number;
}

}  // namespace
}  // namespace mwt
