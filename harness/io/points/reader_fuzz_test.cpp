// Damaged files: a reader refuses them with one clear line, or loses and moves nothing that was not damaged.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "base/error.h"
#include "base/number_text.h"
#include "base/testing/test_folder.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text_file.h"
#include "harness/io/triangulation_file.h"

namespace mwt {
namespace {

using test::TestFolder;
using Random = std::mt19937_64;

constexpr std::size_t kRows = 5;

// A file of kRows rows, line by line; rows begin at line `first`.
struct Sample {
  std::vector<Point> (*parse)(const std::string& source, std::string_view text);
  std::vector<std::string> lines;
  std::size_t first;
};

const std::vector<Point> kFivePoints{{0, 0}, {10.5, -0.25}, {1e-3, 7}, {-4, 3e2}, {8, 8.125}};

std::string number(double value) { return number_text(value); }

std::vector<Point> parse_plain_table(const std::string& source, std::string_view text) {
  return parse_text_points(source, text);
}

std::vector<Sample> point_samples() {
  std::vector<Sample> samples = {{parse_plain_table, {}, 0},
                                 {parse_plain_table, {"x,y"}, 1},
                                 {parse_plain_table, {"name;x;y"}, 1},
                                 {parse_plain_table, {"site\tx\ty"}, 1},
                                 {parse_plain_table, {}, 0},
                                 {parse_tsplib_points, {"NAME: p", "DIMENSION: 5", "NODE_COORD_SECTION"}, 3},
                                 {parse_json_points, {"{\"points\": ["}, 1}};
  for (std::size_t i = 0; i < kRows; ++i) {
    const std::string x = number(kFivePoints[i].x), y = number(kFivePoints[i].y), id = std::to_string(i + 1);
    const std::array rows = {x + ' ' + y,
                             x + ',' + y,
                             "no " + id + ';' + x + ';' + y,
                             "no " + id + '\t' + x + '\t' + y,
                             id + ' ' + x + ' ' + y,
                             id + ' ' + x + ' ' + y,
                             "{\"x\": " + x + ", \"y\": " + y + (i + 1 < kRows ? "}," : "}")};
    for (std::size_t k = 0; k < samples.size(); ++k) samples[k].lines.push_back(rows[k]);
  }
  samples[5].lines.emplace_back("EOF");
  samples[6].lines.emplace_back("]}");
  return samples;
}

// What turns up in files, besides single characters of the file itself.
std::string nasty_piece(Random& random) {
  static const std::vector<std::string> pieces = {" ",
                                                  "\t",
                                                  ",",
                                                  ";",
                                                  "\r",
                                                  "#",
                                                  "\"",
                                                  "'",
                                                  "-",
                                                  "+",
                                                  ".",
                                                  "e",
                                                  "x",
                                                  "0",
                                                  "9",
                                                  "1e400",
                                                  "-1e-400",
                                                  "5e-324",
                                                  "nan",
                                                  "inf",
                                                  "0x1p3",
                                                  "1,234.5",
                                                  "0.1D+01",
                                                  "NA",
                                                  "\xE2\x88\x92",
                                                  "\xEF\xBB\xBF",
                                                  "\xC2\xA0",
                                                  "\xFF",
                                                  std::string(1, '\0'),
                                                  "(",
                                                  "]",
                                                  "{",
                                                  "}",
                                                  ":",
                                                  "EOF",
                                                  "_SECTION",
                                                  "sep=;",
                                                  "99999999999999999999",
                                                  "\x1A",
                                                  "\f",
                                                  "NODE_COORD_SECTION"};
  return pieces[random() % pieces.size()];
}

std::string damaged(std::string line, Random& random) {
  for (std::uint64_t count = 1 + random() % 2; count > 0; --count) {
    const std::size_t place = random() % (line.size() + 1);
    switch (random() % 5) {
      case 0: line.insert(place, nasty_piece(random)); break;
      case 1: line.replace(place, 1 + random() % 3, nasty_piece(random)); break;
      case 2: line.erase(place, 1 + random() % 4); break;
      case 3: line.insert(place, line.substr(random() % (line.size() + 1), 1 + random() % 6)); break;
      default: line = nasty_piece(random) + (random() % 2 == 0 ? line : nasty_piece(random));
    }
  }
  return line;
}

std::string joined(const std::vector<std::string>& lines, const std::string& line_end) {
  std::string text;
  for (const std::string& line : lines) text += line + line_end;
  return text;
}

// Whether the undamaged rows are there, at both ends. The damaged line may be some points or none.
bool keeps_undamaged(const std::vector<Point>& points, std::size_t before, std::size_t after) {
  return points.size() >= before + after &&
         std::equal(kFivePoints.begin(), kFivePoints.begin() + static_cast<std::ptrdiff_t>(before), points.begin()) &&
         std::equal(kFivePoints.rbegin(), kFivePoints.rbegin() + static_cast<std::ptrdiff_t>(after), points.rbegin());
}

// A header may come to name y first.
bool keeps_undamaged(std::vector<Point> points, const Sample& sample, std::size_t damaged_line) {
  if (damaged_line >= sample.first + kRows) return points == kFivePoints;
  if (damaged_line >= sample.first) {
    const std::size_t row = damaged_line - sample.first;
    return keeps_undamaged(points, row, kRows - row - 1);
  }
  if (keeps_undamaged(points, 0, kRows)) return true;
  for (Point& p : points) std::swap(p.x, p.y);
  return keeps_undamaged(points, 0, kRows);
}

std::vector<Point> read_sample(const Sample& sample, const std::string& text) {
  return sample.parse("p", as_plain_text(text, "p"));
}

void expect_one_clear_line(const std::string& message) {
  EXPECT_TRUE(message.starts_with("p:")) << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  EXPECT_LT(message.size(), 250U) << message;
}

void damage_point_files(std::uint64_t seed, int rounds) {
  Random random(seed);
  for (const Sample& sample : point_samples()) {
    int accepted = 0;
    for (int round = 0; round < rounds; ++round) {
      std::vector<std::string> lines = sample.lines;
      const std::size_t place = random() % lines.size();
      lines[place] = damaged(lines[place], random);
      const std::string text = joined(lines, random() % 2 == 0 ? "\n" : "\r\n");
      try {
        const std::vector<Point> points = read_sample(sample, text);
        ++accepted;
        EXPECT_TRUE(keeps_undamaged(points, sample, place)) << text;
        for (const Point& p : points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << text;
      } catch (const InputError& error) {
        expect_one_clear_line(error.what());
      }
    }
    EXPECT_GT(accepted, rounds / 20) << sample.lines[0];
  }
}

// Without its last bytes a file is refused, or read up to some row; a number may be cut, as nothing marks its end.
void truncate_point_files() {
  for (const Sample& sample : point_samples()) {
    const std::string whole = joined(sample.lines, "\n");
    for (std::size_t size = 0; size < whole.size(); ++size) {
      const std::string text = whole.substr(0, size);
      try {
        const std::vector<Point> points = read_sample(sample, text);
        ASSERT_LE(points.size(), kRows);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) EXPECT_EQ(points[i], kFivePoints[i]) << text;
      } catch (const InputError& error) {
        expect_one_clear_line(error.what());
      }
    }
  }
}

// A header may name the columns in another order.
std::vector<Triangle> with_sorted_corners(std::vector<Triangle> triangles) {
  for (Triangle& triangle : triangles) std::sort(triangle.begin(), triangle.end());
  return triangles;
}

void damage_triangle_files(std::uint64_t seed, int rounds) {
  Random random(seed);
  const TestFolder folder;
  const std::vector<std::string> whole = {"a,b,c", "0,1,2", "1,3,2", "2,3,4"};
  const std::vector<Triangle> triangles = {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::string> lines = whole;
    const std::size_t place = random() % lines.size();
    lines[place] = damaged(lines[place], random);
    const std::string text = joined(lines, "\n"), path = folder.file("t.csv", text);
    try {
      const std::vector<Triangle> read = with_sorted_corners(read_triangles(path));
      const std::size_t before = place - std::min<std::size_t>(place, 1), after = 3 - place;
      ASSERT_GE(read.size(), before + after) << text;
      EXPECT_TRUE(std::equal(triangles.begin(), triangles.begin() + static_cast<std::ptrdiff_t>(before), read.begin()));
      EXPECT_TRUE(
          std::equal(triangles.rbegin(), triangles.rbegin() + static_cast<std::ptrdiff_t>(after), read.rbegin()));
    } catch (const InputError& error) {
      const std::string message = error.what();
      ASSERT_TRUE(message.starts_with(path + ':')) << message;
      expect_one_clear_line("p" + message.substr(path.size()));
    }
  }
}

TEST(ReaderFuzz, DamagedPointFilesLoseNothingElse) { damage_point_files(1, 10000); }
TEST(ReaderFuzz, TruncatedPointFilesLoseOnlyTheirEnd) { truncate_point_files(); }
TEST(ReaderFuzz, DamagedTriangleFilesLoseNothingElse) { damage_triangle_files(2, 500); }

TEST(ReaderFuzzSlow, ManyDamagedFiles) {
  for (std::uint64_t seed = 10; seed < 20; ++seed) {
    damage_point_files(seed, 40000);
    damage_triangle_files(seed, 500);
  }
}

}  // namespace
}  // namespace mwt
